#pragma once

// The limits of a case's text, held before the TOML library sees it: that
// library calls itself at each level of nesting, and looks for the line of each
// value from the start of the text.

#include <cstddef>
#include <optional>
#include <string>

namespace asperity::cases {

inline constexpr std::size_t largest_case_text = 1024 * 1024; ///< bytes
inline constexpr int deepest_nesting = 32; ///< tables and lists in each other
inline constexpr int longest_key = 32;     ///< parts with dots between them
inline constexpr int most_values = 20000;
inline constexpr std::size_t most_overrides = 2000; ///< --set, or on a base

/// What is wrong with a text, and its line.
struct BrokenLimit {
  int line = 0; ///< from 1; 0: of no line
  std::string what;
};

/// The first limit that the text breaks; nothing if it keeps all of them, which
/// does not mean that it is TOML.
std::optional<BrokenLimit> broken_limit(const std::string& text);

} // namespace asperity::cases
