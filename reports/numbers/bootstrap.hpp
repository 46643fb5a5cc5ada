#pragma once

// Intervals of numbers that follow from many realisations at once, by drawing
// realisations with replacement.

#include "reports/numbers/estimate.hpp"

#include <cstddef>
#include <functional>
#include <span>

namespace asperity::reports {

/// A number that follows from realisations, which are given by their indices
/// and may repeat.
using Statistic = std::function<double(std::span<const std::size_t>)>;

/// Returns the statistic of realisations 0..n-1. Its 95 % interval is that of
/// 400 samples of n realisations with replacement, from a fixed seed, widened
/// by t_{0.975, n-1}/1.96 sqrt(n/(n-1)), so that the interval of a mean is on
/// average that of mean_over_realizations().
/// @param realizations  n; below 2 there is no interval
Estimate bootstrap(std::size_t realizations, const Statistic& statistic);

} // namespace asperity::reports
