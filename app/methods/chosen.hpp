#pragma once

// What of a case a run is asked for: which methods, on how many realisations,
// with which maps.

#include "cases/types/case.hpp"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace asperity::app {

/// @param names     of methods or kinds; empty: all
/// @param is_exact  names of methods alone: "fem" is not "fem.hard"
/// @throws cases::CaseError  the case has no such method; names the nearest
std::vector<cases::MethodSpec>
chosen_methods(const cases::Case& rough_case,
               const std::vector<std::string>& names, bool is_exact = false);

/// True for a theory, whose spectrum needs no surface.
bool takes_formula(const cases::MethodSpec& method);

/// One for a theory by the formula, which is the same on all.
int n_realizations(const cases::Case& rough_case,
                   const cases::MethodSpec& method);

/// Load steps, spread evenly over the program, whose maps are kept.
std::set<std::size_t> steps_with_fields(const cases::Case& rough_case);

/// True for [fem] with solver = "full".
bool is_whole_block(const cases::MethodSpec& method);

/// The heaviest of the steps with fields, where a whole block's own section is
/// taken; none for other methods or where the case asks for no stress inside.
/// @param scales  of the method's surface
std::optional<std::size_t> step_with_section(const cases::Case& rough_case,
                                             const cases::MethodSpec& method,
                                             const cases::Scales& scales);

} // namespace asperity::app
