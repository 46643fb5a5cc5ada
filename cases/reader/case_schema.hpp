#pragma once

// The vocabulary for other programs: editors and checkers of case files.

#include <string>

namespace asperity::cases {

/// JSON Schema, draft 2020-12, of a case file (TOML maps onto JSON). It says
/// what one key may hold; what depends on two keys is said by the reader alone.
std::string json_schema();

} // namespace asperity::cases
