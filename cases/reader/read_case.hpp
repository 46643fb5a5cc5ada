#pragma once

// From a case file to a Case: the one door into the program for a parameter.

#include "cases/text/case_error.hpp"
#include "cases/types/case.hpp"

#include <string>
#include <vector>

namespace asperity::cases {

/// `fields = "all"`: more maps than any program has steps.
inline constexpr int all_fields = 1000000;

/// Read the case file at `path`, and the case it stands on if it names one as
/// its `base` (base_case.hpp): the result's text is then that of the base with
/// a "#--set" line for each key laid over it, and stands alone.
///
/// @param overrides  "key.path=value" each, as --set gives them: laid over the
///                   file before it is read, in order. The value is TOML, or
///                   else a string ("surface.length=20 um" needs no quotes);
///                   an empty value removes the key.
/// @throws CaseError  the file cannot be opened, is no TOML, or has mistakes:
///                    all of them, a line each. Also when the map or spectrum
///                    it names does not exist.
Case read_case(const std::string& path,
               const std::vector<std::string>& overrides = {});

/// The same from a text. `path` gives the folder that files are relative to,
/// the case's name, and the place in messages; nothing is opened. The text's
/// own "#--set" lines (case_text.hpp) come before `overrides`; both are in the
/// result's text, so read_case_text(c.text, c.path) is c again.
Case read_case_text(const std::string& text, const std::string& path,
                    const std::vector<std::string>& overrides = {});

} // namespace asperity::cases
