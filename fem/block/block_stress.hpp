#pragma once

// The stress inside a solved block: at quadrature points, at the vertices and
// where it is largest. Owns no file and no law of contact.
// Include from .cpp files of fem/ only.

#include "fem/block/block_system.hpp"

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <span>
#include <vector>

namespace asperity::fem {

/// sigma [Pa], tension positive, z into the first body.
using StressTensor = dealii::SymmetricTensor<2, 3>;

/// sqrt(3 J_2) = sqrt(3/2 s : s) with s the deviator of sigma [Pa] >= 0.
double von_mises(const StressTensor& stress);

/// Half the difference of the outermost principal stresses [Pa] >= 0.
double largest_shear(const StressTensor& stress);

/// The stress of one displacement. Every call but at_points is collective.
///
/// A cell has sigma at its quadrature points from the strain there, the points
/// that its stiffness was integrated with. In each cell they are projected in
/// the least squares of those points' weights on functions linear in its own
/// coordinates, and the values these take at a vertex are averaged over the
/// cells of one material around it, weighted by their volumes: where moduli
/// differ the stress keeps its jump. Averages do not reach across periodic
/// sides.
class BlockStress {
public:
  using Cell = dealii::DoFHandler<3>::active_cell_iterator;

  /// What takes the stress at the vertices of a cell, in deal.II's order.
  using TakeVertices =
      std::function<void(const Cell&, std::span<const StressTensor>)>;

  /// @param system        must outlive this
  /// @param displacement  u [m] over the owned unknowns; what it holds at
  ///                      constrained ones is not read
  BlockStress(const BlockSystem& system,
              const dealii::TrilinosWrappers::MPI::Vector& displacement);

  /// u [m] at all unknowns of this rank's cells, the constrained ones too.
  const dealii::TrilinosWrappers::MPI::Vector& displacement() const {
    return displacement_;
  }

  /// sigma at the quadrature points of a cell this rank owns or borders on,
  /// valid until the next call.
  const std::vector<StressTensor>& at_points(const Cell& cell);

  /// Calls `take` for each cell of this rank in deal.II's order.
  void at_vertices(const TakeVertices& take);

  /// The largest von Mises stress at a quadrature point of any rank; of equal
  /// ones that of the smallest x, then y, then z. See StressPeak.
  StressPeak strongest();

private:
  /// What the cells of one material around a vertex add up to.
  struct Share {
    Moduli material;
    double volume = 0.0;        ///< [m^3]
    StressTensor volume_stress; ///< integral of sigma, by the vertex [Pa m^3]
  };

  using VertexShares = std::vector<std::vector<Share>>; ///< by vertex index

  VertexShares shares();
  static Share& share_of(std::vector<Share>& shares, const Moduli& material);

  const BlockSystem& system_;
  dealii::TrilinosWrappers::MPI::Vector displacement_;
  dealii::FEValues<3> values_;
  std::vector<StressTensor> stress_;
  dealii::FullMatrix<double> to_vertices_; ///< vertices by quadrature points
};

} // namespace asperity::fem
