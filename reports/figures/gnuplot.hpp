#pragma once

// Draws with gnuplot as a child process and owns the common style of all
// figures. A figure consists of three files: data (.csv), script (.gp) and
// image (.svg).

#include "reports/explore/chart.hpp"
#include "reports/explore/map_stack.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity::reports {

/// How the panels of a figure are arranged, row by row.
struct PanelGrid {
  int rows = 1, columns = 1;
  std::optional<std::array<double, 4>> margins =
      {}; ///< left, right, bottom and top edge of the panels, shares
          ///< of the figure; empty: chosen by gnuplot
  double across = 0.0, down = 0.0; ///< between panels
  bool has_shared_legend = false;  ///< of the first panel, below all
};

/// A figure before it is drawn. Its script reads "<name>.csv" in its own folder
/// (and "<name>-<suffix>.csv" for maps), so that it can be run again by hand.
struct Figure {
  std::string name;    ///< file name without extension, [a-z0-9-]
  std::string title;   ///< heading in the report
  std::string caption; ///< what the figure shows, with numbers
  std::string data;    ///< text of the CSV
  std::vector<std::pair<std::string, std::string>> maps; ///< suffix, CSV matrix
  std::vector<ChartPanel> panels;
  std::optional<PanelGrid> grid = {}; ///< empty: there is one panel
  std::string arrangement = {};       ///< settings of a journal, for gnuplot
  int width = 480;                    ///< [px]
  int height = 420;                   ///< [px]
  std::optional<MapStack> stack = {}; ///< maps for the browser
  std::string problem = {}; ///< why the figure cannot be drawn; empty if it can
  bool is_physical = false; ///< the units of its axes that come first
};

struct DrawnFigure {
  std::string name;
  std::string title;
  std::string caption;
  std::string svg;          ///< empty if it could not be drawn
  std::string problem;      ///< why it could not be drawn; empty if it was
  std::string explore = {}; ///< explore_data() for the browser; empty: none
};

/// Writes the three files into `folder` and draws the figure. gnuplot is
/// started in that folder without a shell. A missing or failing gnuplot is
/// reported in `problem`, not thrown. The process is terminated after ten
/// minutes, 8 GiB of memory or 1 GiB of output.
/// @param program  name or path of gnuplot
/// @throws std::domain_error  a name contains characters other than [a-z0-9-]
DrawnFigure draw(const Figure& figure, const std::filesystem::path& folder,
                 const std::string& program = "gnuplot");

/// Writes table and script of a figure into `folder` and runs gnuplot there, so
/// that it writes "<name>.<ending>".
/// @param terminal  gnuplot's words behind "set terminal"
/// @return          why there is no such file; empty if there is
/// @throws std::domain_error  as for draw()
std::string run_script(const Figure& figure,
                       const std::filesystem::path& folder,
                       const std::string& terminal, const std::string& ending,
                       const std::string& program);

/// Returns explore_data() of a figure.
std::string explore_data(const Figure& figure);

/// Returns a colour from a colour-blind-safe list (Okabe and Ito 2008), which
/// runs from dark to light.
const char* method_color(std::size_t index);

/// Collects rows of numbers as CSV. NaN is written as "nan", at which gnuplot
/// breaks a line.
class CsvTable {
public:
  /// @param header  column names, each with its unit: "gap/h_rms [1]"
  explicit CsvTable(const std::vector<std::string>& header);

  /// @param label    first column, quoted
  /// @param numbers  the remaining columns
  void add(const std::string& label, const std::vector<double>& numbers);

  const std::string& text() const { return text_; }

private:
  std::string text_;
};

} // namespace asperity::reports
