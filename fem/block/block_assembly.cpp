#include "fem/block/block_assembly.hpp"

#include "fem/material/hooke.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_Vector.h>
#include <algorithm>
#include <cmath>
#include <ml_MultiLevelPreconditioner.h>

namespace asperity::fem {
namespace {

using dealii::Tensor;

/// Capacity of the cache: at least the number of layers of a graded block. An
/// unstructured mesh fills the cache once.
constexpr std::size_t most_shapes = 128;

/// Relative tolerance for equal edges: those of congruent cells differ by the
/// roundoff of their coordinates.
constexpr double same_edge = 1e-11;

} // namespace

CellMatrices::CellMatrices(const BlockSpace& space)
    : values_(space.mapping(), space.element().base_element(0),
              space.cell_quadrature(),
              dealii::update_gradients | dealii::update_JxW_values),
      matrix_(space.element().n_dofs_per_cell()) {
  for (unsigned int i = 0; i < matrix_.m(); ++i)
    component_and_node_.push_back(space.element().system_to_component_index(i));
}

/// Integrals of d_k phi_a d_l phi_b [m].
CellMatrices::Products CellMatrices::integrate() const {
  Products products(values_.dofs_per_cell, values_.dofs_per_cell);
  for (const unsigned int q : values_.quadrature_point_indices())
    for (const unsigned int a : values_.dof_indices()) {
      const Tensor<1, 3> weighted = values_.shape_grad(a, q) * values_.JxW(q);
      for (const unsigned int b : values_.dof_indices())
        products(a, b) += outer_product(weighted, values_.shape_grad(b, q));
    }
  return products;
}

dealii::FullMatrix<double> CellMatrices::contract(const Products& products,
                                                  const Moduli& moduli) const {
  const auto symmetric = elastic_tangent(moduli);
  Tensor<4, 3> tangent; // C_ikjl at i, j, k, l
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int l = 0; l < 3; ++l)
          tangent[i][j][k][l] = symmetric[i][k][j][l];
  dealii::FullMatrix<double> matrix(component_and_node_.size());
  for (unsigned int row = 0; row < matrix.m(); ++row) {
    const auto [i, a] = component_and_node_[row];
    for (unsigned int column = 0; column < matrix.n(); ++column) {
      const auto [j, b] = component_and_node_[column];
      matrix(row, column) = scalar_product(tangent[i][j], products(a, b));
    }
  }
  return matrix;
}

const CellMatrices::Shape& CellMatrices::shape_of(
    const dealii::DoFHandler<3>::active_cell_iterator& cell) {
  std::vector<Tensor<1, 3>> edges;
  for (const unsigned int v : cell->vertex_indices())
    edges.push_back(cell->vertex(v) - cell->vertex(0));
  const double tolerance = same_edge * cell->diameter();
  const auto is_same = [&](const Shape& shape) {
    return std::equal(edges.begin(), edges.end(), shape.edges.begin(),
                      [&](const auto& a, const auto& b) {
                        return (a - b).norm() <= tolerance;
                      });
  };
  const auto found = std::find_if(shapes_.begin(), shapes_.end(), is_same);
  if (found != shapes_.end())
    return *found;
  // The cell is passed as a cell of the triangulation, because the DoFHandler's
  // element has three components.
  values_.reinit(dealii::Triangulation<3>::active_cell_iterator(cell));
  const Products products = integrate();
  Shape shape{std::move(edges), contract(products, {1.0, 0.0}),
              contract(products, {0.0, 1.0})};
  if (shapes_.size() < most_shapes) {
    shapes_.push_back(std::move(shape));
    return shapes_.back();
  }
  oldest_ = (oldest_ + 1) % most_shapes;
  return shapes_[oldest_] = std::move(shape);
}

const dealii::FullMatrix<double>&
CellMatrices::of(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                 const Moduli& moduli) {
  const Shape& shape = shape_of(cell);
  matrix_.equ(moduli.lame_modulus, shape.of_lame, moduli.shear_modulus,
              shape.of_shear);
  return matrix_;
}

