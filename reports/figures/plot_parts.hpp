#pragma once

// Small pieces that several figures are put together from. Internal to them.

#include "reports/figures/series.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// "using" clause for one series of a CSV whose second column is its index:
/// rows of another have no x and are not drawn. Columns like "$5:4".
std::string of_series(std::size_t index, const std::string& columns);

/// One plot command of its parts.
std::string plot_of(const std::vector<std::string>& parts);

/// The next of 1, 2, 5 times a power of ten at or above `step`: between tics; 1
/// if `step` is not above 0.
double round_step(double step);

/// What a caption says of variants that are not drawn; empty if all are.
std::string joined_words(std::span<const Series> series);

/// A method's quantity by its name; one without a value if it has none.
const Estimate& quantity(const Series& series, const std::string& name);

/// The first that is not theory and has rows, or null.
const Series* first_numerical(std::span<const Series> series);

/// The theory that ran on the same case as `method`, or null.
const Series* theory_of(std::span<const Series> series, const Series& method);

/// Methods whose realisation 0 has maps, without a variant, "fem.hard", whose
/// maps would repeat those of its "fem".
std::vector<const results::MethodRecord*>
methods_with_maps(const results::Result& result);

/// The kept maps of realisation 0 that are whole: both of the size of their
/// grid, whose sides are known, and finite everywhere.
std::vector<const results::Fields*>
whole_maps(const results::MethodRecord& method);

/// A name as a file's, of the letters [a-z0-9-] and 60 of them at most:
/// "fem-hard" for "fem.hard".
std::string file_word(std::string name);

/// Colour and sign of the first, second and third load of a figure.
std::string load_color(std::size_t load);
std::string load_sign(std::size_t load);

/// First, middle and last of `count` things, each once.
std::vector<std::size_t> three_of(std::size_t count);

} // namespace asperity::reports
