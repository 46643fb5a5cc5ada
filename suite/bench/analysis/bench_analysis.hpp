#pragma once

// Computes errors, orders and exponents from the runs: everything in a
// benchmark that is not measured directly.

#include "suite/bench/analysis/bench.hpp"

namespace asperity::bench {

/// Fills the quantities, reference solution, errors, orders and exponents of a
/// bench whose points have run and whose series refer to them; reference.series
/// must be set before.
///
/// The reference solution of a quantity is the exact solution if that provides
/// the quantity at every load, otherwise the Richardson limit of the reference
/// series. The limit of a method itself is that of its series over points, or
/// else of its first series that has an order.
void analyse(Bench& bench, const cases::Case& contact_case);

/// Returns the limit of a series, with its uncertainty, for every quantity that
/// all its last settings provide. Each estimator of the area has its own limit.
ReferenceSolution limit_of(const Bench& bench, const BenchSeries& series);

} // namespace asperity::bench
