#pragma once

// What a fuzz target is: a function of any bytes that may refuse them by the
// error of its module, and must do nothing else that is wrong.

#include <cstdio>
#include <cstdlib>
#include <string>

namespace asperity::fuzz {

/// Defined by each target.
void read_input(const std::string& bytes);

/// Ends the program, which is how a target fails, if the claim is not true.
inline void require(bool is_true, const char* claim) {
  if (is_true)
    return;
  std::fprintf(stderr, "not true: %s\n", claim);
  std::abort();
}

} // namespace asperity::fuzz
