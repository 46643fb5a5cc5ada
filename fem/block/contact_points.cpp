#include "fem/block/contact_points.hpp"

#include "fem/block/all_ranks.hpp"
#include "fem/block/block_triangulation.hpp"
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

/// How far a place may lie outside of a face that it is attributed to, in the
/// coordinates of the face: places on the border of the body belong to it.
constexpr double border = 1e-6;

/// The functions of degree 1 or 2 of one coordinate at its nodes 0, 1 or 0,
/// 1/2, 1.
std::array<double, 3> lagrange(unsigned int degree, double at) {
  if (degree == 1)
    return {1.0 - at, at, 0.0};
  return {(1.0 - at) * (1.0 - 2.0 * at), 4.0 * at * (1.0 - at),
          at * (2.0 * at - 1.0)};
}

/// How far coordinates lie outside of the unit square.
double excess(const Point<2>& unit) {
  return std::max({-unit[0], unit[0] - 1.0, -unit[1], unit[1] - 1.0});
}

} // namespace

CounterFaces::CounterFaces(const BlockSpace& space)
    : degree_(space.element().degree) {
  gather(space);
  sort_into_boxes();
}

/// Appends the corners of a face as eight numbers, and the numbers of u_z at
/// its nodes, -1 where it is held. The face f is that of the unit cube where
/// axis f/2 is f mod 2.
void CounterFaces::append_face(
    const BlockSpace& space,
    const dealii::DoFHandler<3>::active_cell_iterator& cell, unsigned int f,
    std::vector<double>& numbers) {
  const auto& element = space.element();
  const auto& support = element.get_unit_support_points();
  const unsigned int degree = element.degree;
  const unsigned int axis = f / 2;
  const unsigned int first = axis == 0 ? 1U : 0U;
  const unsigned int second = axis == 2 ? 1U : 2U;
  for (unsigned int corner = 0; corner < 4; ++corner) {
    const unsigned int v =
        (f % 2 << axis) + (corner % 2 << first) + (corner / 2 << second);
    const Point<3> place = cell->vertex(v);
    numbers.insert(numbers.end(), {place[0], place[1]});
  }
  std::vector<global_dof_index> unknowns(support.size());
  cell->get_dof_indices(unknowns);
  const std::size_t start = numbers.size();
  numbers.resize(start + std::size_t{degree + 1} * (degree + 1), -1.0);
  for (unsigned int i = 0; i < support.size(); ++i) {
    const Point<3> unit = support[i];
    if (element.system_to_component_index(i).first != 2 ||
        unit[axis] != static_cast<double>(f % 2) ||
        space.constraints().is_constrained(unknowns[i]))
      continue;
    const auto node =
        std::lround(unit[first] * degree) +
        std::lround(unit[second] * degree) * static_cast<long>(degree + 1);
    numbers.at(start + static_cast<std::size_t>(node)) =
        static_cast<double>(unknowns[i]);
  }
}

void CounterFaces::gather(const BlockSpace& space) {
  const std::size_t n_nodes = std::size_t{degree_ + 1} * (degree_ + 1);
  std::vector<double> mine;
  for (const auto& cell : space.dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned() || cell->center()[2] > 0.0)
      continue;
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() &&
          cell->face(f)->boundary_id() ==
              boundary_of(meshes::FaceGroup::contact))
        append_face(space, cell, f, mine);
  }
  const std::vector<double> all = of_all_ranks(mine);
  for (std::size_t i = 0; i < all.size(); i += 8 + n_nodes) {
    Face& face = faces_.emplace_back();
    for (std::size_t corner = 0; corner < 4; ++corner)
      face.corners[corner] =
          Point<2>(all[i + 2 * corner], all[i + 2 * corner + 1]);
    for (std::size_t node = 0; node < n_nodes; ++node) {
      const double number = all[i + 8 + node];
      face.unknowns.push_back(
          number < 0.0 ? nobody : static_cast<global_dof_index>(number));
    }
  }
  if (faces_.empty())
    throw std::domain_error(
        "the counter-body has no face in the group contact");
}

