#include "fem/block/contact_points.hpp"

#include "fem/block/all_ranks.hpp"
#include "fem/block/place_map.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace asperity::fem {
namespace {

using dealii::Point;
using dealii::types::global_dof_index;
using dealii::Utilities::MPI::sum;
using meshes::FaceGroup;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr double same_place = 1e-6; // in node spacings

} // namespace

void for_gauss_points(
    const BlockSpace& space, const dealii::Quadrature<2>& quadrature,
    const std::function<void(const dealii::FEFaceValues<3>&, unsigned int,
                             const FaceRow&)>& visit) {
  dealii::FEFaceValues<3> values(space.mapping(), space.element(), quadrature,
                                 dealii::update_quadrature_points |
                                     dealii::update_JxW_values |
                                     dealii::update_values);
  const dealii::FEValuesExtractors::Scalar vertical(2);
  std::vector<global_dof_index> unknowns(space.element().n_dofs_per_cell());
  for_contact_faces(space, [&](const auto& cell, unsigned int f) {
    values.reinit(cell, f);
    cell->get_dof_indices(unknowns);
    for (const unsigned int q : values.quadrature_point_indices()) {
      FaceRow row;
      for (const unsigned int i : values.dof_indices())
        if (const double value = values[vertical].value(i, q);
            std::abs(value) > 1e-14)
          row.emplace_back(unknowns[i], value);
      visit(values, q, space.resolved(row));
    }
  });
}

int grid_node_at(const Grid& grid, double x, double y) {
  const double across = x / grid.spacing_x();
  const double along = y / grid.spacing_y();
  const long ix = std::lround(across);
  const long iy = std::lround(along);
  if (std::abs(across - static_cast<double>(ix)) > same_place ||
      std::abs(along - static_cast<double>(iy)) > same_place)
    return -1;
  return static_cast<int>(grid.index(static_cast<int>(ix) % grid.points_x,
                                     static_cast<int>(iy) % grid.points_y));
}

ContactPoints::ContactPoints(const BlockSpace& space,
                             const BlockProblem& problem)
    : space_(space),
      is_nodal_(problem.contact_at == mechanics::ContactPoints::nodes),
      has_counter_(problem.counter.has_value()) {
  if (problem.counter_mesh)
    counter_.emplace(space);
  else if (has_counter_)
    find_counter();
  if (is_nodal_)
    take_nodes(problem.grid);
  else
    take_gauss_points(problem.grid);
  finish(problem.grid);
}

/// Finds the pairs of opposite nodes. Both contact surfaces have the same mesh,
/// so each node has a partner; all ranks know all pairs.
void ContactPoints::find_counter() {
  std::vector<double> mine;
  for (const FaceNode& node : space_.face_nodes(FaceGroup::contact))
    if (space_.owned().is_element(node.unknowns[2]) &&
        !space_.constraints().is_constrained(node.unknowns[2]))
      mine.insert(mine.end(),
                  {node.place[0], node.place[1], node.is_counter ? 1.0 : 0.0,
                   static_cast<double>(node.unknowns[2])});
  const std::vector<double> all = of_all_ranks(mine);
  PlaceMap first(space_.coordinate_tolerance());
  for (std::size_t i = 0; i < all.size(); i += 4)
    if (all[i + 2] == 0.0)
      first.insert(Point<3>(all[i], all[i + 1], 0.0),
                   static_cast<std::size_t>(all[i + 3]));
  for (std::size_t i = 0; i < all.size(); i += 4)
    if (all[i + 2] != 0.0)
      if (const auto partner = first.find(Point<3>(all[i], all[i + 1], 0.0)))
        opposite_[static_cast<global_dof_index>(*partner)] =
            static_cast<global_dof_index>(all[i + 3]);
}

