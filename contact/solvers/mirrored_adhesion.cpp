#include "contact/solvers/mirrored_adhesion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::contact {
namespace {

/// Of heights that were filtered by transforms, relative to the largest.
constexpr double roundoff_of_heights = 1e-12;

bool equals_mirror_images(std::span<const double> heights, const Grid& grid) {
  const double accepted =
      roundoff_of_heights *
      std::abs(*std::ranges::max_element(
          heights, {}, [](double height) { return std::abs(height); }));
  for (int y = 0; y < grid.points_y; ++y)
    for (int x = 0; x < grid.points_x; ++x) {
      const double own = heights[grid.index(x, y)];
      const int over_x = grid.points_x - 1 - x;
      const int over_y = grid.points_y - 1 - y;
      if (!(std::abs(heights[grid.index(over_x, y)] - own) <= accepted &&
            std::abs(heights[grid.index(x, over_y)] - own) <= accepted))
        return false;
    }
  return true;
}

} // namespace

std::optional<MirroredAdhesion>
MirroredAdhesion::of(const SurfaceOperator& elasticity,
                     std::span<const double> heights) {
  if (elasticity.shared_rows() != nullptr ||
      !equals_mirror_images(heights, elasticity.grid()))
    return std::nullopt;
  std::unique_ptr<SurfaceOperator> quarter = elasticity.mirrored();
  if (!quarter)
    return std::nullopt;
  return MirroredAdhesion(std::move(quarter), heights);
}

MirroredAdhesion::MirroredAdhesion(std::unique_ptr<SurfaceOperator> quarter,
                                   std::span<const double> heights)
    : elasticity_(std::move(quarter)), heights_(quarter_of(heights)) {}

ContactSolution MirroredAdhesion::solve(AdhesiveProblem problem,
                                        const mechanics::LoadTarget& target,
                                        std::vector<double>& state) {
  problem.heights = heights_;
  ContactSolution answer =
      solve_adhesive(*elasticity_, problem, target, quarter_of(state));
  for (std::vector<double>* field :
       {&answer.pressure, &answer.gap, &answer.displacement})
    *field = unfolded(*field);
  state = answer.gap;
  return answer;
}

std::vector<double>
MirroredAdhesion::quarter_of(std::span<const double> whole) const {
  const Grid& grid = elasticity_->grid();
  const auto width = static_cast<std::size_t>(grid.points_x);
  std::vector<double> quarter(grid.size());
  for (std::size_t at = 0; at < quarter.size(); at += width)
    std::ranges::copy(whole.subspan(2 * at, width), &quarter[at]);
  return quarter;
}

std::vector<double>
MirroredAdhesion::unfolded(std::span<const double> quarter) const {
  const auto width = static_cast<std::size_t>(elasticity_->grid().points_x);
  const std::size_t height = quarter.size() / width;
  std::vector<double> whole;
  whole.reserve(4 * quarter.size());
  for (std::size_t y = 0; y < 2 * height; ++y) {
    const auto row =
        quarter.subspan(std::min(y, 2 * height - 1 - y) * width, width);
    whole.insert(whole.end(), row.begin(), row.end());
    whole.insert(whole.end(), row.rbegin(), row.rend());
  }
  return whole;
}

} // namespace asperity::contact
