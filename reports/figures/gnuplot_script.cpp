#include "reports/figures/gnuplot_script.hpp"

#include "base/plain_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <tuple>

namespace asperity::reports {
namespace {

constexpr const char* shared_settings = R"(set encoding utf8
set datafile separator comma
set border 3 linewidth 0.8 linecolor rgb '#444444'
set tics nomirror out scale 0.6 textcolor rgb '#333333'
set grid linewidth 0.5 linecolor rgb '#e4e4e4'
set key below center horizontal height 0.7 noopaque reverse Left samplen 1.6 spacing 1.25 textcolor rgb '#222222'
set errorbars 0
)";

// What a panel leaves set for those behind it.
constexpr const char* next_panel = R"(unset title
unset xlabel
unset ylabel
unset cblabel
unset logscale
unset arrow
unset object
unset label
set format
set xrange [*:*]
set yrange [*:*]
set offsets 0, 0, 0, 0
set xtics autofreq
set ytics autofreq
)";

// The palettes are perceptually uniform: sequential ones for non-negative
// quantities, and a diverging one from blue to red with a light centre for
// heights. explore.js has those of maps, too.
constexpr std::array<std::pair<const char*, const char*>, 4> palettes{
    {{"pressure",
      "maxcolors 128 defined (0 '#ffffff', 0.02 '#fdf2d0', 0.25 '#f6b65a', 0.5 "
      "'#dd6137', 0.75 '#98253f', 1 '#35102b')"},
     {"gap", "maxcolors 128 defined (0 '#08203a', 0.25 '#1f5a8c', 0.5 "
             "'#5b9fc7', 0.75 '#b5d7e8', 1 '#f7fbfd')"},
     {"height", "maxcolors 128 defined (0 '#1f3b66', 0.25 '#6f93bd', 0.5 "
                "'#f2efe8', 0.75 '#cf8a63', 1 '#7a2a1d')"},
     {"cells", "defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 "
               "'#3f9a4d')"}}};

std::string digits_of(double value) {
  return fmt::format("{:.10g}", value);
}

// gnuplot 5.4 misreads a doubled quote at the start of a quoted string. A quote
// is therefore replaced by a typographic one, which does not end the string.
std::string in_quotes(const std::string& markup) {
  std::string quoted = "'";
  for (const char c : printable(markup, markup.npos))
    quoted += c == '\'' ? std::string("’") : std::string(1, c);
  return quoted + "'";
}

std::string title_of(const std::string& label) {
  return label.empty() ? " notitle" : " title " + in_quotes(as_markup(label));
}

std::string range(std::optional<double> low, std::optional<double> high) {
  return fmt::format("[{}:{}]", low ? digits_of(*low) : "*",
                     high ? digits_of(*high) : "*");
}

/// @param name  "x", "y" or "y2"
std::string axis_settings(const ChartAxis& axis, const std::string& name) {
  std::string text;
  if (!axis.label.empty())
    text += fmt::format("set {}label {}\n", name, in_quotes(axis.label));
  if (axis.low || axis.high)
    text += fmt::format("set {}range {}\n", name, range(axis.low, axis.high));
  if (axis.is_log)
    text += fmt::format("set logscale {} {}\n", name, axis.base);
  if (axis.has_powers)
    text += fmt::format("set format {} '10^{{%T}}'\n", name);
  if (axis.tick_step > 0.0)
    text += fmt::format("set {}tics {}\n", name, digits_of(axis.tick_step));
  std::vector<std::string> ticks;
  for (const auto& [place, tick] : axis.ticks)
    ticks.push_back(in_quotes(tick) + " " + digits_of(place));
  if (!ticks.empty())
    text += fmt::format("set {}tics ({})\n", name, fmt::join(ticks, ", "));
  return text;
}

/// The axes opposite, in other units. Their ends follow from a plot that is
/// not shown, because gnuplot links no logarithmic axis.
std::string opposite_axes(const ChartPanel& panel, const std::string& plot) {
  std::string axes;
  for (const auto& [axis, name, large] :
       {std::tuple(&panel.x, "x2", "X"), std::tuple(&panel.y, "y2", "Y")})
    if (axis->other)
      axes += fmt::format(
          "set {0}range [GPVAL_{1}_MIN*{2}:GPVAL_{1}_MAX*{2}]\nset {0}tics\n"
          "set {0}label {3}\n{4}{5}",
          name, large, digits_of(axis->other->factor),
          in_quotes(axis->other->label),
          axis->is_log ? fmt::format("set logscale {}\n", name) : "",
          axis->is_log && axis->has_powers
              ? fmt::format("set format {} '10^{{%T}}'\n", name)
              : "");
  if (axes.empty())
    return "";
  return fmt::format("set border 15\nset terminal push\nset terminal unknown\n"
                     "{}set terminal pop\n"
                     "set xrange [GPVAL_X_MIN:GPVAL_X_MAX]\n"
                     "set yrange [GPVAL_Y_MIN:GPVAL_Y_MAX]\n{}",
                     plot, axes);
}

