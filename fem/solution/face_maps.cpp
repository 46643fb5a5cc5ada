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
using mechanics::HeightInterpolation;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr double inside = 1e-6; // in unit-cell widths and in node spacings

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

FaceMaps::FaceMaps(const BlockSystem& system, HeightInterpolation between)
    : system_(system), between_(between) {
  if (!system.contact().is_grid())
    find_samples();
}

/// Collects every grid node on each cell face of this rank that lies on the
/// contact surface.
void FaceMaps::find_samples() {
  const BlockSpace& space = system_.space();
  faces_a_node_.assign(system_.grid().size(), 0.0);
  std::size_t first_point = 0;
  for_contact_faces(space, [&](const auto& cell, unsigned int f) {
    sample_face(cell, f, first_point);
    first_point += space.face_quadrature().size();
  });
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
  if (!points.is_nodal())
    sample.nearest =
        points.nearest_on_face(first_point, Point<2>(place[0], place[1]));
  faces_a_node_[sample.node] += 1.0;
  samples_.push_back(std::move(sample));
}

std::vector<double> FaceMaps::summed(std::vector<double> field) const {
  dealii::Utilities::MPI::sum(field, MPI_COMM_WORLD, field);
  return field;
}

/// A field at places, of which those that are nodes of the grid have the value
/// there.
std::vector<double> FaceMaps::values_at(std::span<const double> field,
                                        std::span<const Point<2>> places,
                                        HeightInterpolation between) const {
  std::vector<double> values(places.size());
  std::vector<SurfacePlace> others;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const int node = grid_node_at(system_.grid(), places[i][0], places[i][1]);
    if (node >= 0) {
      values[i] = field[static_cast<std::size_t>(node)];
    } else {
      others.push_back({places[i][0], places[i][1]});
      which.push_back(i);
    }
  }
  const std::vector<double> found =
      interpolated(system_.grid(), field, between, others);
  for (std::size_t i = 0; i < which.size(); ++i)
    values[which[i]] = found[i];
  return values;
}

std::vector<Point<2>> FaceMaps::places_of_points() const {
  std::vector<Point<2>> places;
  for (std::size_t i = 0; i < system_.contact().size(); ++i)
    places.push_back(system_.contact()[i].place);
  return places;
}

std::vector<double> FaceMaps::at_points(std::span<const double> field) const {
  return values_at(field, places_of_points(), HeightInterpolation::bicubic);
}

std::vector<double>
FaceMaps::heights_at_points(std::span<const double> heights) const {
  return values_at(heights, places_of_points(), between_);
}

std::vector<double>
FaceMaps::heights_at(std::span<const double> heights,
                     std::span<const Point<2>> places) const {
  return values_at(heights, places, between_);
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
