#pragma once

// What a paper says of curves and surfaces in words or in passing, as numbers:
// linearity, completeness, where theory and simulation part. They stand in
// reference.csv under their names; [expect] does not know them.

#include "reports/summary.hpp"

#include <string>

namespace asperity::reports {

/// The area is held against a straight line up to here.
inline constexpr double linear_area = 0.10;

/// Adds, where they mean something for the method:
///  - epsilon: (16) at the case's gamma, of a theory
///  - log_linearity: largest |u - fitted line|/h_rms in the window of
///    gamma_slope, mean over realisations
///  - area_linearity: largest |(A/p)/mean - 1| over the rows with
///    0 < A/A_0 <= linear_area, at least 2, by the best estimate of A
///  - area_at_highest_load: the best estimate of A/A_0 there
///  - pressure_offset, departure_low, departure_high: departure_from() theory
///  - gap_shortfall: (theory's u - u)/h_rms at the lightest load both have
///  - highest_asperity: largest height over h_rms; rms_height [m];
///    fractal_dimension: 3 - H of the straight line through ln C(ln q) between
///    roll-off and cut-off: of the surface the method ran on
///  - highest_asperity, asperity_shortfall of a theory: add_tail_quantities()
///  - sum_rms_height [m], sum_spectrum_ratio: of two faces, see two_faces.hpp
/// Each is the mean over the realisations that have it.
void add_claim_quantities(const results::Result& result,
                          const cases::Case& contact_case,
                          const results::MethodRecord& method,
                          const results::MethodRecord* reference,
                          MethodSummary& summary);

/// One sentence on a quantity that reference.csv may name: one of these, or of
/// [expect]; empty for a name of the file's own.
std::string meaning_of(const std::string& quantity);

} // namespace asperity::reports
