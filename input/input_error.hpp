#pragma once

// Errors in an input file, reported to its author. Defines the exception and
// the list that collects all mistakes before it is thrown.

#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::input {

/// Invalid user input. The program ends with exit code 2. The message gives the
/// file and line (or --set), the key, what was found, what is allowed and the
/// nearest valid alternative.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The place in which a value is written.
struct Place {
  std::string text; ///< "case.toml:12", or "--set" for an override
  int line = 0;     ///< line in the file; 0 for an override
};

/// Collects all mistakes of one file. Identical mistakes are stored once: a
/// variant inherits keys, and with them their mistakes.
class Mistakes {
public:
  void add(const Place& place, const std::string& what);

  bool empty() const { return entries_.empty(); }

  /// Throws if there are any mistakes.
  ///
  /// @param where  in what the mistakes are
  /// @throws InputError  "N mistake(s) in the case file", one line each: first
  ///                     the overrides, then in the order of the file
  void throw_if_any(const std::string& where = "the case file") const;

private:
  struct Entry {
    int line;
    std::string text;
  };

  std::vector<Entry> entries_;
};

/// Throws a single mistake.
///
/// @throws InputError  with this mistake only
[[noreturn]] void throw_mistake(const Place& place, const std::string& what,
                                const std::string& where = "the case file");

} // namespace asperity::input
