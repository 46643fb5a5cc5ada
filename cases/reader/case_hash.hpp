#pragma once

// The fingerprint of a case: results with the same one answer the same case.

#include "cases/types/case.hpp"

#include <string>

namespace asperity::cases {

/// SHA-1 of Case::text (the file byte for byte and its overrides) by
/// boost::uuids::detail::sha1, as 40 hexadecimal digits: the same that
/// sha1sum prints. The path is not in it, and a map or spectrum the case names
/// is in it by its name only.
std::string case_hash(const Case& read);

} // namespace asperity::cases
