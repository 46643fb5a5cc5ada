#pragma once

// A published number beside ours as JSON, alike in summary.json and in the
// paper.json of a collection. Internal to the reports.

#include "reports/analysis/verdict.hpp"

#include <nlohmann/json.hpp>

namespace asperity::reports {

/// null for a number that does not exist.
nlohmann::ordered_json json_number(double value);

/// quantity, value, unit, uncertainty, source, why, input, line (as `asperity
/// check` prints it), verdict (of the method that comes nearest) and ours: for
/// each method that answers value, half_width_95, realizations, remark, verdict
/// (a word of judgement.hpp) and words.
nlohmann::ordered_json published_json(const PublishedValue& published);

} // namespace asperity::reports
