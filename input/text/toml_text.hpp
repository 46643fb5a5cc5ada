#pragma once

// Converts TOML to nodes. Encapsulates toml11 (in the source file), the syntax
// errors, and the overrides that --set applies to a file.

#include "input/text/node.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// Parses the whole file as one table.
///
/// @param path  for messages only; the file is not opened
/// @param name  what the text is, for messages
/// @throws input::InputError  the text is not TOML: "path:line: is not TOML:
///                            ...", or it breaks a limit of toml_limits.hpp
Node parse_toml(const std::string& text, const std::string& path,
                const std::string& name = "the case file");

/// Parses one TOML value, such as 3, "14 nm" or { from = 1, to = 2 }.
///
/// @param path  path of the key of this value, such as "surface.length"
/// @throws input::InputError  the text is not a TOML value
Node parse_toml_value(const std::string& text, const Place& place,
                      const std::string& path);

/// Write a key and a value as TOML on one line, in the form that
/// parse_toml_value() reads.
std::string toml_key(const std::string& key);
std::string toml_value(const Node& node);
std::string toml_value(const std::string& text);

/// Applies the override "key.path=value" to the file. A key in double quotes
/// may contain dots and equals signs. The value is read as TOML, or as a string
/// if it is not TOML ("34 nm" needs no quotes) or if the key is one of a string
/// (surface.channel=2); an empty value removes the key.
/// Missing tables are created. An override that cannot be applied is added to
/// `mistakes`.
///
/// @param place  place of the override for messages
void apply_override(Node& file, const std::string& override_text,
                    Mistakes& mistakes, const Place& place = {"--set", 0});

} // namespace asperity::cases
