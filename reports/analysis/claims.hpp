#pragma once

// What a paper says of curves and surfaces in words or in passing, as numbers:
// linearity, completeness, where theory and simulation part. They stand in
// reference.csv under their names; [expect] does not know them.

#include "reports/analysis/summary.hpp"

#include <string>

namespace asperity::reports {

/// The area is held against a straight line up to here.
inline constexpr double linear_area = 0.10;

/// The separation is held against a straight line of ln p between these
/// u/h_rms: light loads, short of where a small system has no asperities left.
inline constexpr double log_linear_from = 1.0;
inline constexpr double log_linear_to = 2.0;

/// Adds, where they mean something for the method:
///  - epsilon: (16) at the case's gamma, of a theory
///  - log_linearity: largest |u - line|/h_rms of the least-squares line of u
///    against ln p through the rows with 1 <= u/h_rms <= 2, at least 4. Not of
///    the window of gamma_slope, which ends where the rows leave a line.
///  - gap_deviation_to_2: as gap_deviation, where 0.2 < u/h_rms < 2
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
