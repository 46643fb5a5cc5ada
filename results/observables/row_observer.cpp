#include "results/observables/row_observer.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::results {

void RowObserver::record(const CurveColumn& column, const Observed& observed) {
  const bool is_determined = std::isfinite(observed.value);
  column.set(row_, is_determined ? observed.value : Observed::none);
  if (is_determined)
    return;
  row_.add_note(fmt::format("{} is not determined: {}", column.name,
                            observed.reason.empty() ? "its value is not finite"
                                                    : observed.reason));
}

} // namespace asperity::results
