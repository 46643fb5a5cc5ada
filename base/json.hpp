#pragma once

// JSON: its writer and its reader are compiled once, in json.cpp, because each
// takes the compiler a second.

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace asperity {

/// The text of a value, members in their order, or with nlohmann::json sorted.
/// @param indent  blanks for each level; -1: everything on one line
/// Bytes that are no UTF-8 are written as U+FFFD.
std::string text_of_json(const nlohmann::ordered_json& value, int indent);
std::string text_of_json(const nlohmann::json& value, int indent);

/// The same in ASCII: other characters are written as \uXXXX.
std::string ascii_of_json(const nlohmann::ordered_json& value);

/// The value of a text.
/// @throws nlohmann::ordered_json::exception  it is not JSON
nlohmann::ordered_json json_of_text(std::string_view text);

} // namespace asperity
