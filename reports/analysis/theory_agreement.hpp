#pragma once

// Where the theory does not agree with the other methods, load by load, and
// which of its assumptions is violated there.

#include "reports/analysis/warnings.hpp"

#include <numbers>
#include <span>
#include <vector>

namespace asperity::reports {

/// Published simulations of Gaussian surfaces have contact areas between that
/// of Persson, sqrt(8/pi), and that of Bush, Gibson and Thomas, sqrt(2 pi), at
/// light load. The ratio of the two is pi/2. Outside this factor in either
/// direction, the theory does not describe the contact.
inline constexpr double largest_area_scale = std::numbers::pi / 2.0;

/// The theory is considered not to describe a contact if its mean gap differs
/// by more than this, in h_rms, where 0.3 < u/h_rms < 1.5. The value is a
/// choice: on Gaussian surfaces the methods of this project differ from the
/// theory by a quarter of it.
inline constexpr double largest_gap_difference = 0.2;

/// Contacts of fewer nodes than this, over all realisations, are those of a few
/// asperities only.
inline constexpr double fewest_contact_nodes = 100.0;

/// Returns one warning of the kind "theory_area" and one of the kind
/// "theory_gap" for each method that differs from the theory at any load. The
/// area is the corrected one where the method has it, and both numbers are
/// means over the realisations. The consequence names the assumptions of the
/// theory that are violated.
/// @param others  the warnings of the same result about its surface
std::vector<Warning> theory_disagreements(const results::Result& result,
                                          const cases::Case& contact_case,
                                          std::span<const Warning> others);

} // namespace asperity::reports
