#pragma once

// The output of atomic configurations in the extended XYZ format, which OVITO
// and ASE read.

#include "base/grid.hpp"
#include "md/lattice/multiscale_block.hpp"
#include "md/minimise/system.hpp"

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity::md {

/// Atoms of one species.
struct AtomGroup {
  std::string species;                          ///< one word
  std::vector<std::array<double, 3>> positions; ///< [m]
  std::vector<double> pressures; ///< normal force per atom divided by a^2 [Pa];
                                 ///< empty: all zero
};

/// Returns the rigid atoms, of species "S".
AtomGroup substrate_atoms(const Grid& substrate,
                          std::span<const double> heights);

/// Returns the lowest layer of any system, of species "B".
/// @param pressures  one value per atom of the layer [Pa]
AtomGroup contact_atoms(const System& system, std::span<const double> state,
                        std::span<const double> pressures);

/// Returns all free layers of an explicit block above its lowest one. The
/// species are "B0", "B1", ... by level.
std::vector<AtomGroup> inner_atoms(const MultiscaleBlock& block,
                                   std::span<const double> state);

/// Writes the atoms through base/atomic_file.hpp: the number of atoms, a line
/// with the periodic cell and the meaning of the columns, and for each atom the
/// species, x, y, z [angstrom] and pressure [GPa] with six decimals.
/// @param cell  its lengths are the periods in x and y
/// @throws std::domain_error  the sizes within a group differ
/// @throws std::system_error  naming the path
void write_atoms(const std::filesystem::path& path, const Grid& cell,
                 std::span<const AtomGroup> groups);

} // namespace asperity::md
