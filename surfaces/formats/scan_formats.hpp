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

/// " (Igor binary wave)" for the ending .ibw, "" for an unknown ending.
std::string name_in_brackets(const std::string& path);

} // namespace asperity::surfaces
