#pragma once

// The scatter of the quantities over the samples of a sweep: measured maps of
// one surface, or realisations of one spectrum.

#include "reports/sweeps/swept_results.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// One quantity of one method over all samples, in the unit of the quantity.
struct Scatter {
  std::string method;
  std::string quantity;
  int count = 0; ///< samples that have a value, >= 2
  Spread spread = {};
  std::size_t lowest = 0; ///< point of the smallest value
  std::size_t highest = 0;
  std::vector<std::size_t> outliers = {}; ///< points, see outliers_of()
};

/// Returns the places of the values whose modified z-score
/// 0.6745 |x - median| / median |x - median| exceeds 3.5; none of fewer than
/// five values, and none within 1e-8 of the median, which is roundoff.
/// @param values  finite
/// @see  B. Iglewicz, D. C. Hoaglin, How to Detect and Handle Outliers (1993)
std::vector<std::size_t> outliers_of(std::span<const double> values);

/// Returns the scatter of these quantities, method by method; without those
/// that fewer than two samples have, that the case prescribes, or that are the
/// same for all.
std::vector<Scatter> scatter_of(const SweptResults& results,
                                const std::vector<std::string>& quantities);

} // namespace asperity::reports
