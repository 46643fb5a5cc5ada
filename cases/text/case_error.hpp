#pragma once

// What is wrong with a case, for the person who wrote it. Owns the exception
// and the list that collects every mistake before it is thrown.

#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::cases {

/// Bad input from outside: the program ends with exit code 2. The message says
/// file and line (or --set), key, what was found, what is allowed, what is
/// nearest.
struct CaseError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Where something was written.
struct Place {
  std::string text; ///< "case.toml:12", or "--set" for an override
  int line = 0;     ///< in the file; 0 for an override
};

/// Every mistake of one case. The same mistake said twice is kept once: a
/// variant inherits keys, and with them their mistakes.
class Mistakes {
public:
  void add(const Place& place, const std::string& what);

  bool empty() const { return entries_.empty(); }

  /// @throws CaseError "N mistake(s) in the case file", a line each, overrides
  /// first and then in the order of the file; nothing if there are none.
  void throw_if_any() const;

private:
  struct Entry {
    int line;
    std::string text;
  };

  std::vector<Entry> entries_;
};

/// @throws CaseError  with this one mistake.
[[noreturn]] void throw_mistake(const Place& place, const std::string& what);

} // namespace asperity::cases
