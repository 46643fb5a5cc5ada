#pragma once

// In which forms a report is written besides its page.

#include "reports/pages/report.hpp"

#include <string>
#include <vector>

namespace asperity::cli {

struct ReportForms {
  bool has_pdf = false;             ///< also print the report
  std::vector<std::string> formats; ///< of figures for a journal
  std::string width = "86mm";       ///< of these
  std::string units;                ///< likewise; empty: those of the report
};

/// @throws std::domain_error  no program prints PDF, or an unknown format,
///                            width or unit
reports::ReportExtras extras_of(const ReportForms& forms);

} // namespace asperity::cli