std::string mark_settings(const ChartMark& mark) {
  const auto place = [](double x) {
    return std::isfinite(x) ? "first " + digits_of(x)
                            : std::string(x < 0.0 ? "graph 0" : "graph 1");
  };
  if (mark.height >= 0.0)
    return fmt::format("set arrow from {}, graph {} to {}, graph {} nohead "
                       "linewidth 2.5 linecolor rgb '{}'\n",
                       place(mark.low), digits_of(mark.height),
                       place(mark.high), digits_of(mark.height), mark.color);
  if (mark.low != mark.high)
    return fmt::format(
        "set object rectangle from {}, graph 0 to {}, graph 1 "
        "behind fillcolor rgb '{}' fillstyle solid {} noborder\n",
        place(mark.low), place(mark.high), mark.color, digits_of(mark.opacity));
  return fmt::format(
      "set arrow from {0}, graph 0 to {0}, graph 1 nohead dashtype 3 linewidth "
      "1.2 linecolor rgb '{1}' back\nset label {2} at {0}, graph 0.03 rotate "
      "by "
      "90 offset -0.6,0 textcolor rgb '{1}' font ',10'\n",
      place(mark.low), mark.color, in_quotes(as_markup(mark.label)));
}

std::string image_settings(const ChartImage& image) {
  std::string text = "unset grid\n";
  if (!image.has_cells)
    text += "set border 15 linewidth 0.6\nset tics out scale 0.4\nset cbtics "
            "scale 0.4\n";
  if (image.proportions != Proportions::filling)
    text += image.proportions == Proportions::square ? "set size square\n"
                                                     : "set size ratio -1\n";
  for (const auto& [name, colors] : palettes)
    if (image.colors == name)
      text += fmt::format("set palette {}\n", colors);
  if (image.low || image.high)
    text += "set cbrange " + range(image.low, image.high) + "\n";
  if (image.tick_step > 0.0)
    text += "set cbtics " + digits_of(image.tick_step) + "\n";
  if (!image.label.empty())
    text += "set cblabel " + in_quotes(image.label) + "\n";
  for (const auto& [place, note] : image.notes)
    text += fmt::format("set label {} at {},{} center front font ',10' "
                        "textcolor rgb '#ffffff'\n",
                        in_quotes(as_markup(note)), digits_of(place.first),
                        digits_of(place.second));
  return text;
}

std::string legend_settings(const ChartPanel& panel) {
  return panel.has_narrow_legend ? "set key maxcols 2\n" : "";
}

std::string image_plot(const ChartImage& image, const std::string& name) {
  if (!image.map.empty())
    return fmt::format("'{}-{}.csv' nonuniform matrix with image notitle", name,
                       image.map);
  return fmt::format("'{}.csv' using {}:{}:{}{} notitle", name, image.x,
                     image.y, image.has_cells ? "(0.5):(0.5):" : "",
                     std::to_string(image.value) +
                         (image.has_cells
                              ? " with boxxyerror palette fillstyle solid "
                                "noborder"
                              : " with image"));
}

std::string style_of(const ChartCurve& curve) {
  const CurveStyle& style = curve.style;
  if (curve.is_area)
    return fmt::format(" with filledcurves linecolor rgb '{}' fillstyle "
                       "transparent solid 0.2 noborder",
                       style.color);
  const char* const kind = curve.has_x_interval ? "xerrorbars"
                           : curve.low > 0      ? "yerrorlines"
                           : curve.has_steps    ? "steps"
                           : !style.has_markers ? "lines"
                           : style.has_line     ? "linespoints"
                                                : "points";
  return fmt::format(
      " with {} linewidth {}{} linecolor rgb '{}'{}", kind,
      digits_of(style.width),
      style.dash == 1 ? "" : fmt::format(" dashtype {}", style.dash),
      style.color,
      style.has_markers
          ? fmt::format(" pointtype {} pointsize {}", style.marker,
                        digits_of(style.marker_size))
          : "");
}

/// The values of the rows of a table, whose first line holds names.
std::string row_plot(const ChartCurve& curve, const std::string& name,
                     bool is_first) {
  const std::string rows = fmt::format("'{}.csv' every ::1 using ", name);
  const std::string title = title_of(curve.label);
  return curve.style.has_markers
             ? fmt::format("{}($0):{}{}{}", rows, curve.y, style_of(curve),
                           title)
             : fmt::format("{}{}{} linecolor rgb '{}'{}", rows, curve.y,
                           is_first ? ":xtic(1)" : "", curve.style.color,
                           title);
}

