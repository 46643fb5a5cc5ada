#pragma once

// A scene as the files that a user would write: a height map and a case.

#include <string>

#include "robustness/scene.hpp"

namespace asperity::robustness {

/// The heights as a plain map that reads back to the bit [m]; a flawed scene's
/// may hold a number that is not finite.
std::string map_text_of(const Scene& scene);

/// A case that presses map.txt, beside it, by the scene's load program; with
/// the flaw of a flawed scene.
std::string case_text_of(const Scene& scene);

} // namespace asperity::robustness
