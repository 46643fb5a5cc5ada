#pragma once

// The egg-box between its two ends, solved numerically once: a table that
// tests/theory/make_wave_2d_table.cpp prints and nobody edits.

#include <array>

namespace asperity::theory {

/// What is known at one load; the ends P = 0 and 1 have closed forms.
struct Wave2dRow {
  double load = 0.0;             ///< (p/p*)^{2/3} [1], ascending
  double area_fraction = 0.0;    ///< A/A_0 [1], to 1e-4
  double reduced_mean_gap = 0.0; ///< mean gap over the amplitude [1], to 1e-7
};

inline constexpr int n_wave_2d_rows = 50;
extern const std::array<Wave2dRow, n_wave_2d_rows> wave_2d_table;

} // namespace asperity::theory
