#include "reports/numbers/bootstrap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace asperity::reports {

Estimate bootstrap(std::size_t realizations, const Statistic& statistic) {
  constexpr std::size_t samples = 400;
  constexpr std::size_t outside = samples / 40; // 2.5 % at either end
  constexpr double normal_quantile = 1.959964;
  std::vector<std::size_t> drawn(realizations);
  std::iota(drawn.begin(), drawn.end(), std::size_t{0});
  Estimate estimate;
  estimate.value = realizations == 0 ? not_a_number : statistic(drawn);
  estimate.realizations = static_cast<int>(realizations);
  estimate.remark = "one realisation: no interval";
  if (realizations < 2 || !std::isfinite(estimate.value))
    return estimate;
  std::mt19937_64 engine(1);
  std::vector<double> values;
  values.reserve(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    for (std::size_t& index : drawn)
      index = engine() % realizations;
    if (const double value = statistic(drawn); std::isfinite(value))
      values.push_back(value);
  }
  if (values.size() < samples) {
    estimate.remark = "no interval: some samples of the realisations have none";
    return estimate;
  }
  std::ranges::sort(values);
  const double n = static_cast<double>(realizations);
  const double widening =
      student_half_width(std::sqrt(n / (n - 1.0)),
                         static_cast<int>(realizations) - 1) /
      normal_quantile;
  estimate.half_width =
      0.5 * widening * (values[samples - 1 - outside] - values[outside]);
  estimate.remark = fmt::format("bootstrap over {} realisations", realizations);
  return estimate;
}

} // namespace asperity::reports
