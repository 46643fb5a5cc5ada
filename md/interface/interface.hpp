#pragma once

// All pairs between the block's lowest layer and the rigid substrate. Owns the
// kernel: energy, forces, and the inspection that tells a wrong answer.

#include "base/grid.hpp"
#include "md/interface/interaction.hpp"
#include "md/interface/symmetric_block.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace asperity::md {

/// Where the atoms of a layer are, in three planes of grid.size() values each:
/// displacement in x and y from the lattice site, and height z over the mean
/// plane of the substrate [m]. The storage order of Grid.
struct LayerView {
  std::span<const double> x;
  std::span<const double> y;
  std::span<const double> z;
};

/// Forces on the layer's atoms [N], the same three planes.
struct LayerForces {
  std::span<double> x;
  std::span<double> y;
  std::span<double> z;
};

/// What a converged answer must not have: an atom that went through.
struct Inspection {
  int below_substrate = 0;        ///< atoms lower than the surface under them,
                                  ///< or at no finite place
  int close_pairs = 0;            ///< pairs nearer than the asked distance
  double shortest_distance = 0.0; ///< of any pair within the cut-off [m];
                                  ///< infinity if there is none
  int in_contact = 0;             ///< atoms with a pair nearer than d_c
};

/// Rigid substrate atoms at the nodes of `substrate` with `heights` over its
/// mean plane, block atoms at the nodes of `layer`: two periodic square
/// lattices over the same lengths, of any two spacings. An atom finds its
/// partners by an index window about its own position, so there is no list to
/// be out of date; displacements may be of any size.
class Interface {
public:
  /// @throws std::domain_error  lengths differ, or twice the cut-off is longer
  ///                            than the period; a bad interaction; a lattice
  ///                            that is not square; heights that are not finite
  Interface(const Interaction& interaction, const Grid& layer,
            const Grid& substrate, std::span<const double> heights,
            int threads = 1);
  ~Interface();
  Interface(Interface&&) noexcept;

  const Grid& layer() const;
  const Interaction& interaction() const;

  /// Overwrites `forces`. An atom at no finite place has NaN for a force, and
  /// so has the energy.
  /// @return  the energy of all pairs [J]
  /// @throws std::domain_error  planes of another size
  /// @par Accuracy  1e-12 of the largest force, and of the sum of |U|, against
  /// a
  ///                plain double loop; force = -grad U as exactly. The same
  ///                bits for any number of threads and, as nothing is fused and
  ///                lanes are summed in one order, on any x86-64 processor.
  double energy_and_forces(const LayerView& atoms,
                           const LayerForces& forces) const;

  /// Second derivatives of that energy with the place of each atom [N/m], one
  /// block an atom: the substrate is rigid, so atoms do not couple. Overwrites
  /// `blocks`; an atom at no finite place has NaN.
  /// @throws std::domain_error  planes or blocks of another size
  void second_derivatives(const LayerView& atoms,
                          std::span<SymmetricBlock> blocks) const;

  /// @param close_distance    [m], 2.2e-10 for the paper's atoms
  /// @param contact_distance  d_c [m]
  /// @throws std::domain_error  planes of another size, a distance beyond the
  ///                            cut-off
  Inspection inspect(const LayerView& atoms, double close_distance,
                     double contact_distance) const;

  /// Height of the (bilinearly interpolated) substrate under each atom [m].
  std::vector<double> heights_below(const LayerView& atoms) const;

private:
  struct Kernel;
  std::unique_ptr<Kernel> kernel_;
};

/// The periodic substrate lattice nearest to spacing a/phi, phi the golden
/// mean, with an even number of atoms: 648 for 400 (Sec. 4).
/// @throws std::domain_error  layer_atoms < 1
int incommensurate_atoms(int layer_atoms);

} // namespace asperity::md
