#include "mechanics/flow/effective_medium.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace asperity::flow {
namespace {

/// @param share  share(i) of the i-th gap
template <class Share>
double medium_of(std::span<const double> gaps, const Share& share) {
  double open = 0.0, largest = 0.0, smallest = 0.0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (!(gaps[i] > 0.0) || !(share(i) > 0.0))
      continue;
    open += share(i);
    largest = std::max(largest, gaps[i]);
    smallest = smallest > 0.0 ? std::min(smallest, gaps[i]) : gaps[i];
  }
  // The rest of the sum is 1 for K = 0 and -1 for K = infinity.
  if (!(open > 0.5))
    return 0.0;
  const auto excess = [&](double medium_gap) {
    double sum = open - 1.0;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      if (!(gaps[i] > 0.0))
        continue;
      const double ratio = gaps[i] / medium_gap;
      const double cube = ratio * ratio * ratio;
      sum += share(i) * (std::isinf(cube) ? 1.0 : (cube - 1.0) / (cube + 1.0));
    }
    return sum;
  };
  // K lies between the cubes of two gaps, or below all if much is closed.
  double low = std::log(smallest) - 1.0, high = std::log(largest);
  while (excess(std::exp(low)) < 0.0)
    low -= 1.0;
  constexpr int halvings = 50;
  for (int i = 0; i < halvings && high - low > 1e-12; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(std::exp(middle)) > 0.0 ? low : high) = middle;
  }
  return std::exp(3.0 * 0.5 * (low + high));
}

} // namespace

double effective_medium(std::span<const double> gaps,
                        std::span<const double> shares) {
  if (gaps.size() != shares.size())
    throw std::domain_error("effective_medium: as many gaps as shares");
  return medium_of(gaps, [=](std::size_t i) { return shares[i]; });
}

double effective_medium(std::span<const double> gap) {
  return medium_of(gap, [share = 1.0 / static_cast<double>(gap.size())](
                            std::size_t) { return share; });
}

} // namespace asperity::flow
