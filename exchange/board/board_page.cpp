#include "exchange/board/board_page.hpp"

#include "base/shown_number.hpp"
#include "exchange/board/board_template.hpp"
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <cmath>
#include <kainjow/mustache.hpp>
#include <utility>

namespace asperity::exchange {
namespace {

using Value = kainjow::mustache::data;
using List = kainjow::mustache::list;

Value cell_data(const BoardCell& cell) {
  Value data;
  data.set("text", cell.text);
  data.set("key", cell.key.empty() ? cell.text : cell.key);
  data.set("class", cell.is_number ? "number" : "");
  data.set("small", cell.small);
  if (!cell.link.empty())
    data.set("link", cell.link);
  return data;
}

List cell_list(const std::vector<BoardCell>& cells) {
  List list;
  for (const BoardCell& cell : cells)
    list.push_back(cell_data(cell));
  return list;
}

Value section_data(const BoardSection& section) {
  Value data;
  data.set("heading", section.heading);
  data.set("note", section.note);
  List rows;
  for (const std::vector<BoardCell>& cells : section.table.rows) {
    Value row;
    row.set("cells", cell_list(cells));
    rows.push_back(row);
  }
  data.set("has_table", !rows.empty());
  data.set("has_filter", rows.size() > 5);
  data.set("heads", cell_list(section.table.heads));
  data.set("rows", rows);
  const reports::DrawnGroup group{"", section.figures};
  data.set("groups", reports::group_data({&group, 1}));
  return data;
}

} // namespace

BoardCell number_cell(double value, const char* format) {
  BoardCell cell;
  cell.is_number = true;
  cell.text = std::isfinite(value)
                  ? fmt::format(fmt::runtime(format), Shown{value})
                  : "–";
  cell.key = std::isfinite(value) ? fmt::format("{:.17g}", value) : "1e999";
  return cell;
}

std::string html_of(const BoardPage& page) {
  Value data;
  data.set("title", page.title);
  data.set("lead", page.lead);
  data.set("page_title", page.title);
  if (!page.home.empty())
    data.set("home", page.home);
  List sections;
  for (const BoardSection& section : page.sections)
    sections.push_back(section_data(section));
  data.set("sections", sections);
  reports::DrawnGroup figures;
  for (const BoardSection& section : page.sections)
    figures.figures.insert(figures.figures.end(), section.figures.begin(),
                           section.figures.end());
  reports::set_scripts(data, {&figures, 1}, false, std::string(board_script));
  return reports::rendered_page(board_template, std::move(data));
}

} // namespace asperity::exchange
