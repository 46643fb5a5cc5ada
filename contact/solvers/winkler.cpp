#include "contact/solvers/winkler.hpp"

#include "base/field_sums.hpp"
#include "base/require.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <vector>

namespace asperity::contact {
namespace {

/// Returns the level s of the springs at the prescribed mean pressure or mean
/// gap. With the m highest nodes in contact both are linear in s; m is the
/// number for which s lies between the heights of nodes m and m + 1.
double spring_level(std::span<const double> heights, double stiffness,
                    const mechanics::LoadTarget& target) {
  std::vector<double> sorted(heights.begin(), heights.end());
  std::ranges::sort(sorted, std::greater<>());
  const auto n = static_cast<double>(sorted.size());
  double total = 0.0;
  for (const double height : sorted)
    total += height;
  const bool by_gap = target.control == mechanics::Control::mean_gap;
  double above = by_gap ? 0.0 : sorted.front(); // sum of those in contact
  for (std::size_t m = by_gap ? 0 : 1;; ++m) {
    const auto in_contact = static_cast<double>(m);
    const double level =
        by_gap ? (n * target.amount + total - above) / (n - in_contact)
               : (above - n * target.amount / stiffness) / in_contact;
    const bool is_last = m == sorted.size() - (by_gap ? 1 : 0);
    if (is_last || level >= sorted[m])
      return level;
    above += sorted[m];
  }
}

} // namespace

ContactSolution winkler_contact(std::span<const double> heights,
                                double stiffness,
                                const mechanics::LoadTarget& target) {
  if (heights.empty() || !all_finite(heights))
    throw std::domain_error("heights must be finite, at least one");
  require_positive("stiffness", stiffness, "Pa/m");
  require_positive("the prescribed load or mean gap", target.amount, "SI");
  const double level = spring_level(heights, stiffness, target);
  ContactSolution solution;
  for (const double height : heights) {
    solution.pressure.push_back(stiffness * std::max(0.0, height - level));
    solution.gap.push_back(std::max(0.0, level - height));
  }
  solution.nominal_pressure = mean(solution.pressure);
  solution.mean_gap = mean(solution.gap);
  for (const double pressure : solution.pressure)
    solution.displacement.push_back((pressure - solution.nominal_pressure) /
                                    stiffness);
  solution.converged = true;
  return solution;
}

} // namespace asperity::contact
