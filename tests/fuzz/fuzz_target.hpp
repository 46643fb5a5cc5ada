#pragma once

// A fuzz target is a function of any bytes. It may refuse them by the error of
// its module; any other failure is a mistake of the program.

#include <cstdio>
#include <cstdlib>
#include <string>

namespace asperity::fuzz {

/// Defined by each target.
void read_input(const std::string& bytes);

/// Ends the program, by which a target fails, if the condition is false.
inline void require(bool is_true, const char* claim) {
  if (is_true)
    return;
  std::fprintf(stderr, "not true: %s\n", claim);
  std::abort();
}

} // namespace asperity::fuzz
