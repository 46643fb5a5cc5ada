#pragma once

// Limits on the text of a case, checked before the text is passed to the TOML
// library. The library recurses for each level of nesting, and finds the line
// of each value by counting from the start of the text.

#include <cstddef>
#include <optional>
#include <string>

namespace asperity::cases {

/// Length of a case file [B].
inline constexpr std::size_t largest_case_text = std::size_t{1024} * 1024;
inline constexpr int deepest_nesting = 32; ///< nested tables and lists
inline constexpr int longest_key = 32;     ///< parts separated by dots
inline constexpr int most_values = 20000;
/// By --set or by a case with a base.
inline constexpr std::size_t most_overrides = 2000;

/// The description of a broken limit and its line.
struct BrokenLimit {
  int line = 0; ///< from 1; 0: not related to a line
  std::string what;
};

/// Returns the first limit that the text breaks, or nothing if it complies with
/// all limits. The text may still be invalid TOML.
std::optional<BrokenLimit> broken_limit(const std::string& text);

} // namespace asperity::cases
