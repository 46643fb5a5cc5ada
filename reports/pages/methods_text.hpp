#pragma once

// Writes the text on methods and the literature that a publication of a result
// needs: only what was used in this result.

#include "reports/figures/series.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Text with keys of the literature, "[polonsky1999]", and the literature.
struct MethodsText {
  std::vector<std::string> paragraphs; ///< one for each result
  std::string literature;              ///< BibTeX entries, each key once
};

MethodsText methods_text(std::span<const ReportEntry> entries);

} // namespace asperity::reports
