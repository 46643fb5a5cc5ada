#pragma once

// Helper functions that several figures share. They are internal to the
// figures.

#include "reports/figures/gnuplot.hpp"
#include "reports/figures/series.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Returns a tic spacing: the smallest of 1, 2, 5 times a power of ten that is
/// not below `step`; 1 if `step` is not positive.
double round_step(double step);

/// Add the 95 % interval of the mean over the realisations around a curve,
/// u/h_rms and log10 p/E*, or p/E* and A/A_0; nothing if a row has no interval
/// or there are fewer than two rows.
void add_gap_band(ChartPanel& panel, std::span<const SeriesRow> rows,
                  const std::string& color);
void add_area_band(ChartPanel& panel, std::span<const SeriesRow> rows,
                   const std::string& color);

/// Returns the grid of two panels with one legend below them.
/// @param bottom  edge of the panels, a share of the figure's height
PanelGrid side_by_side(double bottom);

/// Returns a caption text that lists the variants that are not drawn; empty if
/// all are drawn.
std::string joined_words(std::span<const Series> series);

/// Returns a quantity of a method by its name, or an estimate without a value
/// if the method does not have it.
const Estimate& quantity(const Series& series, const std::string& name);

/// Returns the first series that is not a theory and has rows, or null.
const Series* first_numerical(std::span<const Series> series);

/// Returns the theory that ran on the same case as `method`, or null.
const Series* theory_of(std::span<const Series> series, const Series& method);

/// Returns the methods whose realisation 0 has maps. A variant such as
/// "fem.hard" is omitted if its maps would repeat those of its base method
/// "fem".
std::vector<const results::MethodRecord*>
methods_with_maps(const results::Result& result);

/// Returns the saved maps of realisation 0 that are complete: both fields have
/// the size of their grid, its side lengths are known, and all values are
/// finite.
std::vector<const results::Fields*>
whole_maps(const results::MethodRecord& method);

/// Converts a name to a file name of at most 60 characters from [a-z0-9-]:
/// "fem-hard" for "fem.hard".
std::string file_word(std::string name);

/// Return the colour and marker of the first, second and third load of a
/// figure.
const char* load_color(std::size_t load);
CurveStyle load_sign(std::size_t load);

/// Returns the indices of the first, middle and last of `count` items, without
/// repetition.
std::vector<std::size_t> three_of(std::size_t count);

} // namespace asperity::reports
