#pragma once

// The one exception for bad input from outside: a case file, a map, a table.

#include <stdexcept>

namespace asperity::cases {

/// Bad input. The message is for the person who wrote the file: file, line,
/// key, what was found, what is allowed. The program ends with exit code 2.
struct CaseError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

} // namespace asperity::cases
