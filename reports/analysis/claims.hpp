#pragma once

// Quantifies statements that a paper makes about curves and surfaces in words
// or in passing: linearity, completeness, and where theory and simulation
// deviate. The quantities are compared with reference.csv by name; [expect]
// does not accept them.

#include "reports/analysis/summary.hpp"

#include <string>

namespace asperity::reports {

/// Upper end of the range of A/A_0 in which the area is compared with a
/// straight line.
inline constexpr double linear_area = 0.10;

/// Range of u/h_rms in which the separation is compared with a straight line in
/// ln p. These are light loads, but not so light that a small system has no
/// asperities left in contact.
inline constexpr double log_linear_from = 1.0;
inline constexpr double log_linear_to = 2.0;

/// Adds the following quantities where they are meaningful for the method:
///  - epsilon: Eq. (16) of Yang and Persson (2008) at the gamma of the case;
///    only for a theory
///  - log_linearity: largest |u - line|/h_rms of the least-squares line of u
///    against ln p through the rows with 1 <= u/h_rms <= 2, of which at least 4
///    are required. The window of gamma_slope is not used, because it ends
///    where the rows deviate from a line.
///  - gap_deviation_to_2: as gap_deviation, but for 0.2 < u/h_rms < 2
///  - area_linearity: largest |(A/p)/mean - 1| over the rows with
///    0 < A/A_0 <= linear_area, of which at least 2 are required, from the best
///    estimate of A
///  - area_at_highest_load: the best estimate of A/A_0 at the highest load
///  - pressure_offset, departure_low, departure_high: result of
///    departure_from() relative to the theory
///  - gap_shortfall: (u_theory - u)/h_rms at the lightest load that both curves
///    contain
///  - highest_asperity: largest height over h_rms; rms_height [m];
///    fractal_dimension: 3 - H from the straight line through ln C(ln q)
///    between roll-off and cut-off; all three of the surface used by the method
///  - highest_asperity, asperity_shortfall for a theory: see
///    add_tail_quantities()
///  - sum_rms_height [m], sum_spectrum_ratio: of two contact surfaces, see
///    two_surfaces.hpp
/// Each quantity is the mean over the realisations that provide it.
void add_claim_quantities(const results::Result& result,
                          const cases::Case& contact_case,
                          const results::MethodRecord& method,
                          const results::MethodRecord* reference,
                          MethodSummary& summary);

/// Returns one sentence that explains a quantity that reference.csv may name,
/// be it one of the above or one of [expect]. The sentence is empty for a name
/// that only the file itself defines.
std::string meaning_of(const std::string& quantity);

} // namespace asperity::reports
