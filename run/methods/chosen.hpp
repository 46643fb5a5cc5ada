#pragma once

// Determines which parts of a case a run computes: which methods, how many
// realisations and which saved fields.

#include "input/types/case.hpp"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace asperity::methods {

/// The methods that a run is asked for.
struct AskedMethods {
  std::vector<std::string> names = {}; ///< or kinds; empty: all of the case
  bool is_exact = false; ///< names only: "fem" does not include "fem.hard"
};

/// Returns the methods that a run uses, in the order of the case.
///
/// @throws input::InputError  the case has no such method; the message gives
///                            the nearest name
std::vector<cases::MethodSpec> chosen_methods(const cases::Case& contact_case,
                                              const AskedMethods& asked);

/// Returns the number of realisations for a method: one for a theory that uses
/// the formula, because all realisations are identical.
int n_realizations(const cases::Case& contact_case,
                   const cases::MethodSpec& method);

/// Returns the realisations that a run computes with a method, in their order.
///
/// @param only  computes only these; empty: all of the method
std::vector<int> realizations_of(const cases::Case& contact_case,
                                 const cases::MethodSpec& method,
                                 const std::set<int>& only);

/// Returns the load steps whose fields are saved, spread evenly over the
/// loading path, and those of the tangential traction.
std::set<std::size_t> steps_with_fields(const cases::Case& contact_case);

/// Returns true for [fem] with solver = "full".
bool is_full_block(const cases::MethodSpec& method);

/// Returns true for a full block of one body with contact at its nodes, which
/// computes on its own mesh what the contact conducts.
bool conducts_in_block(const cases::MethodSpec& method);

/// Returns whether the case asks such a block for that.
bool asks_conduction(const cases::Case& contact_case,
                     const cases::MethodSpec& method);

/// Returns the contact law of a method whose pressures are the answer of one
/// surface operator in a convex problem; null for full blocks, adhesion, atoms
/// and theory.
const mechanics::ContactSettings*
convex_contact(const cases::MethodSpec& method);

/// Returns the most heavily loaded of the steps with saved fields, at which a
/// full block records its own stress section. Returns nothing for other
/// methods, or if the case does not request the subsurface stress.
///
/// @param scales  scales of the surface of the method
std::optional<std::size_t> step_with_section(const cases::Case& contact_case,
                                             const cases::MethodSpec& method,
                                             const mechanics::Scales& scales);

} // namespace asperity::methods
