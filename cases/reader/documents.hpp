#pragma once

// The vocabulary for people: the commented template of `asperity new`, and the
// reference page docs/case.md.

#include <string>

namespace asperity::cases {

/// A case file titled `name` that reads without a mistake, runs in seconds,
/// and explains every key it shows.
std::string case_template(const std::string& name);

/// docs/case.md, every table and key. The committed page is this text.
std::string case_reference_markdown();

} // namespace asperity::cases