void CounterFaces::sort_into_boxes() {
  Point<2> low = faces_.front().corners[0];
  Point<2> high = low;
  for (const Face& face : faces_)
    for (const Point<2>& corner : face.corners)
      for (unsigned int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], corner[axis]);
        high[axis] = std::max(high[axis], corner[axis]);
      }
  corner_ = low;
  // About one face per box.
  const double n_along = std::ceil(std::sqrt(faces_.size()));
  box_ = std::max(high[0] - low[0], high[1] - low[1]) / n_along;
  for (unsigned int axis = 0; axis < 2; ++axis)
    n_boxes_[axis] =
        1 + static_cast<int>(std::floor((high[axis] - low[axis]) / box_));
  in_box_.resize(static_cast<std::size_t>(n_boxes_[0]) *
                 static_cast<std::size_t>(n_boxes_[1]));
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    Point<2> first = faces_[i].corners[0];
    Point<2> last = first;
    for (const Point<2>& corner : faces_[i].corners)
      for (unsigned int axis = 0; axis < 2; ++axis) {
        first[axis] = std::min(first[axis], corner[axis] - border * box_);
        last[axis] = std::max(last[axis], corner[axis] + border * box_);
      }
    const auto from = box_of(first);
    const auto to = box_of(last);
    for (int iy = from[1]; iy <= to[1]; ++iy)
      for (int ix = from[0]; ix <= to[0]; ++ix)
        in_box_[number_of({ix, iy})].push_back(i);
  }
}

/// The box around a place, or the nearest one.
std::array<int, 2> CounterFaces::box_of(const Point<2>& place) const {
  std::array<int, 2> box{};
  for (unsigned int axis = 0; axis < 2; ++axis)
    box[axis] = static_cast<int>(
        std::clamp(std::floor((place[axis] - corner_[axis]) / box_), 0.0,
                   static_cast<double>(n_boxes_[axis] - 1)));
  return box;
}

/// The coordinates of a place in the projection of a face, by Newton's method
/// for the bilinear map of its corners; empty if that does not converge.
std::optional<Point<2>> CounterFaces::coordinates_in(const Face& face,
                                                     const Point<2>& place) {
  const auto& c = face.corners;
  const auto twist = c[0] - c[1] - c[2] + c[3];
  Point<2> unit(0.5, 0.5);
  constexpr int most_steps = 30;
  constexpr double small = 1e-12;
  for (int step = 0; step < most_steps; ++step) {
    const auto along = (c[1] - c[0]) + twist * unit[1];
    const auto across = (c[2] - c[0]) + twist * unit[0];
    const auto missing =
        place - (c[0] + (c[1] - c[0]) * unit[0] + (c[2] - c[0]) * unit[1] +
                 twist * (unit[0] * unit[1]));
    const double determinant = along[0] * across[1] - along[1] * across[0];
    const dealii::Tensor<1, 2> change(
        {(missing[0] * across[1] - missing[1] * across[0]) / determinant,
         (along[0] * missing[1] - along[1] * missing[0]) / determinant});
    if (!std::isfinite(change.norm()))
      return std::nullopt;
    unit += change;
    if (change.norm() < small)
      return unit;
  }
  return std::nullopt;
}

std::optional<FaceRow> CounterFaces::row_at(const Point<2>& place) const {
  const Face* found = nullptr;
  Point<2> at;
  double least = border;
  for (const std::size_t i : in_box_[number_of(box_of(place))])
    if (const auto unit = coordinates_in(faces_[i], place);
        unit && excess(*unit) < least) {
      found = &faces_[i];
      at = *unit;
      least = excess(at);
    }
  if (found == nullptr)
    return std::nullopt;
  const auto along = lagrange(degree_, at[0]);
  const auto across = lagrange(degree_, at[1]);
  FaceRow row;
  constexpr double roundoff = 1e-14;
  for (std::size_t node = 0; node < found->unknowns.size(); ++node) {
    const double value =
        along[node % (degree_ + 1)] * across[node / (degree_ + 1)];
    if (found->unknowns[node] != nobody && std::abs(value) > roundoff)
      row.emplace_back(found->unknowns[node], value);
  }
  return row;
}

namespace {

using dealii::Point;
using dealii::types::global_dof_index;
using dealii::Utilities::MPI::sum;
using meshes::FaceGroup;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr double same_place = 1e-6; // in node spacings

} // namespace

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
    : space_(space), has_counter_(problem.counter.has_value()) {
  if (problem.counter_mesh)
    counter_.emplace(space);
  else if (has_counter_)
    find_counter();
  take_nodes(problem.grid);
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
        "a node of the contact surface has no area (the vertices of "
        "second-order tetrahedra have none); choose element = Q1");
  sum(count, MPI_COMM_WORLD, count);
  is_grid_ =
      n_points == grid.size() && std::all_of(count.begin(), count.end(),
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
