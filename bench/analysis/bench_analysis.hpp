#pragma once

// From runs to errors, orders and exponents: everything a benchmark says that
// is not measured directly.

#include "bench/analysis/bench.hpp"

namespace asperity::reports {

/// Fills quantities, truth, errors, orders and exponents of a bench whose
/// points have run and whose series name them; truth.series is set before.
///
/// The truth of a quantity is the exact solution where that answers at every
/// load, else the Richardson limit of the truth's series. A method's own limit
/// is that of its series over points, else of its first series that has an
/// order.
void analyse(Bench& bench, const cases::Case& contact_case);

/// The limit of a series for every quantity that all its last settings answer,
/// with what it is uncertain by. Areas: each estimator by itself.
BenchTruth limit_of(const Bench& bench, const BenchSeries& series);

/// Points of the bench that stand on the front of a quantity, in ascending
/// cost: settings of elastic methods that answer, the truth's own left out.
std::vector<std::size_t> front_of(const Bench& bench,
                                  const std::string& quantity);

} // namespace asperity::reports
