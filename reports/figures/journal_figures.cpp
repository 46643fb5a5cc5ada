#include "reports/figures/journal_figures.hpp"

#include "base/atomic_file.hpp"
#include "base/content_hash.hpp"
#include "base/plain_text.hpp"
#include "base/read_file.hpp"
#include "input/units.hpp"
#include "reports/figures/gnuplot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace asperity::reports {
namespace {

/// Share of the figure that the rectangle between the axes covers at least,
/// where the width allows it.
constexpr double least_plot_share = 0.6;

struct JournalLayout {
  double height = 0.0; ///< [m]
  Figure figure;       ///< with the arrangement
};

constexpr double printers_point = 25.4e-3 / 72.0; // [m]

// Sizes in multiples of the font size.
constexpr double space_beside = 5.6;    // label and numbers of a vertical axis
constexpr double space_of_colors = 9.0; // bar, numbers and label
constexpr double space_below = 3.7;     // those of the horizontal axis
constexpr double free_edge = 0.9;       // half a number sticks out
constexpr double key_row = 1.15;        // of the font size of the legend
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

/// Arranges a figure of this width.
///
/// A figure with one pair of axes gets fixed margins and no axes in other
/// units. The legend is below the axis, in as many columns as fit, and the
/// figure becomes higher if the plot would cover less than least_plot_share.
/// Figures of several panels or with images keep their proportions, with
/// margins for text of this size.
///
/// @param width        [m]
/// @param font_size    of labels [pt]; the legend is one point smaller
/// @param line_height  of the format's text over that of PDF and PNG [1]
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

constexpr double metres_per_inch = 25.4e-3; // [m]
constexpr double column_distance = 6e-3;    // between two columns [m]
constexpr double font_size = 8.0;           // [pt], 72 of them per inch
constexpr double png_pixels = 600;          // per inch
constexpr int widest_column = 700;          // of a figure for one column [px]

constexpr std::array<const char*, 3> endings_known{"pdf", "svg", "png"};

/// Returns the gnuplot command for a drawing of this size [m]. Lines, markers
/// and text keep their size on paper in all formats.
std::string terminal(const std::string& ending, double width, double height) {
  const std::string style = fmt::format(
      "enhanced font 'Helvetica,{:g}' background '#ffffff'", font_size);
  // A point of gnuplot's fonts is 1/72 inch times 4/3 in PDF, one pixel in SVG
  // and 4/3 of one in PNG.
  if (ending == "pdf")
    return fmt::format("pdfcairo size {:.4f}in,{:.4f}in {} fontscale 0.75 "
                       "linewidth 0.7 dashlength 0.7",
                       width / metres_per_inch, height / metres_per_inch,
                       style);
  if (ending == "svg")
    return fmt::format("svg size {:.0f},{:.0f} fixed {} linewidth 0.7 "
                       "dashlength 0.7",
                       width / metres_per_inch * 72.0,
                       height / metres_per_inch * 72.0, style);
  const double scale = png_pixels / 96.0;
  return fmt::format("pngcairo size {:.0f},{:.0f} {} fontscale {:.4f} "
                     "linewidth {:.4f} pointscale {:.4f} dashlength 0.7",
                     width / metres_per_inch * png_pixels,
                     height / metres_per_inch * png_pixels, style, scale,
                     0.7 * scale, 0.7 * scale);
}

/// Returns the height that gnuplot gives to a line of text in a format, over
/// that in PDF and PNG.
double line_height(const std::string& ending) {
  return ending == "svg" ? 1.3 : 1.0;
}

/// gnuplot writes sizes in pixels, of which the viewers of drawings have 96 per
/// inch and gnuplot's fonts 72.
void set_size_on_paper(const std::filesystem::path& path, double width,
                       double height) {
  constexpr std::uintmax_t most = 1U << 30U; // [B], as gnuplot's own limit
  std::string svg = read_file(path, most);
  const std::size_t start = svg.find("width=\"");
  const std::size_t end = svg.find("viewBox", start);
  if (start == std::string::npos || end == std::string::npos)
    return;
  svg.replace(start, end - start,
              fmt::format("width=\"{:.4g}mm\" height=\"{:.4g}mm\" ",
                          width * 1e3, height * 1e3));
  write_file_atomically(path, svg);
}

constexpr const char* drawn_record = ".drawn";

/// The SHA-256 of all drawings, tables and scripts with their names.
std::string hash_of_drawn(const std::filesystem::path& journal) {
  constexpr std::uintmax_t most = 1U << 30U; // [B]
  std::set<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(journal))
    if (entry.is_regular_file() && entry.path().filename() != drawn_record)
      files.insert(entry.path());
  ContentHash hash;
  for (const std::filesystem::path& file : files) {
    hash.add(file.lexically_relative(journal).string() + "\n");
    hash.add(content_hash(read_file(file, most)));
  }
  return hash.text();
}

} // namespace

void record_drawn(const std::filesystem::path& journal) {
  if (std::filesystem::is_directory(journal))
    write_file_atomically(journal / drawn_record,
                          hash_of_drawn(journal) + "\n");
}

void keep_edited(const std::filesystem::path& journal,
                 const std::filesystem::path& beside) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(journal) || fs::is_empty(journal))
    return;
  const fs::path record = journal / drawn_record;
  if (fs::exists(record) &&
      read_file(record, 1024) == hash_of_drawn(journal) + "\n")
    return;
  fs::path kept = beside / "journal.edited";
  for (int i = 2; fs::exists(kept); ++i)
    kept = beside / fmt::format("journal.edited-{}", i);
  fs::rename(journal, kept);
  fmt::print("the edited figures for a journal are kept in {}\n",
             kept.string());
}

JournalFormat journal_format(const std::vector<std::string>& endings,
                             const std::string& width) {
  JournalFormat format;
  for (const std::string& ending : endings) {
    if (std::ranges::find(endings_known, ending) == endings_known.end())
      throw std::domain_error(
          fmt::format("--figures {}: unknown format; the formats are {}",
                      printable(ending), fmt::join(endings_known, ", ")));
    format.endings.insert(ending);
  }
  const input::ValueReading read =
      input::read_with_unit(width, input::Dimension::length);
  if (!read.value)
    throw std::domain_error(fmt::format("--width = \"{}\" {}; a column is, for "
                                        "example, 86mm wide",
                                        printable(width), read.mistake));
  format.width = *read.value;
  if (!(format.width >= 0.03 && format.width <= 0.3))
    throw std::domain_error(fmt::format(
        "--width {}: must be from 30mm to 300mm", printable(width)));
  return format;
}

std::string draw_for_journal(const Figure& drawn, const JournalFormat& format,
                             const std::filesystem::path& folder,
                             const std::string& program) {
  if (!drawn.problem.empty())
    return "";
  Figure figure = drawn;
  if (format.units == (drawn.is_physical ? "reduced" : "physical"))
    for (ChartPanel& panel : figure.panels)
      use_other_units(panel);
  const double width = figure.width > widest_column
                           ? 2.0 * format.width + column_distance
                           : format.width;
  std::string problems;
  for (const std::string& ending : format.endings) {
    const JournalLayout layout =
        journal_layout(figure, width, font_size, line_height(ending));
    const std::string problem =
        run_script(layout.figure, folder,
                   terminal(ending, width, layout.height), ending, program);
    if (problem.empty() && ending == "svg")
      set_size_on_paper(folder / (figure.name + ".svg"), width, layout.height);
    if (!problem.empty())
      problems += (problems.empty() ? "" : "; ") + problem;
  }
  return problems;
}

} // namespace asperity::reports
