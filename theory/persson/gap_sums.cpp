#include "theory/persson/gap_sums.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::theory {
namespace {

using Series = SmallPressureSeries;

template <class Moments>
GammaParts contract(const Series::Coefficients& linear,
                    const Series::Coefficients& cubic, const Moments& moments,
                    double square) {
  GammaParts sum;
  double power = 1.0;
  for (std::size_t n = 0; n < moments.size(); ++n) {
    sum.linear += linear[n] * power * moments[n];
    sum.cubic += cubic[n] * power * moments[n];
    power *= square;
  }
  return sum;
}

// Both kernels fall at least as fast as e^{-x^2}: beyond this value the
// remaining terms are below roundoff, even compared with the first term alone.
bool is_negligible(double x, double smallest_x) {
  const double exponent_of_rounding = 45.0; // e^{-45} = 3e-20
  return x * x > smallest_x * smallest_x + exponent_of_rounding;
}

} // namespace

GapSums::GapSums(std::span<const RoughnessNode> nodes) {
  nodes_.reserve(nodes.size());
  Moments sums{};
  double log_sum = 0.0;
  double last_factor = 0.0;
  for (const RoughnessNode& node : nodes) {
    const double factor =
        1.0 / (std::sqrt(std::numbers::pi) * node.root_moment);
    const double square = (last_factor / factor) * (last_factor / factor);
    double power = 1.0;
    for (double& sum : sums) {
      sum = sum * power + node.weight;
      power *= square;
    }
    log_sum += node.weight * std::log(factor);
    nodes_.push_back({factor, node.weight, log_sum, sums});
    last_factor = factor;
  }
  weight_sum_ = sums[0];
  mean_log_factor_ = log_sum / weight_sum_;
}

std::size_t GapSums::n_small(double pressure_ratio) const {
  const auto end =
      std::partition_point(nodes_.begin(), nodes_.end(), [&](const Node& node) {
        return node.factor * pressure_ratio < Series::limit;
      });
  return static_cast<std::size_t>(end - nodes_.begin());
}

GammaParts GapSums::mean_gap(double pressure_ratio) const {
  const Series& series = small_pressure_series();
  const std::size_t first = n_small(pressure_ratio);
  GammaParts gap;
  if (first > 0) {
    const Node& last = nodes_[first - 1];
    const double x = last.factor * pressure_ratio;
    gap = contract(series.gap_linear, series.gap_cubic, last.power_sums, x * x);
    gap.linear -= last.log_sum + std::log(pressure_ratio) * last.power_sums[0];
  }
  const double smallest = nodes_.front().factor * pressure_ratio;
  for (std::size_t k = first; k < nodes_.size(); ++k) {
    const double x = nodes_[k].factor * pressure_ratio;
    if (is_negligible(x, smallest))
      break;
    const GammaParts kernel = gap_kernel(x);
    gap.linear += nodes_[k].weight * kernel.linear;
    gap.cubic += nodes_[k].weight * kernel.cubic;
  }
  return gap;
}

GammaParts GapSums::mean_gap_slope(double pressure_ratio) const {
  const Series& series = small_pressure_series();
  const std::size_t first = n_small(pressure_ratio);
  GammaParts slope;
  if (first > 0) {
    const Node& last = nodes_[first - 1];
    const double x = last.factor * pressure_ratio;
    slope = contract(series.slope_linear, series.slope_cubic, last.power_sums,
                     x * x);
  }
  const double smallest = nodes_.front().factor * pressure_ratio;
  for (std::size_t k = first; k < nodes_.size(); ++k) {
    const double x = nodes_[k].factor * pressure_ratio;
    if (is_negligible(x, smallest))
      break;
    const GammaParts kernel = gap_kernel_slope(x);
    slope.linear += nodes_[k].weight * kernel.linear;
    slope.cubic += nodes_[k].weight * kernel.cubic;
  }
  return slope;
}

GammaParts GapSums::elastic_energy(double pressure_ratio) const {
  GammaParts energy;
  for (const Node& node : nodes_) { // (pi/2) weight m = (sqrt(pi)/2) weight/w
    const double part =
        0.5 * std::sqrt(std::numbers::pi) * node.weight / node.factor;
    const double probability =
        std::erf(node.factor * pressure_ratio); // Eq. (11)
    energy.linear += part * probability;
    energy.cubic += part * probability * probability * probability;
  }
  return energy;
}

} // namespace asperity::theory
