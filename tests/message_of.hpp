#pragma once

// The message with which a call is refused.

#include <string>

namespace asperity::tests {

/// what() of the error that `call` throws; "accepted" if it throws none. Errors
/// of another type pass.
template <class Error, class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

} // namespace asperity::tests
