#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// SHA-256 of a text, as 64 hexadecimal digits.
std::string content_hash(std::string_view text);

/// MD5 of a text, as 32 hexadecimal digits: for file formats that prescribe it,
/// not for security.
std::string md5_hash(std::string_view text);

} // namespace asperity
