#include "fem/block/face_maps.hpp"

#include "fem/block/block_triangulation.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace asperity::fem {
namespace {

using dealii::Point;
using dealii::types::global_dof_index;
using meshes::FaceGroup;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr double inside = 1e-6; // in unit-cell widths and in node spacings

/// Weights of the nodes -1, 0, 1, 2 at the fraction t of the distance from
/// 0 to 1.
std::array<double, 4> cubic_weights(double t) {
  return {0.5 * t * (-1.0 + t * (2.0 - t)),
          1.0 + 0.5 * t * t * (-5.0 + 3.0 * t),
          0.5 * t * (1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * t * (t - 1.0)};
}

int wrapped(int i, int n) {
  return ((i % n) + n) % n;
}

} // namespace

double bicubic(const Grid& grid, std::span<const double> field, double x,
               double y) {
  const double across = x / grid.spacing_x();
  const double along = y / grid.spacing_y();
  const int ix = static_cast<int>(std::floor(across));
  const int iy = static_cast<int>(std::floor(along));
  const std::array<double, 4> by_column = cubic_weights(across - ix);
  const std::array<double, 4> by_row = cubic_weights(along - iy);
  double value = 0.0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      value += by_row[static_cast<std::size_t>(j)] *
               by_column[static_cast<std::size_t>(i)] *
               field[grid.index(wrapped(ix - 1 + i, grid.points_x),
                                wrapped(iy - 1 + j, grid.points_y))];
  return value;
}

FaceMaps::FaceMaps(const BlockSystem& system) : system_(system) {
  if (!system.contact().is_grid())
    find_samples();
}

/// Collects every grid node on each cell face of this rank that lies on the
/// contact surface. Faces are visited in the order in which the Gauss points
/// were generated.
void FaceMaps::find_samples() {
  const BlockSpace& space = system_.space();
  faces_a_node_.assign(system_.grid().size(), 0.0);
  std::size_t first_point = 0;
  for (const auto& cell : space.dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned() || cell->center()[2] < 0.0)
      continue;
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() &&
          cell->face(f)->boundary_id() == boundary_of(FaceGroup::contact)) {
        sample_face(cell, f, first_point);
        first_point += space.face_quadrature().size();
      }
  }
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
    const dealii::DoFHandler<3>::active_cell_iterator& cell, unsigned int f,
    std::size_t first_point) {
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
      take_sample(cell, ix, iy, first_point);
}

/// Adds the node (ix, iy) if it lies on this cell.
void FaceMaps::take_sample(
    const dealii::DoFHandler<3>::active_cell_iterator& cell, int ix, int iy,
    std::size_t first_point) {
  const Grid& grid = system_.grid();
  const BlockSpace& space = system_.space();
  const ContactPoints& points = system_.contact();
  const Point<3> place(ix * grid.spacing_x(), iy * grid.spacing_y(), 0.0);
  Point<3> unit;
  try {
    unit = space.mapping().transform_real_to_unit_cell(cell, place);
  } catch (const dealii::Mapping<3>::ExcTransformationFailed&) {
    return;
  }
  if (!cell->reference_cell().contains_point(unit, inside))
    return;
  Sample sample;
  sample.node =
      grid.index(wrapped(ix, grid.points_x), wrapped(iy, grid.points_y));
  sample.row = points.row_at(cell, unit);
  double nearest = std::numeric_limits<double>::max();
  const std::size_t end = points.is_nodal()
                              ? first_point
                              : first_point + space.face_quadrature().size();
  for (std::size_t i = first_point; i < end; ++i) {
    const double distance =
        points[i].place.distance(Point<2>(place[0], place[1]));
    if (distance < nearest) {
      nearest = distance;
      sample.nearest = i;
    }
  }
  faces_a_node_[sample.node] += 1.0;
  samples_.push_back(std::move(sample));
}

std::vector<double> FaceMaps::summed(std::vector<double> field) const {
  dealii::Utilities::MPI::sum(field, MPI_COMM_WORLD, field);
  return field;
}

std::vector<double> FaceMaps::at_points(std::span<const double> field) const {
  const ContactPoints& points = system_.contact();
  std::vector<double> values(points.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = points[i].grid_node >= 0
                    ? field[static_cast<std::size_t>(points[i].grid_node)]
                    : bicubic(system_.grid(), field, points[i].place[0],
                              points[i].place[1]);
  return values;
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
  if (points.is_nodal()) {
    Vector nodal = system_.space().make_vector();
    for (std::size_t i = 0; i < points.size(); ++i)
      nodal(points[i].row.front().first) = at_points[i];
    nodal.compress(dealii::VectorOperation::insert);
    field = displacement(nodal);
    for (double& pressure : field)
      pressure = std::max(0.0, pressure);
    return field;
  }
  for (const Sample& sample : samples_)
    field[sample.node] +=
        at_points[sample.nearest] / faces_a_node_[sample.node];
  return summed(std::move(field));
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
