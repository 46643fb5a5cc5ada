#pragma once

// Mistakes in a case, each of which must be refused. Internal to the module.

#include "suite/robustness/draft.hpp"

#include <string>
#include <vector>

namespace asperity::robustness {

std::vector<std::string> flaw_names();

/// Whether only finite elements, or only blocks of some thickness, have it.
bool needs_elements(const std::string& flaw);
bool needs_block(const std::string& flaw);

/// Writes the mistake into the case of an instance.
void spoil(const std::string& name, const Draft& draft, Instance& instance);

} // namespace asperity::robustness
