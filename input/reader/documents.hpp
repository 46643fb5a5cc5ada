#pragma once

// Generates documents from the vocabulary: the commented template of `asperity
// new` and the reference page docs/reference/case.md.

#include <string>

namespace asperity::cases {

/// Returns a case file with the title `name`. It is valid, runs in seconds, and
/// explains every key that it shows.
std::string case_template(const std::string& name);

/// Returns docs/reference/case.md with all tables and keys. The committed page
/// equals this text.
std::string case_reference_markdown();

} // namespace asperity::cases
