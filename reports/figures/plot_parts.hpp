#pragma once

// Helper functions that several figures share. They are internal to the
// figures.

#include "reports/figures/gnuplot.hpp"
#include "reports/figures/series.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Returns the "using" clause for one series of a CSV file whose second column
/// is the series index. Rows of other series have x = NaN and are not drawn.
/// `columns` is written as "$5:4".
std::string of_series(std::size_t index, const std::string& columns);

/// Joins the parts into one plot command.
std::string plot_of(const std::vector<std::string>& parts);

/// Returns a tic spacing: the smallest of 1, 2, 5 times a power of ten that is
/// not below `step`; 1 if `step` is not positive.
double round_step(double step);

/// Return the 95 % interval of the mean over the realisations around a curve,
/// u/h_rms and log10 p/E*, or p/E* and A/A_0, as a closed polygon of rows
/// "x,y"; empty if a row has no interval or there are fewer than two rows.
std::string gap_band(std::span<const SeriesRow> rows);
std::string area_band(std::span<const SeriesRow> rows);

/// The bands of a figure, for Figure::maps and the start of its plots.
class Bands {
public:
  /// Adds a polygon, unless it is empty.
  void add(const std::string& polygon, const std::string& rgb);

  /// Adds the file of the polygons to the figure and puts their plots before
  /// the others.
  void add_to(Figure& figure, std::vector<std::string>& plots) const;

  bool empty() const { return colors_.empty(); }

private:
  std::string polygons_; ///< one block each, which gnuplot selects by its index
  std::vector<std::string> colors_;
};

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
std::string load_color(std::size_t load);
std::string load_sign(std::size_t load);

/// Returns the indices of the first, middle and last of `count` items, without
/// repetition.
std::vector<std::size_t> three_of(std::size_t count);

} // namespace asperity::reports
