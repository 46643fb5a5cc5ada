#include "reports/figures/journal_layout.hpp"

#include "reports/explore/chart_of_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace asperity::reports {
namespace {

constexpr double printers_point = 25.4e-3 / 72.0; // [m]

// Sizes in multiples of the font size.
constexpr double space_beside = 5.6;  // label and numbers of a vertical axis
constexpr double space_below = 3.7;   // those of the horizontal axis
constexpr double free_edge = 0.9;     // half a number sticks out
constexpr double key_row = 1.15;      // of the font size of the legend
constexpr double key_sample = 3.5;    // line or marker, and the blank beside it
constexpr double key_gap = 0.7;       // between the axis and the legend
constexpr double letter_width = 0.58; // mean width

constexpr double highest_ratio = 1.3; // times the width

/// Number of characters of UTF-8 text.
double n_letters(const std::string& text) {
  return static_cast<double>(std::ranges::count_if(text, [](char c) {
    return (static_cast<unsigned>(c) & 0xC0U) != 0x80U;
  }));
}

bool has(const std::string& script, const char* words) {
  return script.find(words) != std::string::npos;
}

/// Entries of the legend.
std::vector<std::string> titles_in(const std::string& script) {
  const std::string before = " title '";
  std::vector<std::string> titles;
  for (std::size_t at = script.find(before); at != std::string::npos;
       at = script.find(before, at)) {
    at += before.size();
    const std::string title = script.substr(at, script.find('\'', at) - at);
    if (!title.empty())
      titles.push_back(plain_label(title));
  }
  return titles;
}

/// A legend below the axis.
struct KeyBelow {
  int columns = 1;
  double height = 0.0; // [m]
};

KeyBelow key_below(const std::string& script, double width, double size) {
  const std::vector<std::string> titles = titles_in(script);
  double longest = 0.0;
  for (const std::string& title : titles)
    longest = std::max(longest, n_letters(title));
  const double entry = size * (key_sample + letter_width * longest);
  KeyBelow key;
  key.columns = std::clamp(static_cast<int>(width / entry), 1,
                           has(script, "set key maxcols 2") ? 2 : 4);
  key.height = key_row * size *
               std::ceil(static_cast<double>(titles.size()) / key.columns);
  return key;
}

/// Corner that the curves of a figure leave free; empty: none.
std::string free_corner(const Figure& figure) {
  const std::string& name = figure.name;
  if (name == "pressure-gap" || name.starts_with("sweep-pressure-gap"))
    return "top right"; // the pressure falls with the separation
  if (name == "area-pressure" || name.starts_with("sweep-area-pressure"))
    return "bottom right"; // the area grows with the pressure
  return has(figure.script, "set key top right") ? "top right" : "";
}

/// Raises the upper end of "set yrange [0:END]" so that the share of the height
/// above all curves is free for a legend.
std::string with_room(std::string script, double share) {
  const std::string words = "set yrange [0:";
  const std::size_t at = script.find(words);
  if (at == std::string::npos)
    return script;
  const std::size_t start = at + words.size();
  const std::size_t length = script.find(']', start) - start;
  const std::string end = script.substr(start, length);
  if (end.find_first_not_of("0123456789.e-+") != std::string::npos)
    return script;
  return script.replace(start, length,
                        fmt::format("{:.4g}", std::stod(end) / (1.0 - share)));
}

/// Enlarges the margins of a figure of several panels and the space between
/// them.
std::string with_wider_margins(std::string script, double factor) {
  const std::string words = " margins ";
  const std::size_t at = script.find(words, script.find("set multiplot"));
  if (at == std::string::npos)
    return script;
  const std::size_t end = script.find('\n', at);
  double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0, across = 0.0,
         down = 0.0;
  const std::string found = script.substr(at, end - at);
  const int numbers =
      std::sscanf(found.c_str(), " margins %lf,%lf,%lf,%lf spacing %lf,%lf",
                  &left, &right, &bottom, &top, &across, &down);
  if (numbers < 5)
    return script;
  return script.replace(
      at, end - at,
      fmt::format(" margins {:.4g},{:.4g},{:.4g},{:.4g} spacing {:.4g},{:.4g}",
                  factor * left, 1.0 - factor * (1.0 - right), factor * bottom,
                  1.0 - factor * (1.0 - top), factor * across,
                  factor * (numbers == 6 ? down : across)));
}

/// Writes settings that must follow those of the script.
std::string before_plot(std::string script, const std::string& settings) {
  const std::size_t at =
      script.starts_with("plot ") ? 0 : script.find("\nplot ");
  return at == std::string::npos
             ? script
             : script.insert(at == 0 ? 0 : at + 1, settings);
}

} // namespace

JournalLayout journal_layout(const Figure& figure, double width,
                             double font_size, double line_height) {
  JournalLayout layout{width * figure.height / figure.width, figure.script};
  const std::string& script = figure.script;
  const double size = font_size * printers_point;
  if (has(script, "multiplot")) // in a report, text has 12 px
    layout.script =
        with_wider_margins(script, size / width / (12.0 / figure.width));
  if (has(script, "multiplot") || has(script, "palette"))
    return layout;
  const double key_size = (font_size - 1.0) * printers_point;
  const double right =
      (has(script, "set y2tics") ? space_beside : free_edge) * size;
  const double top = free_edge * size;
  const std::string corner = free_corner(figure);
  const bool is_inside = !corner.empty();
  double left = space_beside * size;
  const KeyBelow key = key_below(script, width - left - right, key_size);
  double bottom =
      space_below * size + (is_inside ? 0.0 : key.height + key_gap * size);
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
  const std::string settings = fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n"
      "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
      "set xlabel offset 0,0.3\nset ylabel offset 0.8,0\nset key font ',{:g}' "
      "height 0 samplen 1.4 spacing {:.3g} {}\n",
      left / width, 1.0 - right / width, 1.0 - top / layout.height,
      bottom / layout.height, font_size - 1.0, 1.0 / line_height,
      is_inside ? "inside vertical " + corner
                : fmt::format("at screen 0.5, screen {:.4f} center bottom "
                              "horizontal maxcols {}",
                              0.1 * size / layout.height, key.columns));
  layout.script =
      settings +
      before_plot(script, has(script, "set x2tics")
                              ? "unset x2tics\nunset x2label\nset border 3\n"
                              : "");
  if (corner == "top right")
    layout.script = with_room(
        layout.script, key_row * key_size *
                           (static_cast<double>(titles_in(script).size()) + 1) /
                           (layout.height - top - bottom));
  return layout;
}

} // namespace asperity::reports
