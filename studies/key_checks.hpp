#pragma once

// Checks that several studies make of a case.

#include "input/reader/study_keys.hpp"
#include "input/reader/table_reader.hpp"

#include <string>

namespace asperity::studies {

/// Requires the theory that evaluates the tables of [magnification] and
/// [adhesion].
/// @param takes_maps  the study also describes a measured surface
void check_theory(cases::TableReader& table, const cases::Case& read,
                  bool takes_maps);

/// Requires from < to.
void check_ends(cases::TableReader& table, double from, double to);

/// Requires a method with fields.
/// @param what  which of them: "gap"
void require_fields(cases::TableReader& table, const cases::Case& read,
                    const std::string& what);

} // namespace asperity::studies
