#pragma once

// Describes the curves of a figure for the browser: which columns of the
// figure's table are drawn against each other, and how. The numbers themselves
// stay in the table.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity::reports {

struct ChartAxis {
  std::string label;     ///< plain text, "u / h_rms"
  bool is_log = false;   ///< the axis is logarithmic at first
  bool is_log10 = false; ///< the column holds log10 of the quantity shown
  std::optional<double> low, high; ///< range at first; empty: that of the data
  std::vector<std::pair<double, std::string>> ticks = {}; ///< empty: numbers
};

/// A curve, or a straight line y = intercept + slope x without data.
struct ChartCurve {
  std::string label; ///< in the legend; empty: not listed there
  std::string color; ///< "#rrggbb"
  bool has_line = false;
  bool has_markers = false;
  bool has_steps = false;      ///< the line is a staircase
  bool is_area = false;        ///< the area between `low` and `high` is shaded
  double width = 1.0;          ///< of lines [px]
  int dash = 1;                ///< 1: solid; 2: dashed; others: dotted
  int marker = 6;              ///< gnuplot's number of the marker
  int index = 0;               ///< rows whose second column has this value
  int x = 0, y = 0;            ///< columns, counted from 1; 0: no data
  int low = 0, high = 0;       ///< columns of the interval; 0: none
  bool has_x_interval = false; ///< the interval is one of x, otherwise of y
  double factor = 1.0;         ///< y is multiplied by it
  bool is_on_second_axis = false;
  double slope = 0.0, intercept = 0.0; ///< of a line without data
};

/// A shaded range of x over the whole height, a line if the range is empty, or
/// a bar at one height.
struct ChartMark {
  double low = 0.0, high = 0.0; ///< in units of x; infinite: the edge
  double height = -1.0;         ///< 0: bottom, 1: top; negative: a range
  std::string color;
  std::string label; ///< beside a line
};

/// A shaded area, such as an interval around the curve of the same colour.
struct ChartBand {
  std::string color;
  std::vector<std::pair<double, double>> corners; ///< of a closed polygon
};

/// One pair of axes with its curves.
struct ChartPanel {
  ChartAxis x, y;
  std::optional<ChartAxis> second; ///< y axis on the right
  std::vector<ChartCurve> curves;
  std::vector<ChartMark> marks;
  std::vector<ChartBand> bands = {};
};

struct Chart {
  std::vector<ChartPanel> panels;
};

} // namespace asperity::reports
