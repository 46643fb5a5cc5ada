#pragma once

// Helper functions that several figures share. They are internal to the
// figures.

#include "reports/figures/gnuplot.hpp"
#include "reports/figures/series.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// The scales by which the numbers of a figure are reduced, and whether its
/// axes show physical units first. A scale that the results do not share, or
/// that is not known, is NaN, and its axes have no physical units.
struct FigureScales {
  double contact_modulus = not_a_number; ///< E* [Pa]
  double rms_height = not_a_number;      ///< mean of the realisations [m]
  double rms_slope = not_a_number;       ///< likewise [1]
  double nominal_area = not_a_number;    ///< A_0 [m^2]
  bool is_physical = false; ///< a measured map, or loads given in SI units
};

/// @param entries  at least one
FigureScales figure_scales(std::span<const ReportEntry> entries);

/// The scales of one method on realisation 0.
FigureScales method_scales(const ReportEntry& entry,
                           const results::MethodRecord& method);

/// Return the axis of a reduced quantity, with physical units that suit its
/// largest value.
/// @param label  of the reduced number, markup
/// @param name   of the quantity, before its unit
ChartAxis pressure_axis(const std::string& label, const std::string& name,
                        double scale, double largest);
ChartAxis length_axis(const std::string& label, const std::string& name,
                      double scale, double largest);
ChartAxis area_axis(const FigureScales& scales, double largest);

/// The physical units of a density over an axis, "P_u [1/nm]"; none if the axis
/// has none.
std::optional<OtherUnits> density_units(const std::string& name,
                                        const ChartAxis& axis);

/// The axis of the nominal pressure over E* for these curves.
ChartAxis load_axis(std::span<const Series> series, const FigureScales& scales);

/// Returns "p = 40 MPa" or "p/E* = 0.000572": a load in the units that come
/// first.
std::string load_text(const FigureScales& scales, double nominal_pressure);

/// Puts the physical units of all axes and images first, if the figure's scales
/// say so.
void put_units(Figure& figure, const FigureScales& scales);

/// Returns a tic spacing: the smallest of 1, 2, 5 times a power of ten that is
/// not below `step`; 1 if `step` is not positive.
double round_step(double step);

/// Add the 95 % interval of the mean over the realisations around a curve,
/// u/h_rms and p/E*, or p/E* and A/A_0; nothing if a row has no interval
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

/// The same maps on the user's map, as figures show them. The record must
/// outlive the result.
std::vector<results::Fields> shown_maps(const results::MethodRecord& method);

/// Converts a name to a file name of at most 60 characters from [a-z0-9-]:
/// "fem-hard" for "fem.hard".
std::string file_word(std::string name);

/// True if the positive numbers, in ascending order, are spaced more evenly on
/// a logarithmic scale than on a linear one.
bool is_spaced_logarithmically(std::vector<double> numbers);

/// Return the colour and marker of the first, second and third load of a
/// figure.
const char* load_color(std::size_t load);
CurveStyle load_sign(std::size_t load);

/// Returns the marker of numbers of the surface: open if it was measured.
int map_sign(const ReportEntry& entry);

/// Returns the indices of the first, middle and last of `count` items, without
/// repetition.
std::vector<std::size_t> three_of(std::size_t count);

} // namespace asperity::reports
