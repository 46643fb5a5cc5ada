#include "reports/figures/journal_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity::reports {
namespace {

constexpr double printers_point = 25.4e-3 / 72.0; // [m]

// Sizes in multiples of the font size.
constexpr double space_beside = 5.6;  // label and numbers of a vertical axis
constexpr double space_of_colors = 9.0; // bar, numbers and label
constexpr double space_below = 3.7;   // those of the horizontal axis
constexpr double free_edge = 0.9;     // half a number sticks out
constexpr double key_row = 1.15;      // of the font size of the legend
constexpr double key_sample = 3.5;    // line or marker, and the blank beside it
constexpr double key_gap = 1.0;       // between the axis and the legend
constexpr double letter_width = 0.58; // mean width

constexpr double highest_ratio = 1.35; // times the width

/// Number of characters of UTF-8 text.
double n_letters(const std::string& text) {
  return static_cast<double>(std::ranges::count_if(text, [](char c) {
    return (static_cast<unsigned>(c) & 0xC0U) != 0x80U;
  }));
}

/// A legend below the axis.
struct KeyBelow {
  int columns = 1;
  double height = 0.0; // [m]
};

KeyBelow key_below(const ChartPanel& panel, double width, double size) {
  double longest = 0.0;
  int entries = 0;
  for (const ChartCurve& curve : panel.curves) {
    longest = std::max(longest, n_letters(curve.label));
    entries += curve.label.empty() ? 0 : 1;
  }
  const double entry = size * (key_sample + letter_width * longest);
  KeyBelow key;
  key.columns = std::clamp(static_cast<int>(width / entry), 1,
                           panel.has_narrow_legend ? 2 : 4);
  key.height =
      key_row * size * std::ceil(static_cast<double>(entries) / key.columns);
  return key;
}

/// Enlarges the margins of a figure of several panels and the space between
/// them.
void widen_margins(PanelGrid& grid, double factor) {
  if (!grid.margins)
    return;
  auto& [left, right, bottom, top] = *grid.margins;
  left *= factor;
  right = 1.0 - factor * (1.0 - right);
  bottom *= factor;
  top = 1.0 - factor * (1.0 - top);
  grid.across *= factor;
  grid.down *= factor;
}

/// Leaves room for the labels of axes and colours beside an image.
/// @param size  of the font, over the width of the figure
void place_image(ChartPanel& panel, double size) {
  double longest = 0.0;
  for (const auto& [place, name] : panel.y.ticks)
    longest = std::max(longest, n_letters(name));
  panel.sides = {size * std::max(space_beside, 3.0 + letter_width * longest),
                 1.0 - size * space_of_colors};
}

} // namespace

JournalLayout journal_layout(const Figure& figure, double width,
                             double font_size, double line_height) {
  JournalLayout layout{width * figure.height / figure.width, figure};
  const double size = font_size * printers_point;
  if (figure.grid) // in a report, text has 12 px
    widen_margins(*layout.figure.grid, size / width / (12.0 / figure.width));
  if (figure.panels.size() != 1 || figure.grid)
    return layout;
  if (figure.panels.front().image) {
    place_image(layout.figure.panels.front(), size / width);
    return layout;
  }
  ChartPanel& panel = layout.figure.panels.front();
  const double key_size = (font_size - 1.0) * printers_point;
  const double right = (panel.second ? space_beside : free_edge) * size;
  const double top = free_edge * size;
  double left = space_beside * size;
  const KeyBelow key = key_below(panel, width - left - right, key_size);
  double bottom = space_below * size + key.height + key_gap * size;
  const double across = (width - left - right) / width;
  if (across > least_plot_share)
    layout.height = std::max(
        layout.height,
        std::min(highest_ratio * width,
                 (top + bottom) / (1.0 - 1.01 * least_plot_share / across)));
  // Higher lines of text move the labels outwards; gnuplot leaves out a label
  // for which the space is too small.
  left += 3.0 * (line_height - 1.0) * size;
  bottom += 4.0 * (line_height - 1.0) * size;
  layout.figure.arrangement = fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n"
      "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
      "set xlabel offset 0,0.3\nset ylabel offset 0.65,0\nset key font ',{:g}' "
      "height 0 samplen 1.4 spacing {:.3g} {}\n",
      left / width, 1.0 - right / width, 1.0 - top / layout.height,
      bottom / layout.height, font_size - 1.0, 1.0 / line_height,
      fmt::format("at screen 0.5, screen {:.4f} center bottom horizontal "
                  "maxcols {}",
                  0.4 * size / layout.height, key.columns));
  panel.x.other = panel.y.other = std::nullopt;
  return layout;
}

} // namespace asperity::reports
