#pragma once

// A published number held against one of ours. Owns the words of that
// judgement; it decides nothing else.

#include "cases/types/reference.hpp"
#include "reports/numbers/estimate.hpp"

#include <string>

namespace asperity::reports {

/// From the best to the least that can be said.
enum class Reproduction {
  reproduced,       ///< |ours - value| <= uncertainty + our interval
  inconclusive,     ///< so too, but our interval is wide
  differs,          ///< not so, and nothing is said against the number
  not_reproducible, ///< not so, and reference.csv says why it cannot be
  input,            ///< the case sets it or is fitted to it: no finding
  missing,          ///< we have no number
};

/// The enumerator's own name: for programs.
const char* reproduction_word(Reproduction reproduction);

/// Our half-width is called wide where it is more than this share of the value,
/// and more than the published uncertainty: it would agree with much else.
inline constexpr double wide_interval = 0.2;

struct Judgement {
  Reproduction reproduction = Reproduction::missing;
  std::string words; ///< "reproduced", "differs by 4.1 %", "inconclusive: ...",
                     ///< "not reproducible: ..."
};

/// Our half-width counts as 0 where there is none. "Differs by x %" is of the
/// published value, rounded up to two digits; of a value 0 the difference
/// itself is said.
Judgement judge_published(const cases::ReferenceValue& reference,
                          const Estimate& ours);

} // namespace asperity::reports