bool ContactPoints::add_counter(const Point<2>& place, FaceRow& row) const {
  if (counter_) {
    const std::optional<FaceRow> counter = counter_->row_at(place);
    if (counter)
      for (const auto& [unknown, value] : *counter)
        row.emplace_back(unknown, -value);
    return counter.has_value();
  }
  const std::size_t own = has_counter_ ? row.size() : 0;
  for (std::size_t i = 0; i < own; ++i)
    row.emplace_back(opposite_.at(row[i].first), -row[i].second);
  return true;
}

void ContactPoints::add_point(const Grid& grid, const Point<2>& place,
                              double area, FaceRow row) {
  const bool is_opposed = add_counter(place, row);
  points_.push_back({place, area, std::move(row),
                     grid_node_at(grid, place[0], place[1]), is_opposed});
}

FaceRow
ContactPoints::row_at(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                      const Point<3>& unit) const {
  const dealii::FESystem<3>& element = space_.element();
  std::vector<global_dof_index> unknowns(element.n_dofs_per_cell());
  cell->get_dof_indices(unknowns);
  // Functions that vanish at the place, or whose shares in hanging nodes cancel
  // there, have values of roundoff.
  const auto is_roundoff = [](double value) { return std::abs(value) < 1e-14; };
  FaceRow row;
  for (unsigned int i = 0; i < unknowns.size(); ++i) {
    if (element.system_to_component_index(i).first != 2)
      continue;
    const double value = element.shape_value(i, unit);
    if (!is_roundoff(value))
      row.emplace_back(unknowns[i], value);
  }
  row = space_.resolved(row);
  std::erase_if(row,
                [&](const auto& entry) { return is_roundoff(entry.second); });
  const Point<3> place =
      space_.mapping().transform_unit_to_real_cell(cell, unit);
  add_counter(Point<2>(place[0], place[1]), row);
  return row;
}

std::size_t ContactPoints::nearest_on_face(std::size_t first,
                                           const Point<2>& place) const {
  const std::size_t end = first + space_.face_quadrature().size();
  std::size_t nearest = first;
  for (std::size_t i = first + 1; i < end; ++i)
    if (points_[i].place.distance(place) <
        points_[nearest].place.distance(place))
      nearest = i;
  return nearest;
}

void ContactPoints::take_nodes(const Grid& grid) {
  Vector areas = space_.make_vector();
  dealii::FEFaceValues<3> values(
      space_.mapping(), space_.element(), space_.face_quadrature(),
      dealii::update_values | dealii::update_JxW_values);
  const dealii::FEValuesExtractors::Scalar vertical(2);
  dealii::Vector<double> cell_load(space_.element().n_dofs_per_cell());
  std::vector<global_dof_index> unknowns(cell_load.size());
  for_contact_faces(space_, [&](const auto& cell, unsigned int f) {
    values.reinit(cell, f);
    cell_load = 0.0;
    for (const unsigned int q : values.quadrature_point_indices())
      for (const unsigned int i : values.dof_indices())
        cell_load(i) += values[vertical].value(i, q) * values.JxW(q);
    cell->get_dof_indices(unknowns);
    space_.constraints().distribute_local_to_global(cell_load, unknowns, areas);
  });
  areas.compress(dealii::VectorOperation::add);
  for (const FaceNode& node : space_.face_nodes(FaceGroup::contact)) {
    const global_dof_index unknown = node.unknowns[2];
    if (node.is_counter || !space_.owned().is_element(unknown) ||
        space_.constraints().is_constrained(unknown))
      continue;
    add_point(grid, Point<2>(node.place[0], node.place[1]), areas(unknown),
              {{unknown, 1.0}});
  }
}

void ContactPoints::take_gauss_points(const Grid& grid) {
  for_gauss_points(space_, space_.face_quadrature(),
                   [&](const auto& values, unsigned int q, const FaceRow& row) {
                     const Point<3> place = values.quadrature_point(q);
                     add_point(grid, Point<2>(place[0], place[1]),
                               values.JxW(q), row);
                   });
}

