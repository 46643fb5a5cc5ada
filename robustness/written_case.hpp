#pragma once

// Writes an instance as the files that a user would write: a height map and a
// case.

#include "robustness/instance.hpp"

#include <string>

namespace asperity::robustness {

/// Returns the heights [m] as a plain-text map that reads back bitwise equal;
/// that of a flawed instance may contain a number that is not finite.
std::string map_text_of(const Instance& instance);

/// Returns a case that loads map.txt, in the same folder, along the loading
/// path of the instance, including the flaw of a flawed instance.
std::string case_text_of(const Instance& instance);

} // namespace asperity::robustness
