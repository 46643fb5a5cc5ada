#pragma once

// Exports the vocabulary as JSON Schema for editors and validators of case
// files.

#include <string>

namespace asperity::cases {

/// Returns the JSON Schema, draft 2020-12, of a case file (TOML maps onto
/// JSON). It restricts the values of single keys; conditions on several keys
/// are checked only by the reader.
std::string json_schema();

} // namespace asperity::cases
