#pragma once

// Stress inside a solved block: at quadrature points, at vertices, and its
// maximum. This file is independent of output files and of the contact law.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <span>
#include <vector>

namespace asperity::fem {

/// The stress sigma [Pa], positive in tension, with z pointing into the first
/// body.
using StressTensor = dealii::SymmetricTensor<2, 3>;

/// The von Mises stress sqrt(3 J_2) = sqrt(3/2 s : s), where s is the deviator
/// of sigma [Pa] >= 0.
double von_mises(const StressTensor& stress);

/// The largest shear stress: half the difference of the largest and the
/// smallest principal stress [Pa] >= 0.
double largest_shear(const StressTensor& stress);

/// The stress of one displacement field. Every call except at_points is
/// collective.
///
/// In each cell, sigma is computed from the strain at the quadrature points
/// with which the stiffness was integrated. These values are projected onto
/// functions that are linear in the reference coordinates of the cell, by least
/// squares with the quadrature weights. The projections at a vertex are
/// averaged over the cells of one material around it, weighted by cell volume,
/// so the stress remains discontinuous where the moduli differ. Averages do not
/// extend across periodic sides.
class BlockStress {
public:
  using Cell = dealii::DoFHandler<3>::active_cell_iterator;

  /// A callback that receives the stress at the vertices of a cell, in
  /// deal.II's order.
  using TakeVertices =
      std::function<void(const Cell&, std::span<const StressTensor>)>;

  /// @param system        must outlive this object
  /// @param displacement  u over the owned unknowns [m]; its entries at
  ///                      constrained unknowns are not read
  BlockStress(const BlockSystem& system,
              const dealii::TrilinosWrappers::MPI::Vector& displacement);

  /// The displacement u at all unknowns of this rank's cells, including
  /// constrained ones [m].
  const dealii::TrilinosWrappers::MPI::Vector& displacement() const {
    return displacement_;
  }

  /// The stress sigma at the quadrature points of a cell that this rank owns or
  /// borders on. The reference is valid until the next call.
  const std::vector<StressTensor>& at_points(const Cell& cell);

  /// Calls `take` for each cell of this rank in deal.II's order.
  /// @param ratio  [1] >= 1; above 1, averages extend over all cells around the
  ///               vertex with the same nu whose E is within this ratio of that
  ///               of the cell. Their stress is scaled by the ratio of E: the
  ///               strain is averaged, which is continuous where E varies
  ///               smoothly, although each cell has a modulus of its own.
  void at_vertices(const TakeVertices& take, double ratio = 1.0);

  /// The largest von Mises stress at a quadrature point over all ranks. Ties
  /// are resolved by the smallest x, then y, then z. See StressPeak.
  StressPeak strongest();

private:
  /// Sum over the cells of one material around a vertex.
  struct Share {
    Moduli material;
    double volume = 0.0; ///< [m^3]
    /// Integral of sigma over the cells, from its value at the vertex [Pa m^3].
    StressTensor volume_stress;
  };

  using VertexShares = std::vector<std::vector<Share>>; ///< by vertex index

  VertexShares shares();
  static Share& share_of(std::vector<Share>& shares, const Moduli& material);
  static StressTensor average_of(std::span<const Share> shares,
                                 const Moduli& material, double ratio);

  const BlockSystem& system_;
  dealii::TrilinosWrappers::MPI::Vector displacement_;
  dealii::FEValues<3> values_;
  std::vector<StressTensor> stress_;
  dealii::FullMatrix<double> to_vertices_; ///< n_vertices x n_quadrature_points
};

} // namespace asperity::fem
