#include "reports/sweeps/sweep_scatter.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

constexpr double relative_roundoff = 1e-9;

} // namespace

std::vector<std::size_t> outliers_of(std::span<const double> values) {
  constexpr std::size_t least_values = 5;
  constexpr double of_a_normal = 0.6745; // median |x| of a standard normal
  constexpr double limit = 3.5;
  std::vector<std::size_t> outliers;
  if (values.size() < least_values)
    return outliers;
  const double median = reports::median({values.begin(), values.end()});
  std::vector<double> distances;
  distances.reserve(values.size());
  for (const double value : values)
    distances.push_back(std::abs(value - median));
  const double scale = std::max(reports::median(distances),
                                relative_roundoff * std::abs(median));
  for (std::size_t i = 0; i < values.size(); ++i)
    if (of_a_normal * distances[i] > limit * scale)
      outliers.push_back(i);
  return outliers;
}

std::vector<Scatter> scatter_of(const SweptResults& results,
                                const std::vector<std::string>& quantities) {
  std::vector<Scatter> rows;
  for (const std::string& method : swept_methods(results))
    for (const std::string& quantity : quantities) {
      std::vector<double> values;
      std::vector<std::size_t> points;
      for (const auto& result : results) {
        const Estimate* const found = swept_estimate(*result, method, quantity);
        if (found == nullptr || !std::isfinite(found->value) || found->is_input)
          continue;
        values.push_back(found->value);
        points.push_back(result->point);
      }
      if (values.size() < 2)
        continue;
      Scatter row{method, quantity, static_cast<int>(values.size())};
      row.spread = spread_of(values);
      if (!(row.spread.deviation >
            relative_roundoff * std::abs(row.spread.mean)))
        continue; // not of the surface
      const auto [low, high] = std::ranges::minmax_element(values);
      row.lowest = points[static_cast<std::size_t>(low - values.begin())];
      row.highest = points[static_cast<std::size_t>(high - values.begin())];
      for (const std::size_t i : outliers_of(values))
        row.outliers.push_back(points[i]);
      rows.push_back(std::move(row));
    }
  return rows;
}

} // namespace asperity::reports
