#include "reports/figures/journal_figures.hpp"

#include "base/atomic_file.hpp"
#include "base/content_hash.hpp"
#include "base/plain_text.hpp"
#include "base/read_file.hpp"
#include "input/units.hpp"
#include "reports/figures/journal_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace asperity::reports {
namespace {

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