void ContactPoints::finish(const Grid& grid) {
  double own_area = 0.0;
  double smallest = 1e300;
  std::vector<double> count(grid.size(), 0.0);
  for (const ContactPoint& point : points_) {
    own_area += point.area;
    smallest = std::min(smallest, point.area);
    if (point.grid_node >= 0)
      count[static_cast<std::size_t>(point.grid_node)] += 1.0;
  }
  area_ = sum(own_area, MPI_COMM_WORLD);
  const std::size_t n_points = sum(points_.size(), MPI_COMM_WORLD);
  if (n_points == 0)
    throw std::domain_error("the mesh has no face in the group contact");
  const auto n_opposed = static_cast<std::size_t>(
      std::ranges::count_if(points_, &ContactPoint::is_opposed));
  if (sum(n_opposed, MPI_COMM_WORLD) == 0)
    throw std::domain_error("no point of the contact surface faces the "
                            "counter-body: its cells are too coarse for a body "
                            "of that size, or the body lies beside the block");
  smallest = dealii::Utilities::MPI::min(smallest, MPI_COMM_WORLD);
  if (smallest <= 1e-9 * area_ / static_cast<double>(n_points))
    throw std::domain_error(
        "contact_at = nodes: a node of the contact surface has no area (the "
        "vertices of second-order tetrahedra have none); choose gauss");
  sum(count, MPI_COMM_WORLD, count);
  is_grid_ = is_nodal_ && n_points == grid.size() &&
             std::all_of(count.begin(), count.end(),
                         [](double n) { return n == 1.0; });
  find_needed();
}

void ContactPoints::find_needed() {
  std::vector<global_dof_index> of_others;
  const auto take = [&](const FaceRow& row) {
    for (const auto& entry : row)
      if (!space_.owned().is_element(entry.first))
        of_others.push_back(entry.first);
  };
  for (const ContactPoint& point : points_)
    take(point.row);
  for (const FaceRow& row : others_)
    take(row);
  std::sort(of_others.begin(), of_others.end());
  needed_ = space_.owned();
  needed_.add_indices(of_others.begin(), of_others.end());
  needed_.compress();
  ghosted_.reinit(space_.owned(), needed_, MPI_COMM_WORLD);
}

void ContactPoints::also_reserve(std::vector<FaceRow> rows) {
  others_ = std::move(rows);
  find_needed();
}

void ContactPoints::take_displacement(const Vector& unknowns,
                                      std::vector<double>& at_points) const {
  ghosted_ = unknowns;
  at_points.assign(points_.size(), 0.0);
  for (std::size_t i = 0; i < points_.size(); ++i)
    for (const auto& [unknown, value] : points_[i].row)
      at_points[i] += value * ghosted_(unknown);
}

void ContactPoints::add_force(std::span<const double> forces,
                              Vector& unknowns) const {
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (forces[i] != 0.0)
      for (const auto& [unknown, value] : points_[i].row)
        unknowns(unknown) += value * forces[i];
  unknowns.compress(dealii::VectorOperation::add);
}

void ContactPoints::add_springs(
    std::span<const double> springs,
    dealii::TrilinosWrappers::SparseMatrix& matrix) const {
  for (std::size_t k = 0; k < points_.size(); ++k)
    if (springs[k] != 0.0)
      for (const auto& [i, value_i] : points_[k].row)
        for (const auto& [j, value_j] : points_[k].row)
          matrix.add(i, j, springs[k] * value_i * value_j);
  matrix.compress(dealii::VectorOperation::add);
}

void ContactPoints::reserve(
    dealii::TrilinosWrappers::SparsityPattern& pattern) const {
  for (const ContactPoint& point : points_)
    for (const auto& row : point.row)
      for (const auto& column : point.row)
        pattern.add(row.first, column.first);
  for (const FaceRow& others : others_)
    for (const auto& row : others)
      for (const auto& column : others)
        pattern.add(row.first, column.first);
}

} // namespace asperity::fem
