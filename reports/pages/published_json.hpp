#pragma once

// Writes a published number beside the computed ones as JSON, in the same form
// in summary.json and in the paper.json of a collection. It is internal to the
// reports.

#include "reports/analysis/verdict.hpp"

#include <nlohmann/json_fwd.hpp>

namespace asperity::reports {

/// Returns quantity, value, unit, uncertainty, source, why, input, line (as
/// `asperity check` prints it), verdict (of the method that agrees best) and
/// ours. For each method that provides the quantity, the latter contains value,
/// half_width_95, realizations, remark, verdict (an enumerator of
/// judgement.hpp) and words.
nlohmann::ordered_json published_json(const PublishedValue& published);

} // namespace asperity::reports
