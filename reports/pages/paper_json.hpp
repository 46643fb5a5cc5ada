#pragma once

// Builds paper.json, from which the page of a collection is rendered. It is
// internal to the report on a collection.

#include "reports/pages/paper_report.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>

namespace asperity::reports {

/// Returns the parts, their published numbers in the order of their
/// reference.csv, each beside the computed ones, and the counts by the best
/// verdict of any method (docs/reference/results.md).
nlohmann::ordered_json paper_json(std::span<const PaperPart> parts,
                                  const std::string& title);

} // namespace asperity::reports
