#pragma once

// Drawing with gnuplot as a child process, and the one style all figures have.
// A figure is three files: its data (.csv), its script (.gp), its picture.

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::reports {

/// A figure before it is drawn. The script draws from "<name>.csv" beside it
/// (and "<name>-<suffix>.csv" for maps), so that it can be run again by hand.
struct Figure {
  std::string name;    ///< file name without ending, [a-z0-9-]
  std::string title;   ///< heading in the report
  std::string caption; ///< what to see, with numbers
  std::string data;    ///< text of the CSV
  std::vector<std::pair<std::string, std::string>> maps; ///< suffix, CSV matrix
  std::string script;                                    ///< after the style
  int width = 480;                                       ///< [px]
  int height = 420;                                      ///< [px]
  std::string problem = {}; ///< why there is nothing to draw; empty: there is
};

struct DrawnFigure {
  std::string name;
  std::string title;
  std::string caption;
  std::string svg;     ///< empty if it could not be drawn
  std::string problem; ///< why not; empty if it was
};

/// Writes the three files into `folder` and draws. gnuplot is started without
/// a shell, in that folder; a missing or failing gnuplot is said, not thrown.
/// It is ended after ten minutes, 8 GiB of memory or 1 GiB of output.
/// @param program  name or path of gnuplot
/// @throws std::domain_error  a name is not of the letters [a-z0-9-]
DrawnFigure draw(const Figure& figure, const std::filesystem::path& folder,
                 const std::string& program = "gnuplot");

/// A quoted string for a gnuplot script that shows `text` as it is: nothing in
/// it is read as markup or run as a command. A straight single quote is shown
/// as a typographic one.
std::string gnuplot_text(const std::string& text);

/// The same for text that is markup already, such as "h_{rms}".
std::string gnuplot_markup(const std::string& text);

/// Colour-blind-safe colours (Okabe, Ito 2008), dark to light.
const char* method_color(std::size_t index);

/// Rows of numbers as CSV: NaN is written "nan", where gnuplot breaks a line.
class CsvTable {
public:
  /// @param header  column names, each with its unit: "gap/h_rms [1]"
  explicit CsvTable(const std::vector<std::string>& header);

  /// @param label    first column, quoted
  /// @param numbers  the others
  void add(const std::string& label, const std::vector<double>& numbers);

  const std::string& text() const { return text_; }

private:
  std::string text_;
};

} // namespace asperity::reports
