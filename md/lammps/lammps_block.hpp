#pragma once

// The block as LAMMPS is told of it: which atom has which number, which bonds
// hold it, the law with the substrate. Owns the files that are the same for
// every load step.

#include "base/grid.hpp"
#include "md/contact/atomic_contact.hpp"
#include "md/interface/interaction.hpp"
#include "md/lattice/crystal.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace asperity::md {

/// x, y, z of every atom of the block [m] (forces: [N]), z over the mean plane
/// of the substrate. Atom (ix, iy) of layer k from below is at
/// k layer.size() + layer.index(ix, iy), and LAMMPS counts it from 1.
using BlockVectors = std::vector<std::array<double, 3>>;

/// `cells` layers of cells of the central crystal, so cells + 1 of atoms, the
/// uppermost of which stays flat; and the rigid atoms, which LAMMPS counts
/// after the block's.
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

  /// k = mu a, of every whole bond [N/m].
  double bond_stiffness() const;
};

/// LAMMPS' atom types.
enum class AtomType { lowest = 1, inner = 2, top = 3, substrate = 4 };

/// @throws cases::CaseError   the lattice is not central, or what only our own
///                            engine does
/// @throws std::domain_error  grids, heights or a modulus outside their range
LammpsBlock lammps_block(const AtomRequest& request);

/// The flat block, undeformed, its lowest layer at `height` [m].
BlockVectors undeformed(const LammpsBlock& block, double height);

/// Mean height of the lowest layer [m].
double mean_height(const LammpsBlock& block, const BlockVectors& positions);

/// RelaxationSettings::tolerance is compared with this: the norm of the forces
/// left over on all atoms, as if the lowest layer bore them alone, relative to
/// what the substrate does [1]. A mean over all layers would let a deep block
/// off too soon.
/// @param force_norm     root of the sum of squares of all components [N]
/// @param contact_force  sum over the lowest layer of |normal force| [N]
double residual(const LammpsBlock& block, double force_norm,
                double contact_force);

/// LAMMPS' data file: masses, bonds and all atoms, the block undeformed with
/// its lowest layer at `height` [m].
std::string data_file(const LammpsBlock& block, double height);

/// The section of pair_table() and the points it has.
inline constexpr const char* table_section = "ATOM_ON_SUBSTRATE";
inline constexpr int table_points = 20000;

/// pair_term() for LAMMPS' pair style table, even in r^2 up to the cut-off.
/// @par Accuracy  LAMMPS interpolates linearly in r^2: 2e-6 of the force at
///                r_0, less beyond.
std::string pair_table(const Interaction& interaction);

/// Positions of the block for LAMMPS' read_dump.
std::string positions_file(const LammpsBlock& block,
                           const BlockVectors& positions);

} // namespace asperity::md
