#include "fem/solution/face_maps.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace asperity::fem {
namespace {

using dealii::Point;
using dealii::types::global_dof_index;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr double inside = 1e-6; // in unit-cell widths and in node spacings

/// Weights of the nodes -1, 0, 1, 2 at the fraction t of the distance from
/// 0 to 1.
std::array<double, 4> cubic_weights(double t) {
  return {0.5 * t * (-1.0 + t * (2.0 - t)),
          1.0 + 0.5 * t * t * (-5.0 + 3.0 * t),
          0.5 * t * (1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * t * (t - 1.0)};
}

/// The place in a tetrahedron in units of the cell, which is affine. The
/// iteration of deal.II for it was seen to fail in cells of kilometres.
Point<3> unit_place(const dealii::DoFHandler<3>::active_cell_iterator& cell,
                    const Point<3>& place) {
  dealii::Tensor<2, 3> edges; // columns
  for (unsigned int edge = 0; edge < 3; ++edge)
    for (unsigned int axis = 0; axis < 3; ++axis)
      edges[axis][edge] = cell->vertex(edge + 1)[axis] - cell->vertex(0)[axis];
  return Point<3>(dealii::invert(edges) * (place - cell->vertex(0)));
}

/// The place of a node of the cell that is closer than the roundoff of the
/// inverse mapping, which would give the node a share of its neighbours' values
/// and make a contact of those beside it.
Point<3> at_node_if_close(Point<3> unit, unsigned int degree) {
  constexpr double roundoff = 1e-9;
  for (unsigned int axis = 0; axis < 3; ++axis) {
    const double node = std::round(unit[axis] * degree) / degree;
    if (std::abs(unit[axis] - node) < roundoff)
      unit[axis] = node;
  }
  return unit;
}

} // namespace

double interpolated(const Grid& grid, std::span<const double> field,
                    const Point<2>& place) {
  const double across = place[0] / grid.spacing_x();
  const double along = place[1] / grid.spacing_y();
  const int ix = static_cast<int>(std::floor(across));
  const int iy = static_cast<int>(std::floor(along));
  const std::array<double, 4> by_column = cubic_weights(across - ix);
  const std::array<double, 4> by_row = cubic_weights(along - iy);
  double value = 0.0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      value += by_row[static_cast<std::size_t>(j)] *
               by_column[static_cast<std::size_t>(i)] *
               field[grid.periodic_index(ix - 1 + i, iy - 1 + j)];
  return value;
}

FaceMaps::FaceMaps(const BlockSystem& system) : system_(system) {
  if (!system.contact().is_grid())
    find_samples();
}

/// Collects every grid node on each cell face of this rank that lies on the
/// contact surface.
void FaceMaps::find_samples() {
  const BlockSpace& space = system_.space();
  faces_a_node_.assign(system_.grid().size(), 0.0);
  for_contact_faces(
      space, [&](const auto& cell, unsigned int f) { sample_face(cell, f); });
  faces_a_node_ = summed(std::move(faces_a_node_));
  if (*std::min_element(faces_a_node_.begin(), faces_a_node_.end()) == 0.0)
    throw std::domain_error("the contact surface does not cover the grid");

  std::vector<global_dof_index> unknowns;
  for (const Sample& sample : samples_)
    for (const auto& entry : sample.row)
      unknowns.push_back(entry.first);
  std::sort(unknowns.begin(), unknowns.end());
  needed_ = space.owned();
  needed_.add_indices(unknowns.begin(), unknowns.end());
  needed_.compress();
}

void FaceMaps::sample_face(
    const dealii::DoFHandler<3>::active_cell_iterator& cell, unsigned int f) {
  const Grid& grid = system_.grid();
  const dealii::BoundingBox<3> box = cell->face(f)->bounding_box();
  const auto first = [&](unsigned int axis, double spacing) {
    return static_cast<int>(
        std::ceil(box.lower_bound(axis) / spacing - inside));
  };
  const auto last = [&](unsigned int axis, double spacing) {
    return static_cast<int>(
        std::floor(box.upper_bound(axis) / spacing + inside));
  };
  for (int iy = first(1, grid.spacing_y()); iy <= last(1, grid.spacing_y());
       ++iy)
    for (int ix = first(0, grid.spacing_x()); ix <= last(0, grid.spacing_x());
         ++ix)
      take_sample(cell, ix, iy);
}

/// Adds the node (ix, iy) if it lies on this cell.
void FaceMaps::take_sample(
    const dealii::DoFHandler<3>::active_cell_iterator& cell, int ix, int iy) {
  const Grid& grid = system_.grid();
  const BlockSpace& space = system_.space();
  const ContactPoints& points = system_.contact();
  const Point<3> place(ix * grid.spacing_x(), iy * grid.spacing_y(), 0.0);
  Point<3> unit;
  try {
    unit = cell->reference_cell().is_simplex()
               ? unit_place(cell, place)
               : space.mapping().transform_real_to_unit_cell(cell, place);
  } catch (const dealii::Mapping<3>::ExcTransformationFailed&) {
    return;
  }
  if (!cell->reference_cell().contains_point(unit, inside))
    return;
  Sample sample;
  sample.node = grid.periodic_index(ix, iy);
  sample.row =
      points.row_at(cell, at_node_if_close(unit, space.element().degree));
  faces_a_node_[sample.node] += 1.0;
  samples_.push_back(std::move(sample));
}

std::vector<double> FaceMaps::summed(std::vector<double> field) const {
  dealii::Utilities::MPI::sum(field, MPI_COMM_WORLD, field);
  return field;
}

std::vector<double>
FaceMaps::values_at(std::span<const double> field,
                    std::span<const Point<2>> places) const {
  std::vector<double> values;
  values.reserve(places.size());
  for (const Point<2>& place : places) {
    const int node = grid_node_at(system_.grid(), place[0], place[1]);
    values.push_back(node >= 0 ? field[static_cast<std::size_t>(node)]
                               : interpolated(system_.grid(), field, place));
  }
  return values;
}

std::vector<double> FaceMaps::at_points(std::span<const double> field) const {
  std::vector<Point<2>> places;
  for (std::size_t i = 0; i < system_.contact().size(); ++i)
    places.push_back(system_.contact()[i].place);
  return values_at(field, places);
}

std::vector<double> FaceMaps::displacement(const Vector& unknowns) const {
  const ContactPoints& points = system_.contact();
  std::vector<double> field(system_.grid().size(), 0.0);
  if (points.is_grid()) {
    std::vector<double> at_points;
    points.take_displacement(unknowns, at_points);
    for (std::size_t i = 0; i < points.size(); ++i)
      field[static_cast<std::size_t>(points[i].grid_node)] = at_points[i];
    return summed(std::move(field));
  }
  Vector ghosted(system_.space().owned(), needed_, MPI_COMM_WORLD);
  ghosted = unknowns;
  for (const Sample& sample : samples_)
    for (const auto& [unknown, value] : sample.row)
      field[sample.node] +=
          value * ghosted(unknown) / faces_a_node_[sample.node];
  return summed(std::move(field));
}

std::vector<double>
FaceMaps::pressure(std::span<const double> at_points) const {
  const ContactPoints& points = system_.contact();
  std::vector<double> field(system_.grid().size(), 0.0);
  if (points.is_grid()) {
    for (std::size_t i = 0; i < points.size(); ++i)
      field[static_cast<std::size_t>(points[i].grid_node)] = at_points[i];
    return summed(std::move(field));
  }
  Vector nodal = system_.space().make_vector();
  for (std::size_t i = 0; i < points.size(); ++i)
    nodal(points[i].row.front().first) = at_points[i];
  nodal.compress(dealii::VectorOperation::insert);
  field = displacement(nodal);
  for (double& pressure : field)
    pressure = std::max(0.0, pressure);
  return field;
}

std::vector<double> FaceMaps::weights() const {
  const ContactPoints& points = system_.contact();
  if (!points.is_grid())
    return std::vector<double>(system_.grid().size(), 1.0);
  const double mean =
      points.area() / static_cast<double>(system_.grid().size());
  std::vector<double> field(system_.grid().size(), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i)
    field[static_cast<std::size_t>(points[i].grid_node)] =
        points[i].area / mean;
  return summed(std::move(field));
}

} // namespace asperity::fem