namespace {

using dealii::types::global_dof_index;

/// The unknowns that this rank may write to: those of its cells, the master
/// unknowns of their constraints and those that its contact points need.
dealii::IndexSet writable(const BlockSystem& system) {
  const BlockSpace& space = system.space();
  std::vector<global_dof_index> roots;
  for (const auto& line : space.constraints().get_lines())
    for (const auto& entry : line.entries)
      if (!space.relevant().is_element(entry.first))
        roots.push_back(entry.first);
  std::sort(roots.begin(), roots.end());
  dealii::IndexSet set = space.relevant();
  set.add_indices(roots.begin(), roots.end());
  set.add_indices(system.contact().needed());
  set.compress();
  return set;
}

/// Sets the rows and columns of the flagged unknowns to zero except for the
/// diagonal.
void clear_rows_and_columns(
    dealii::TrilinosWrappers::SparseMatrix& matrix,
    const dealii::TrilinosWrappers::MPI::Vector& flags) {
  const Epetra_CrsMatrix& crs = matrix.trilinos_matrix();
  const Epetra_MultiVector& by_row = flags.trilinos_vector();
  Epetra_Vector by_column(crs.ColMap());
  if (crs.Importer() != nullptr)
    by_column.Import(*by_row(0), *crs.Importer(), Insert);
  else
    by_column.Update(1.0, *by_row(0), 0.0);
  for (int row = 0; row < crs.NumMyRows(); ++row) {
    const bool is_held = by_row[0][row] != 0.0;
    const int own_column = crs.LCID(crs.GRID(row));
    int n_entries = 0;
    double* values = nullptr;
    int* columns = nullptr;
    crs.ExtractMyRowView(row, n_entries, values, columns);
    for (int i = 0; i < n_entries; ++i)
      if (columns[i] != own_column && (is_held || by_column[columns[i]] != 0.0))
        values[i] = 0.0;
  }
}

} // namespace

void assemble(const BlockSystem& system, const MatrixOfCell& matrix_of,
              const dealii::Table<2, bool>& couples,
              dealii::TrilinosWrappers::SparseMatrix& matrix) {
  const BlockSpace& space = system.space();
  const auto for_own_cells = [&](const auto& take) {
    std::vector<global_dof_index> unknowns(space.element().n_dofs_per_cell());
    for (const auto& cell : space.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned()) {
        cell->get_dof_indices(unknowns);
        take(cell, unknowns);
      }
  };
  dealii::TrilinosWrappers::SparsityPattern pattern(
      space.owned(), space.owned(), writable(system), MPI_COMM_WORLD);
  for_own_cells([&](const auto&, const auto& unknowns) {
    space.constraints().add_entries_local_to_global(unknowns, pattern, false,
                                                    couples);
  });
  system.contact().reserve(pattern);
  pattern.compress();
  matrix.reinit(pattern);
  for_own_cells([&](const auto& cell, const auto& unknowns) {
    space.constraints().distribute_local_to_global(matrix_of(cell), unknowns,
                                                   matrix);
  });
  matrix.compress(dealii::VectorOperation::add);
}

void hold(dealii::TrilinosWrappers::SparseMatrix& matrix,
          const BlockSpace& space, std::span<const global_dof_index> unknowns) {
  dealii::TrilinosWrappers::MPI::Vector flags = space.make_vector();
  for (const auto unknown : unknowns)
    flags(unknown) = 1.0;
  flags.compress(dealii::VectorOperation::insert);
  if (flags.linfty_norm() > 0.0)
    clear_rows_and_columns(matrix, flags);
}

