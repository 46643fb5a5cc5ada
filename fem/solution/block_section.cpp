#include "fem/solution/block_section.hpp"

#include "fem/block/all_ranks.hpp"

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace asperity::fem {
namespace {

using dealii::Point;

/// Distance that a place may lie outside of a cell that provides its value, in
/// the reference coordinates of the cell. It allows for roundoff of the
/// mapping.
constexpr double outside = 1e-8;

/// The value that one cell provides for a place: distance of the cell's centre
/// from the contact surface, x and y of the centre [m], then the von Mises
/// stress [Pa]. The smallest one in lexicographic order is used.
using Answer = std::array<double, 4>;

constexpr double nobody = std::numeric_limits<double>::infinity();

std::unique_ptr<dealii::FiniteElement<3>> linear_on(const BlockSpace& space) {
  if (space.triangulation().all_reference_cells_are_hyper_cube())
    return std::make_unique<dealii::FE_Q<3>>(1);
  return std::make_unique<dealii::FE_SimplexP<3>>(1);
}

/// The reference coordinates of the place, if it lies in the cell.
std::optional<Point<3>> place_in(const BlockStress::Cell& cell,
                                 const Point<3>& place,
                                 const dealii::Mapping<3>& mapping) {
  try {
    const Point<3> unit = mapping.transform_real_to_unit_cell(cell, place);
    if (cell->reference_cell().contains_point(unit, outside))
      return unit;
  } catch (const dealii::Mapping<3>::ExcTransformationFailed&) {
  } // the place is far outside of a distorted cell
  return std::nullopt;
}

/// Evaluates the stress of one cell at the places that lie in it.
class CellInPlane {
public:
  CellInPlane(const SectionPlane& plane, const BlockSpace& space)
      : plane_(plane),
        space_(space),
        linear_(linear_on(space)),
        answers_(plane.x.size() * plane.depth.size(),
                 {nobody, nobody, nobody, nobody}) {}

  void take(const BlockStress::Cell& cell,
            std::span<const StressTensor> at_vertex) {
    const Point<3> centre = cell->center();
    if ((centre[2] < 0.0) != plane_.is_counter)
      return;
    const double slack = space_.coordinate_tolerance();
    const auto corners = cell->bounding_box().get_boundary_points();
    const auto spans = [&](unsigned int axis, double value) {
      return value >= corners.first[axis] - slack &&
             value <= corners.second[axis] + slack;
    };
    if (!spans(1, plane_.y))
      return;
    for (std::size_t row = 0; row < plane_.depth.size(); ++row) {
      const double z =
          plane_.is_counter ? -plane_.depth[row] : plane_.depth[row];
      for (std::size_t i = 0; spans(2, z) && i < plane_.x.size(); ++i) {
        if (!spans(0, plane_.x[i]))
          continue;
        const auto unit =
            place_in(cell, {plane_.x[i], plane_.y, z}, space_.mapping());
        if (!unit)
          continue;
        Answer& best = answers_[row * plane_.x.size() + i];
        best = std::min(best, {std::abs(centre[2]), centre[0], centre[1],
                               strength_at(*unit, at_vertex)});
      }
    }
  }

  const std::vector<Answer>& answers() const { return answers_; }

private:
  double strength_at(const Point<3>& unit,
                     std::span<const StressTensor> at_vertex) const {
    StressTensor stress;
    for (unsigned int v = 0; v < at_vertex.size(); ++v)
      stress += linear_->shape_value(v, unit) * at_vertex[v];
    return von_mises(stress);
  }

  const SectionPlane& plane_;
  const BlockSpace& space_;
  std::unique_ptr<dealii::FiniteElement<3>> linear_;
  std::vector<Answer> answers_;
};

} // namespace

std::vector<double> von_mises_in(const SectionPlane& plane,
                                 const BlockSpace& space, BlockStress& stress) {
  CellInPlane own(plane, space);
  stress.at_vertices([&](const BlockStress::Cell& cell,
                         std::span<const StressTensor> at_vertex) {
    own.take(cell, at_vertex);
  });
  std::vector<Answer> best = own.answers();
  const std::vector<Answer> found = of_all_ranks(best);
  for (std::size_t i = 0; i < found.size(); ++i)
    best[i % best.size()] = std::min(best[i % best.size()], found[i]);
  std::vector<double> strength;
  strength.reserve(best.size());
  for (const Answer& answer : best)
    strength.push_back(answer[0] < nobody
                           ? answer[3]
                           : std::numeric_limits<double>::quiet_NaN());
  return strength;
}

} // namespace asperity::fem
