#pragma once

// Lists all keys of a case with their values in SI units: those that the case
// gives, and the defaults of those that it does not give.

#include "input/text/node.hpp"
#include "input/types/case.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// One key of a case.
struct ResolvedKey {
  std::string path;    ///< "surface.length", "fem.hard.contact"
  Node value;          ///< number, word, list or table in SI units; a quantity
                       ///< whose reference unit is unknown stays as written
  std::string unit;    ///< SI unit of the value; "" for words, counts, tables
  std::string written; ///< as TOML, as the case gives it; "" for a default
};

/// Returns the keys of a case in the order of the reference of the case file.
/// Tables that the case does not have are left out, except those whose keys all
/// have defaults. A variant of a method lists the keys that it inherits, too.
///
/// @param scales  values of the reference units; one that is 0 or NaN is
///                unknown
std::vector<ResolvedKey> resolved_keys(const Case& read,
                                       const mechanics::Scales& scales);

} // namespace asperity::cases
