#pragma once

// Compares a published number with a computed one. It owns the wording of the
// comparison and decides nothing else.

#include "input/types/reference.hpp"
#include "reports/numbers/estimate.hpp"

#include <string>

namespace asperity::reports {

/// The outcomes are ordered from the best to the weakest statement.
enum class Reproduction {
  reproduced,       ///< |ours - value| <= uncertainty + our interval
  inconclusive,     ///< the same, but our interval is wide
  differs,          ///< beyond the uncertainties, for no known reason
  not_reproducible, ///< beyond them, for a reason given in reference.csv
  input,            ///< set by the case or fitted to it: not a finding
  missing,          ///< no computed number
};

/// Returns the name of the enumerator, for use by programs.
const char* reproduction_word(Reproduction reproduction);

/// The half-width is called wide if it exceeds both this share of the value and
/// the published uncertainty: such an interval would agree with many other
/// values.
inline constexpr double wide_interval = 0.2;

struct Judgement {
  Reproduction reproduction = Reproduction::missing;
  std::string words; ///< "reproduced", "differs by 4.1 %", "inconclusive: ...",
                     ///< "not reproducible: ..."
};

/// Compares a published value with an estimate. A missing half-width counts as
/// 0. "Differs by x %" is relative to the published value and rounded up to two
/// digits; for a published value of 0 the absolute difference is stated.
Judgement compare_with_published(const cases::ReferenceValue& reference,
                                 const Estimate& ours);

} // namespace asperity::reports
