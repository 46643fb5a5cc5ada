#pragma once

// Recognises the format of an instrument file by its first bytes, and names
// formats by the ending of the file name.

#include "mechanics/surface_spec.hpp"

#include <string>
#include <string_view>

namespace asperity::surfaces {

/// The format of a file.
/// @return  automatic for text, whose reader distinguishes matrices and lists;
///          convert for bytes that no own reader knows
mechanics::MapFormat recognised_format(std::string_view bytes);

/// Whether the bytes are the beginning of a zip archive.
bool is_zip(std::string_view bytes);

/// The name that a zip archive contains if it is an X3P file.
inline constexpr std::string_view x3p_member = "main.xml";

/// " (Igor binary wave)" for the ending .ibw, "" for an unknown ending.
std::string name_in_brackets(const std::string& path);

} // namespace asperity::surfaces
