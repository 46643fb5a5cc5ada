#pragma once

// Assembly of cell matrices into a distributed matrix of the block, and what
// algebraic multigrid needs of it.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_space.hpp"
#include "fem/block/block_system.hpp"

#include <deal.II/base/table.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <functional>
#include <span>
#include <vector>

namespace asperity::fem {

/// Computes cell matrices of linear elasticity,
///
///     K_(a,i),(b,j) = C_ikjl int d_k phi_a d_l phi_b dV              (F.3)
///
/// for nodes a, b and directions i, j, with C of Hooke's law. They are
/// linear in the moduli, so the cache holds for each shape the matrix of
/// lambda = 1 Pa and that of mu = 1 Pa.
class CellMatrices {
public:
  explicit CellMatrices(const BlockSpace& space);

  /// The matrix of the cell. The reference is valid until the next call.
  const dealii::FullMatrix<double>&
  of(const dealii::DoFHandler<3>::active_cell_iterator& cell,
     const Moduli& moduli);

private:
  using Products = dealii::Table<2, dealii::Tensor<2, 3>>;

  struct Shape {
    std::vector<dealii::Tensor<1, 3>> edges; ///< from the first vertex [m]
    dealii::FullMatrix<double> of_lame, of_shear;
  };

  const Shape&
  shape_of(const dealii::DoFHandler<3>::active_cell_iterator& cell);
  Products integrate() const;
  dealii::FullMatrix<double> contract(const Products& products,
                                      const Moduli& moduli) const;

  dealii::FEValues<3> values_; ///< of a single component
  std::vector<std::pair<unsigned int, unsigned int>>
      component_and_node_; ///< of each unknown
  std::vector<Shape> shapes_;
  std::size_t oldest_ = 0;
  dealii::FullMatrix<double> matrix_;
};

/// The matrix of a cell, valid until the next call.
using MatrixOfCell = std::function<const dealii::FullMatrix<double>&(
    const dealii::DoFHandler<3>::active_cell_iterator&)>;

/// Sums one matrix per cell under the block's constraints. The sparsity pattern
/// reserves entries for springs at the contact points. This call is collective.
/// @param couples  which pairs of unknowns of a cell share an entry; empty for
///                 all
void assemble(const BlockSystem& system, const MatrixOfCell& matrix_of,
              const dealii::Table<2, bool>& couples,
              dealii::TrilinosWrappers::SparseMatrix& matrix);

/// Sets the rows and columns of unknowns of this rank to zero except for their
/// diagonal. This call is collective.
void hold(dealii::TrilinosWrappers::SparseMatrix& matrix,
          const BlockSpace& space,
          std::span<const dealii::types::global_dof_index> unknowns);

/// Memory of the matrices of a hierarchy on this rank, except for that of the
/// matrix it was set up for [bytes]; the hierarchy's own function does not
/// count them.
std::size_t
hierarchy_bytes(const dealii::TrilinosWrappers::PreconditionAMG& multigrid);

/// Nodes that stiff springs join to faces of another body, for algebraic
/// multigrid: the change of variables of mesh_contact.hpp for an assembled
/// matrix. With the relative displacement r of such a node, of stiffness K_r
/// without its spring k, in place of its u_z,
///
///     u = T (r, m),    u_z = sqrt(K_r / (K_r + k)) r + N m,          (F.7)
///
/// the matrix T^T (K + B^T diag(k) B) T has the diagonal of K at r and nearly
/// no coupling of r with m, the displacement of the face: a common motion of
/// both sides strains no spring, and the aggregates of multigrid represent it.
class JoinedNodes {
public:
  using Matrix = dealii::TrilinosWrappers::SparseMatrix;
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// Writes T^T (K + B^T diag(springs) B) T into `matrix`, or K with the
  /// springs if none is stiff. Collective.
  /// @param stiffness  K
  /// @param springs    of the contact points of this rank [N/m]
  void write(const BlockSystem& system, const Matrix& stiffness,
             std::span<const double> springs, Matrix& matrix);

  /// Removes the joined unknowns from the constant modes: a translation leaves
  /// r = 0.
  void clear_in(std::vector<std::vector<bool>>& modes) const;

  bool exist() const { return exist_; } ///< on any rank

  /// Computes to = T from, or with `is_transposed` to = T^T from.
  void multiply(Vector& to, const Vector& from, bool is_transposed) const;

  std::size_t bytes() const { return change_.memory_consumption(); }

private:
  using Unknown = dealii::types::global_dof_index;
  void find(const BlockSystem& system, const Matrix& stiffness,
            std::span<const double> springs);
  std::vector<double> set_change(const BlockSystem& system,
                                 const Matrix& stiffness,
                                 std::span<const double> springs);

  bool exist_ = false;
  std::vector<std::size_t> points_; ///< joined contact points of this rank
  std::vector<std::size_t> places_; ///< their unknowns among those of this rank
  Matrix change_;                   ///< T
};

} // namespace asperity::fem
