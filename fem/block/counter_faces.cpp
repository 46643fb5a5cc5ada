#include "fem/block/counter_faces.hpp"

#include "fem/block/all_ranks.hpp"
#include "fem/block/block_triangulation.hpp"

#include <algorithm>
#include <cmath>
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

} // namespace asperity::fem
