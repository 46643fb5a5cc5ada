#pragma once

// The text of a case with its overrides, which fully describes what was run.
// Defines the "#--set" lines at the end of a text.

#include <string>
#include <string_view>
#include <vector>

namespace asperity::cases {

/// Returns the text followed by a line "#--set key.path=value" for each
/// override. The lines are comments in TOML, but the case reader applies them.
/// Reading the result again gives the same case.
std::string text_with_overrides(const std::string& text,
                                const std::vector<std::string>& overrides);

/// Returns the text up to the "#--set" lines at its end.
std::string_view without_overrides(std::string_view text);

/// Returns the overrides of the "#--set" lines at the end of a text, in order.
/// Such lines anywhere else are comments.
std::vector<std::string> overrides_in(const std::string& text);

} // namespace asperity::cases
