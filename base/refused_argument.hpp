#pragma once

// The exception of base/require.hpp, for a caller that knows which key of a
// case gave the argument.

#include <stdexcept>
#include <string>

namespace asperity {

/// "name = value, but must be <range>".
struct RefusedArgument : std::domain_error {
  RefusedArgument(std::string name_, double value_, std::string range_);

  std::string name;
  double value;
  std::string range;
};

} // namespace asperity
