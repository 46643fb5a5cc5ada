#pragma once

// The interface between the lowest layer of the block and the rigid substrate.
// It computes the energy and the forces of all pairs, and checks whether a
// configuration is physically valid.

#include "base/grid.hpp"
#include "md/interface/interaction.hpp"
#include "md/interface/symmetric_block.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace asperity::md {

/// Positions of the atoms of a layer in three planes of grid.size() values
/// each, in the storage order of Grid: the displacements in x and y from the
/// lattice site, and the height z above the mean plane of the substrate [m].
struct LayerView {
  std::span<const double> x;
  std::span<const double> y;
  std::span<const double> z;
};

/// Forces on the atoms of the layer in three planes of the same layout [N].
struct LayerForces {
  std::span<double> x;
  std::span<double> y;
  std::span<double> z;
};

/// Result of Interface::inspect. A valid solution has no atom that has
/// penetrated the substrate.
struct Inspection {
  int below_substrate = 0;        ///< atoms below the surface, or with a
                                  ///< position that is not finite
  int close_pairs = 0;            ///< pairs closer than the given distance
  double shortest_distance = 0.0; ///< of all pairs within the cutoff [m];
                                  ///< infinity if there is none
  int in_contact = 0;             ///< atoms with a pair closer than d_c
};

/// Sum over all pairs of block atoms at the nodes of `layer` and rigid
/// substrate atoms at the nodes of `substrate` with `heights` above its mean
/// plane. Both are periodic square lattices with the same period but arbitrary
/// spacings. The neighbours of an atom are found by an index window around its
/// current position, so there is no neighbour list that could become outdated,
/// and displacements may be arbitrarily large.
class Interface {
public:
  /// @throws std::domain_error  the lengths differ, twice the cutoff exceeds
  ///                            the period, the interaction is invalid, a
  ///                            lattice is not square, or a height is not
  ///                            finite
  Interface(const Interaction& interaction, const Grid& layer,
            const Grid& substrate, std::span<const double> heights,
            int threads = 1);
  ~Interface();
  Interface(Interface&&) noexcept;

  const Grid& layer() const;
  const Interaction& interaction() const;

  /// Overwrites `forces`. If the position of an atom is not finite, its force
  /// and the total energy are NaN.
  /// @return  energy of all pairs [J]
  /// @throws std::domain_error  planes of a wrong size
  /// @par Accuracy  The error is 1e-12 of the largest force, and of the sum of
  ///                |U|, relative to a scalar double loop; force = -grad U
  ///                holds to the same accuracy. The result is bitwise identical
  ///                for any number of threads and on any x86-64 processor,
  ///                because no operations are fused and the SIMD lanes are
  ///                summed in a fixed order.
  double energy_and_forces(const LayerView& atoms,
                           const LayerForces& forces) const;

  /// Computes the second derivatives of this energy with respect to the
  /// position of each atom [N/m], one block per atom. The atoms do not couple
  /// because the substrate is rigid. Overwrites `blocks`; the block of an atom
  /// whose position is not finite is NaN.
  /// @throws std::domain_error  planes or blocks of a wrong size
  void second_derivatives(const LayerView& atoms,
                          std::span<SymmetricBlock> blocks) const;

  /// Counts penetrating, too close and contacting atoms.
  /// @param close_distance    [m], 2.2e-10 for the interaction of Yang and
  ///                          Persson (2008)
  /// @param contact_distance  d_c [m]
  /// @throws std::domain_error  planes of a wrong size, or a distance beyond
  ///                            the cutoff
  Inspection inspect(const LayerView& atoms, double close_distance,
                     double contact_distance) const;

  /// Returns the bilinearly interpolated height of the substrate below each
  /// atom [m].
  std::vector<double> heights_below(const LayerView& atoms) const;

private:
  struct Kernel;
  std::unique_ptr<Kernel> kernel_;
};

} // namespace asperity::md
