#pragma once

// The atoms of a load step as a picture: extended XYZ, which OVITO and ASE
// read. Owns the file's text.

#include "base/grid.hpp"
#include "md/lattice/multiscale_block.hpp"
#include "md/minimise/system.hpp"

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity::md {

/// Atoms that look alike.
struct AtomGroup {
  std::string species;                          ///< one word
  std::vector<std::array<double, 3>> positions; ///< [m]
  std::vector<double> pressures; ///< normal force an atom over a^2 [Pa]; empty:
                                 ///< none of them bears any
};

/// The rigid atoms, as "S".
AtomGroup substrate_atoms(const Grid& substrate,
                          std::span<const double> heights);

/// The lowest layer of any system, as "B".
/// @param pressures  one an atom of the layer [Pa]
AtomGroup contact_atoms(const System& system, std::span<const double> state,
                        std::span<const double> pressures);

/// All free layers of an explicit block over its lowest, as "B0", "B1", ... by
/// level.
std::vector<AtomGroup> inner_atoms(const MultiscaleBlock& block,
                                   std::span<const double> state);

/// Writes by base/atomic_file.hpp: the number of atoms, a line with the
/// periodic cell and the columns' meaning, then species, x, y, z [angstrom] and
/// pressure [GPa] an atom, to six decimals.
/// @param cell  its lengths are the periods in x and y
/// @throws std::domain_error  a group whose sizes differ
/// @throws std::system_error  naming the path
void write_atoms(const std::filesystem::path& path, const Grid& cell,
                 std::span<const AtomGroup> groups);

} // namespace asperity::md
