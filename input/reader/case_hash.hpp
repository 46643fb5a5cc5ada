#pragma once

// The hash of a case: results with equal hashes belong to the same case.

#include "input/types/case.hpp"

#include <string>

namespace asperity::cases {

/// Returns the SHA-1 hash of Case::text (the file byte for byte and its
/// overrides), computed by boost::uuids::detail::sha1, as 40 hexadecimal digits
/// in the format of sha1sum. The hash does not include the path of the case,
/// and it includes the name, but not the content, of a map or spectrum file.
std::string case_hash(const Case& read);

} // namespace asperity::cases
