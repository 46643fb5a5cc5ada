#pragma once

// Writes a surface report as JSON, in SI units.

#include "reports/surface/surface_report.hpp"

#include <nlohmann/json_fwd.hpp>

namespace asperity::reports {

/// Returns all numbers of the report; docs/numerics/surface-analysis.md lists
/// the keys. Numbers that are not determined are null.
nlohmann::ordered_json surface_json(const SurfaceReport& report);

} // namespace asperity::reports
