#pragma once

// The exception of base/require.hpp, for a caller that knows the case, and the
// checks of an argument whose name is not that of its key.

#include <stdexcept>
#include <string>

namespace asperity {

/// An argument in the words of a message, and the key of a case that gives it:
/// its path, in which `method` stands for the table of the method that is
/// computed. Unlike the words, the key is never edited for the sake of a
/// message.
struct Argument {
  const char* name; ///< "depth of an interface"
  const char* key;  ///< "material.layers", "method.depth"
};

/// "name = value, but must be <range>".
struct RefusedArgument : std::domain_error {
  RefusedArgument(const std::string& name_, double value_, std::string range_,
                  std::string key_ = "");

  std::string name;
  double value;
  std::string range;
  std::string key; ///< Argument::key; empty if the name is that of the key
};

/// As those of base/require.hpp.
/// @throws RefusedArgument  with the key
[[noreturn]] void refuse_argument(const Argument& argument, double value,
                                  const std::string& range);
void require_positive(const Argument& argument, double value, const char* unit);
void require_between(const Argument& argument, double value, double low,
                     double high, const char* unit);

} // namespace asperity