std::size_t
hierarchy_bytes(const dealii::TrilinosWrappers::PreconditionAMG& multigrid) {
  const auto* const own =
      dynamic_cast<const ML_Epetra::MultiLevelPreconditioner*>(
          &multigrid.trilinos_operator());
  if (own == nullptr || own->GetML() == nullptr)
    return 0;
  const ML& hierarchy = *own->GetML();
  std::size_t entries = 0;
  const auto add = [&](const ML_Operator& matrix) {
    entries += static_cast<std::size_t>(std::max(0, matrix.N_nonzeros));
  };
  for (int level = 0; level < hierarchy.ML_num_levels; ++level) {
    add(hierarchy.Pmat[level]);
    add(hierarchy.Rmat[level]);
    if (level != hierarchy.ML_finest_level)
      add(hierarchy.Amat[level]);
  }
  return entries * (sizeof(double) + sizeof(int));
}

void JoinedNodes::find(const BlockSystem& system, const Matrix& stiffness,
                       std::span<const double> springs) {
  // Springs that exceed the stiffness of their node by this factor join it.
  constexpr double stiff = 2.0;
  const ContactPoints& points = system.contact();
  const dealii::IndexSet& owned = system.space().owned();
  points_.clear();
  places_.clear();
  if (system.has_counter())
    for (std::size_t i = 0; i < springs.size(); ++i) {
      const Unknown node = points[i].row.front().first;
      if (owned.is_element(node) &&
          springs[i] > stiff * stiffness.diag_element(node)) {
        points_.push_back(i);
        places_.push_back(owned.index_within_set(node));
      }
    }
  exist_ =
      dealii::Utilities::MPI::max(points_.empty() ? 0 : 1, MPI_COMM_WORLD) == 1;
}

/// Sets T. Returns the share of each joined spring that is left on the
/// diagonal, K_r / (K_r + k).
std::vector<double> JoinedNodes::set_change(const BlockSystem& system,
                                            const Matrix& stiffness,
                                            std::span<const double> springs) {
  const ContactPoints& points = system.contact();
  const dealii::IndexSet& owned = system.space().owned();
  dealii::TrilinosWrappers::SparsityPattern pattern(owned, MPI_COMM_WORLD);
  for (const Unknown unknown : owned)
    pattern.add(unknown, unknown);
  for (const std::size_t point : points_)
    for (const auto& [unknown, value] : points[point].row)
      pattern.add(points[point].row.front().first, unknown);
  pattern.compress();
  change_.reinit(pattern);
  for (const Unknown unknown : owned)
    change_.set(unknown, unknown, 1.0);
  std::vector<double> kept;
  for (const std::size_t point : points_) {
    const FaceRow& row = points[point].row;
    const Unknown node = row.front().first;
    const double own = stiffness.diag_element(node);
    kept.push_back(own / (own + springs[point]));
    change_.set(node, node, std::sqrt(kept.back()));
    for (std::size_t entry = 1; entry < row.size(); ++entry)
      change_.set(node, row[entry].first, -row[entry].second);
  }
  change_.compress(dealii::VectorOperation::insert);
  return kept;
}

void JoinedNodes::write(const BlockSystem& system, const Matrix& stiffness,
                        std::span<const double> springs, Matrix& matrix) {
  find(system, stiffness, springs);
  const ContactPoints& points = system.contact();
  std::vector<double> others(springs.begin(), springs.end());
  for (const std::size_t point : points_)
    others[point] = 0.0;
  matrix.copy_from(stiffness);
  points.add_springs(others, matrix);
  if (!exist_)
    return;

  const std::vector<double> kept = set_change(system, stiffness, springs);
  Matrix product;
  matrix.mmult(product, change_);
  change_.Tmmult(matrix, product);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Unknown node = points[points_[i]].row.front().first;
    matrix.add(node, node, kept[i] * springs[points_[i]]);
  }
  matrix.compress(dealii::VectorOperation::add);
}

void JoinedNodes::clear_in(std::vector<std::vector<bool>>& modes) const {
  for (auto& mode : modes)
    for (const std::size_t place : places_)
      mode[place] = false;
}

void JoinedNodes::multiply(Vector& to, const Vector& from,
                           bool is_transposed) const {
  if (is_transposed)
    change_.Tvmult(to, from);
  else
    change_.vmult(to, from);
}

} // namespace asperity::fem