std::string curve_plot(const ChartCurve& curve, const std::string& name) {
  std::string source;
  if (curve.x == 0) {
    source = digits_of(curve.intercept);
    if (curve.slope != 0.0)
      source += fmt::format("+{}*x", digits_of(curve.slope));
  } else {
    const auto scaled = [](int column, double factor) {
      return factor == 1.0 ? std::to_string(column)
                           : fmt::format("({}*${})", digits_of(factor), column);
    };
    std::vector<std::string> columns; // of y, of its interval
    if (!curve.is_area)
      columns.push_back(scaled(curve.y, curve.factor));
    const double of_interval =
        curve.has_x_interval ? curve.x_factor : curve.factor;
    if (curve.low > 0) {
      columns.push_back(scaled(curve.low, of_interval));
      columns.push_back(scaled(curve.high, of_interval));
    }
    // Rows of other curves have x = NaN and are not drawn.
    const std::string x =
        curve.x_factor == 1.0
            ? fmt::format("${}", curve.x)
            : fmt::format("{}*${}", digits_of(curve.x_factor), curve.x);
    source = fmt::format("'{}.csv' using ($2=={} ? {} : NaN):{}", name,
                         curve.index, x, fmt::join(columns, ":"));
  }
  return source + (curve.is_on_second_axis ? " axes x1y2" : "") +
         style_of(curve) + title_of(curve.label);
}

/// @param n_bands  of the panels before it
std::string plot_command(const ChartPanel& panel, const std::string& name,
                         std::size_t n_bands) {
  std::vector<std::string> parts;
  for (const ChartBand& band : panel.bands)
    parts.push_back(fmt::format(
        "'{}-bands.csv' index {} using 1:2 with filledcurves closed fillcolor "
        "rgb '{}' fillstyle transparent solid 0.18 noborder notitle",
        name, n_bands++, band.color));
  if (panel.image)
    parts.push_back(image_plot(*panel.image, name));
  for (const ChartCurve& curve : panel.curves)
    parts.push_back(curve.is_per_row ? row_plot(curve, name, parts.empty())
                                     : curve_plot(curve, name));
  return fmt::format("plot {}\n", fmt::join(parts, ", \\\n  "));
}

std::string panel_settings(const ChartPanel& panel) {
  std::string text = axis_settings(panel.x, "x") + axis_settings(panel.y, "y");
  if (panel.second)
    text += axis_settings(*panel.second, "y2") + "set y2tics\nset border 11\n";
  if (!panel.title.empty())
    text += "set title " + in_quotes(panel.title) + "\n";
  if (!panel.offsets.empty())
    text += "set offsets " + panel.offsets + "\n";
  if (panel.sides)
    text += fmt::format("set lmargin at screen {}\nset rmargin at screen {}\n",
                        digits_of(panel.sides->first),
                        digits_of(panel.sides->second));
  for (const ChartMark& mark : panel.marks)
    text += mark_settings(mark);
  if (panel.has_zero_line)
    text += "set arrow from graph 0, first 0 to graph 1, first 0 nohead "
            "linewidth 0.8 linecolor rgb '#888888'\n";
  if (!panel.curves.empty() && panel.curves.front().is_per_row)
    text += "set style data histogram\nset style histogram rowstacked\nset "
            "style fill solid 0.85 border -1\nset boxwidth 0.6\n";
  return text + (panel.image ? image_settings(*panel.image) : "") +
         legend_settings(panel);
}

std::string multiplot(const PanelGrid& grid) {
  std::string text =
      fmt::format("set multiplot layout {},{}", grid.rows, grid.columns);
  if (grid.margins)
    text += fmt::format(" margins {:.4g}", fmt::join(*grid.margins, ","));
  return text +
         fmt::format(" spacing {:.4g},{:.4g}\n", grid.across, grid.down) +
         (grid.has_shared_legend
              ? "set key at screen 0.5, 0.02 bottom center vertical maxrows 1\n"
              : "");
}

} // namespace

std::string gnuplot_script(const Figure& figure) {
  std::string script = shared_settings + figure.arrangement;
  if (figure.grid)
    script += multiplot(*figure.grid);
  std::size_t n_bands = 0;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const ChartPanel& panel = figure.panels[i];
    if (i > 0)
      script += next_panel;
    if (i > 0 && figure.grid && figure.grid->has_shared_legend)
      script += "unset key\n";
    const std::string plot = plot_command(panel, figure.name, n_bands);
    script += panel_settings(panel);
    // gnuplot leaves no room for the label of the colours.
    if (!figure.grid && panel.image && !panel.image->label.empty() &&
        !panel.sides)
      script += "set rmargin at screen 0.74\n";
    if (!figure.grid)
      script += opposite_axes(panel, plot);
    script += plot;
    n_bands += panel.bands.size();
  }
  return script + (figure.grid ? "unset multiplot\n" : "");
}

std::string band_file(const Figure& figure) {
  std::string text;
  for (const ChartPanel& panel : figure.panels)
    for (const ChartBand& band : panel.bands) {
      text += text.empty() ? "" : "\n\n";
      for (const auto& [x, y] : band.corners)
        text += fmt::format("{:.8g},{:.8g}\n", x, y);
    }
  return text;
}

} // namespace asperity::reports
