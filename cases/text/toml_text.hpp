#pragma once

// From TOML to nodes. Owns toml11 (its .cpp does), the syntax errors, and the
// overrides that --set lays over a file.

#include "cases/text/node.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// The whole file as one table.
/// @param path  for messages, not opened
/// @throws CaseError  the text is no TOML: "path:line: is not TOML: ...", or
///                    breaks a limit of toml_limits.hpp
Node parse_toml(const std::string& text, const std::string& path);

/// One TOML value: 3, "14 nm", { from = 1, to = 2 }.
/// @param path   of the key the value belongs to, "surface.length"
/// @throws CaseError  it is none
Node parse_toml_value(const std::string& text, const Place& place,
                      const std::string& path);

/// A key and a value as TOML on one line, as parse_toml_value reads it again.
std::string toml_key(const std::string& key);
std::string toml_value(const Node& node);

/// Lay "key.path=value" over the file. A key in double quotes may have dots and
/// equals signs in it. The value is read as TOML, and as a
/// string if it is none ("34 nm" needs no quotes); an empty value removes the
/// key. Tables on the way are made. What cannot be applied is a mistake.
/// @param place  of the override, for messages
void apply_override(Node& file, const std::string& override_text,
                    Mistakes& mistakes, const Place& place = {"--set", 0});

} // namespace asperity::cases
