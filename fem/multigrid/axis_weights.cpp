#include "fem/multigrid/axis_weights.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::fem {
namespace {

/// Weights below this are rounding of zero.
constexpr double smallest_weight = 1e-10;

std::array<double, 3> shapes_at(int degree, double x) {
  if (degree == 1)
    return {1.0 - x, x, 0.0};
  return {(1.0 - x) * (1.0 - 2.0 * x), 4.0 * x * (1.0 - x),
          x * (2.0 * x - 1.0)};
}

} // namespace

double BoxGridAxis::node(std::size_t number) const {
  const auto own = static_cast<std::size_t>(degree);
  const std::size_t cell = std::min(number / own, cells() - 1);
  const double share =
      static_cast<double>(number - cell * own) / static_cast<double>(degree);
  return sides[cell] + share * (sides[cell + 1] - sides[cell]);
}

std::size_t BoxGridAxis::cell_at(double place) const {
  const double rounding = smallest_weight * sides.back();
  const auto side =
      std::lower_bound(sides.begin() + 1, sides.end() - 1, place - rounding);
  return static_cast<std::size_t>(side - sides.begin()) - 1;
}

SparseRows interpolation(const BoxGridAxis& coarse, const BoxGridAxis& fine) {
  SparseRows result;
  const auto own = static_cast<std::size_t>(coarse.degree);
  for (std::size_t number = 0; number < fine.nodes(); ++number) {
    const double place = fine.node(number);
    const std::size_t cell = coarse.cell_at(place);
    const double share = (place - coarse.sides[cell]) /
                         (coarse.sides[cell + 1] - coarse.sides[cell]);
    const auto shapes = shapes_at(coarse.degree, share);
    for (std::size_t i = 0; i <= own; ++i)
      if (std::abs(shapes[i]) > smallest_weight) {
        const std::size_t node = cell * own + i;
        result.column.push_back(coarse.is_periodic ? node % coarse.nodes()
                                                   : node);
        result.weight.push_back(shapes[i]);
      }
    result.start.push_back(result.column.size());
  }
  return result;
}

std::vector<std::size_t> nearest_fine(const BoxGridAxis& coarse,
                                      const BoxGridAxis& fine) {
  std::vector<std::size_t> nearest;
  const auto own = static_cast<std::size_t>(fine.degree);
  for (std::size_t number = 0; number < coarse.nodes(); ++number) {
    const double place = coarse.node(number);
    const std::size_t first = fine.cell_at(place) * own;
    std::size_t best = first;
    for (std::size_t node = first + 1; node <= first + own; ++node)
      if (std::abs(fine.node(node) - place) < std::abs(fine.node(best) - place))
        best = node;
    nearest.push_back(fine.is_periodic ? best % fine.nodes() : best);
  }
  return nearest;
}

SparseRows coverage(const BoxGridAxis& coarse, const BoxGridAxis& fine) {
  SparseRows result;
  for (std::size_t cell = 0; cell < coarse.cells(); ++cell) {
    const double low = coarse.sides[cell], high = coarse.sides[cell + 1];
    for (std::size_t own = 0; own < fine.cells(); ++own) {
      const double common =
          std::min(high, fine.sides[own + 1]) - std::max(low, fine.sides[own]);
      if (common > smallest_weight * (high - low)) {
        result.column.push_back(own);
        result.weight.push_back(common / (high - low));
      }
    }
    result.start.push_back(result.column.size());
  }
  return result;
}

} // namespace asperity::fem
