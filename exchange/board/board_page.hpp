#pragma once

// One page of the board: text, tables that can be sorted and filtered without a
// network, and figures. The layout is board.html.mustache.

#include "reports/figures/gnuplot.hpp"

#include <string>
#include <vector>

namespace asperity::exchange {

/// A cell; `key` is what a table is sorted by, the text if it is empty.
struct BoardCell {
  std::string text;
  std::string key = {};
  std::string link = {};
  std::string small = {}; ///< a second line
  bool is_number = false;
};

/// A number as text, sorted by its value; NaN is a dash and sorted last.
BoardCell number_cell(double value, const char* format);

struct BoardTable {
  std::vector<BoardCell> heads;
  std::vector<std::vector<BoardCell>> rows;
};

struct BoardSection {
  std::string heading;
  std::string note = {};
  BoardTable table = {}; ///< without rows: not shown
  std::vector<reports::DrawnFigure> figures = {};
};

struct BoardPage {
  std::string title;
  std::string lead;
  std::string home = {}; ///< link to the front page; empty: this is it
  std::vector<BoardSection> sections;
};

std::string html_of(const BoardPage& page);

} // namespace asperity::exchange
