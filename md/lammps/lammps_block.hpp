#pragma once

// The block as represented in LAMMPS: the numbering of the atoms, the bonds and
// the pair potential with the substrate. It generates the files that are common
// to all load steps.

#include "base/grid.hpp"
#include "md/contact/atomic_contact.hpp"
#include "md/interface/interaction.hpp"
#include "md/lattice/crystal.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace asperity::md {

/// Positions x, y, z of every atom of the block [m], with z above the mean
/// plane of the substrate, or forces [N]. Atom (ix, iy) of layer k, counted
/// from the bottom, has the index k layer.size() + layer.index(ix, iy). LAMMPS
/// numbers the atoms from 1.
using BlockVectors = std::vector<std::array<double, 3>>;

/// The block consists of `cells` layers of cells of the central crystal, i.e.
/// cells + 1 layers of atoms, of which the uppermost stays flat. The rigid
/// atoms follow the block in the numbering of LAMMPS.
struct LammpsBlock {
  Crystal crystal;
  Interaction interaction;
  Grid layer;
  Grid substrate;
  std::vector<double> heights; ///< of the rigid atoms [m]
  int cells = 0;

  std::size_t atoms() const {
    return layer.size() * (static_cast<std::size_t>(cells) + 1);
  }

  /// Returns the stiffness k = mu a of a complete bond [N/m].
  double bond_stiffness() const;
};

/// Atom types in LAMMPS.
enum class AtomType { lowest = 1, inner = 2, top = 3, substrate = 4 };

/// Converts a request.
/// @throws input::InputError   the lattice is not central, or a setting is
///                             supported only by the built-in engine
/// @throws std::domain_error  grids, heights or a modulus outside their range
LammpsBlock lammps_block(const AtomRequest& request);

/// Returns the positions of the flat, undeformed block with its lowest layer at
/// `height` [m].
BlockVectors undeformed(const LammpsBlock& block, double height);

/// Returns the mean height of the lowest layer [m].
double mean_height(const LammpsBlock& block, const BlockVectors& positions);

/// Returns the residual that is compared with RelaxationSettings::tolerance:
/// the norm of the residual forces on all atoms, attributed to the lowest layer
/// alone, relative to the contact force [1]. A mean over all layers would
/// accept a deep block too early.
/// @param force_norm     root of the sum of squares of all components [N]
/// @param contact_force  sum over the lowest layer of |normal force| [N]
double residual(const LammpsBlock& block, double force_norm,
                double contact_force);

/// Returns the data file of LAMMPS with masses, bonds and all atoms. The block
/// is undeformed, with its lowest layer at `height` [m].
std::string data_file(const LammpsBlock& block, double height);

/// Section name and number of points of pair_table().
inline constexpr const char* table_section = "ATOM_ON_SUBSTRATE";
inline constexpr int table_points = 20000;

/// Returns pair_term() as a table for the LAMMPS pair style `table`,
/// equidistant in r^2 up to the cutoff.
/// @par Accuracy  LAMMPS interpolates linearly in r^2. The error is 2e-6 of the
///                force at r_0 and smaller beyond.
std::string pair_table(const Interaction& interaction);

/// Returns the positions of the block in the format of the LAMMPS command
/// read_dump.
std::string positions_file(const LammpsBlock& block,
                           const BlockVectors& positions);

} // namespace asperity::md
