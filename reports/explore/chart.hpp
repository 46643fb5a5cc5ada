#pragma once

// A figure as data: panels with axes, curves, marks and images.
// gnuplot_script() writes them for paper and explore_data() for the browser.
// The numbers of curves stay in the table of the figure.
//
// Markup is gnuplot's: "h_{rms}", "10^4"; a backslash takes its meaning from
// the character behind it.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity::reports {

/// Other units of the quantity of an axis: physical ones of a reduced number,
/// or the reverse.
struct OtherUnits {
  std::string label;   ///< markup, with the unit: "p [MPa]"
  double factor = 1.0; ///< > 0: a number in these units over that of the axis
};

struct ChartAxis {
  std::string label = {}; ///< markup, with the unit: "x [µm]"
  std::optional<double> low = {}, high = {}; ///< range; empty: that of the data
  bool is_log = false;
  int base = 10;           ///< of a logarithmic axis on paper
  bool has_powers = false; ///< numbers on paper are powers of ten
  double tick_step = 0.0;  ///< on paper; 0: chosen by gnuplot
  std::vector<std::pair<double, std::string>> ticks = {}; ///< with markup;
                                                          ///< empty: numbers
  /// On paper the axis opposite, in a figure of one panel; a choice in the
  /// browser.
  std::optional<OtherUnits> other = {};
};

struct CurveStyle {
  std::string color = {}; ///< "#rrggbb"
  bool has_line = false;
  bool has_markers = false;
  double width = 1.0;       ///< of lines [px]
  int dash = 1;             ///< 1: solid; 2: dashed; others: dotted
  int marker = 6;           ///< gnuplot's number
  double marker_size = 1.0; ///< of gnuplot's own
};

/// A curve, a straight line y = intercept + slope x without data, or one value
/// per row of the table.
struct ChartCurve {
  std::string label = {}; ///< plain text in the legend; empty: not listed there
  CurveStyle style = {};
  int index = 0;               ///< rows whose second column has this value
  int x = 0, y = 0;            ///< columns, counted from 1; x = 0: no data
  int low = 0, high = 0;       ///< columns of the interval; 0: none
  bool has_x_interval = false; ///< the interval is one of x, otherwise of y
  bool has_steps = false;      ///< the line is a staircase
  bool is_area = false;        ///< the area between `low` and `high` is shaded
  bool is_on_second_axis = false;
  bool is_per_row = false; ///< y of every row against its number, named by its
                           ///< first column; bars on each other if it has no
                           ///< markers. On paper only
  double factor = 1.0;     ///< y is multiplied by it
  double x_factor = 1.0;   ///< x is multiplied by it
  double slope = 0.0, intercept = 0.0; ///< of a line without data
};

/// A shaded range of x over the whole height, a line if the range is empty, or
/// a bar at one height.
struct ChartMark {
  double low = 0.0, high = 0.0; ///< in units of x; infinite: the edge
  double height = -1.0;         ///< 0: bottom, 1: top; negative: a range
  std::string color = {};
  std::string label = {}; ///< plain text beside a line
  double opacity = 0.06;  ///< of a shaded range on paper
};

/// A shaded area, such as an interval around the curve of the same colour.
struct ChartBand {
  std::string color;
  std::vector<std::pair<double, double>> corners; ///< of a closed polygon
};

/// Shape of an image: one scale on both axes, a square, or what fills the
/// panel.
enum class Proportions { equal_scales, square, filling };

/// A map on paper; the browser has a MapStack instead.
struct ChartImage {
  std::string map = {};        ///< suffix of a matrix in Figure::maps; empty:
  int x = 0, y = 0, value = 0; ///< columns of the table
  bool has_cells = false;      ///< a square of side 1 around each point
  std::string colors = {};     ///< "pressure", "gap", "height", "cells"
  std::optional<double> low = {}, high = {}; ///< ends of the colours
  double tick_step = 0.0; ///< of the colours; 0: chosen by gnuplot
  std::string label = {}; ///< of the colours, markup
  Proportions proportions = Proportions::equal_scales;
  std::vector<std::pair<std::pair<double, double>, std::string>> notes =
      {}; ///< plain texts at points x, y
};

/// One pair of axes with its curves.
struct ChartPanel {
  ChartAxis x = {}, y = {};
  std::optional<ChartAxis> second = {}; ///< y axis on the right
  std::vector<ChartCurve> curves = {};
  std::vector<ChartMark> marks = {};
  std::vector<ChartBand> bands = {};
  // What follows is for paper only.
  std::optional<ChartImage> image = {};
  bool has_zero_line = false; ///< a thin line at y = 0 over the whole width
  std::string title = {};     ///< markup
  std::string offsets = {};   ///< free space left, right, above and below the
                            ///< data, in gnuplot's words: "0, 0, graph 0.1, 0"
  std::optional<std::pair<double, double>> sides =
      {};                         ///< of the plot, shares of the figure's width
  bool has_narrow_legend = false; ///< of at most two columns

  /// Adds the curve with these columns. In the legend it has another symbol or
  /// dash if an earlier one of this colour has that of the style.
  ChartCurve& add(std::string label, CurveStyle style, std::size_t index,
                  int x_column, int y_column);
};

/// Changes the axes that have other units to these; the units before are then
/// the other ones. Marks, bands and lines without data keep their places.
void use_other_units(ChartPanel& panel);

/// Returns the curve with these columns.
/// @param label  plain text; empty: not in the legend
/// @param index  of its rows
ChartCurve curve(std::string label, CurveStyle style, std::size_t index, int x,
                 int y);

/// Returns a horizontal line without data.
ChartCurve level(double y, CurveStyle style, std::string label = "");

CurveStyle line(std::string color, double width = 1.0, int dash = 1);
CurveStyle markers(std::string color, int marker, double size,
                   double width = 1.0);

/// Returns markers joined by a line.
CurveStyle joined(CurveStyle markers);

/// Returns the number as it is written with so many digits, so that a figure
/// has the same on paper and in the browser.
double rounded(double number, int digits);

/// Returns markup that shows the text literally.
std::string as_markup(const std::string& text);

/// Converts markup to plain text: "h_{rms}" to "h_rms", "A_0" to "A₀", "m^4" to
/// "m⁴".
std::string plain_label(const std::string& markup);

} // namespace asperity::reports
