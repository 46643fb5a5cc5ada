#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity::reports {
namespace {

using Value = kainjow::mustache::data;
using List = kainjow::mustache::list;

bool is_wide(const std::string& svg) {
  const std::size_t at = svg.find("width=\"");
  return at != std::string::npos &&
         std::strtol(svg.c_str() + at + 7, nullptr, 10) > 700;
}

// Returns the picture as a data URI. Percent-encoding leaves the base64 of an
// embedded PNG unchanged; encoding it as base64 again would enlarge it by a
// third.
std::string data_uri(const std::string& svg) {
  std::string uri = "data:image/svg+xml;charset=utf-8,";
  for (const char c : svg) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain =
        byte > 0x20 && byte < 0x7f &&
        std::string_view("%#\"<>&'`{}|\\^").find(c) == std::string_view::npos;
    if (is_plain)
      uri += c;
    else
      uri += fmt::format("%{:02X}", byte);
  }
  return uri;
}

Value figure_data(const DrawnFigure& drawn) {
  Value figure;
  figure.set("title", drawn.title);
  figure.set("caption", drawn.caption);
  figure.set("is_wide", is_wide(drawn.svg));
  if (!drawn.svg.empty())
    figure.set("picture", data_uri(drawn.svg));
  else
    figure.set("problem", drawn.problem);
  if (!drawn.explore.empty())
    figure.set("explore", drawn.explore);
  return figure;
}

void add_content(List& contents, const std::string& anchor,
                 const std::string& text) {
  Value item;
  item.set("anchor", anchor);
  item.set("text", text);
  contents.push_back(item);
}

using FigureOfGroup =
    std::pair<DrawnGroup*, std::vector<DrawnFigure>::iterator>;

/// Returns the figure that stands beside the answer, with its group: the path
/// of contact with adhesion, or else the first one if it shows the curves; null
/// if there is neither.
FigureOfGroup leading_figure(std::vector<DrawnGroup>& groups) {
  for (DrawnGroup& group : groups)
    if (const auto loop = std::ranges::find(group.figures, "adhesion-loop",
                                            &DrawnFigure::name);
        loop != group.figures.end())
      return {&group, loop};
  if (groups.empty() || groups.front().figures.empty())
    return {};
  const auto first = groups.front().figures.begin();
  return first->name == "pressure-gap" || first->name.starts_with("exact-")
             ? FigureOfGroup{&groups.front(), first}
             : FigureOfGroup{};
}

} // namespace

void set_groups(Value& page, std::span<const DrawnGroup> groups) {
  std::vector<DrawnGroup> others(groups.begin(), groups.end());
  List first;
  if (const auto [group, figure] = leading_figure(others); group != nullptr) {
    first.push_back(figure_data(*figure));
    group->figures.erase(figure);
  }
  std::erase_if(others,
                [](const DrawnGroup& one) { return one.figures.empty(); });
  page.set("first_figures", first);
  page.set("groups", group_data(others));
}

kainjow::mustache::list contents_of(const Value& page) {
  List contents;
  const List& entries = page.get("entries")->list_value();
  const Value& first = entries.front();
  const std::string suffix = entries.size() > 1 ? "-1" : "";
  if (first.get("has_physical")->is_true())
    add_content(contents, "physical" + suffix, "Contact against load");
  if (first.get("has_verdicts")->is_true())
    add_content(contents, "expectations" + suffix, "Expectations");
  add_content(contents, "methods" + suffix, "Comparison and cost");
  if (first.get("has_published")->is_true())
    add_content(contents, "published" + suffix, "Published values");
  if (first.get("has_stiffness")->is_true())
    add_content(contents, "stiffness" + suffix, "Stiffness");
  for (const Value& group : page.get("groups")->list_value())
    add_content(contents, group.get("anchor")->string_value(),
                group.get("heading")->string_value());
  if (page.get("has_agreements") != nullptr &&
      page.get("has_agreements")->is_true())
    add_content(contents, "agreement", "Agreement");
  add_content(contents, "fits", "Fits");
  add_content(contents, "provenance" + suffix, "Provenance");
  add_content(contents, "citation", "Methods and literature");
  return contents;
}

std::string unfolded(std::string html) {
  const std::string folded = "<details id=";
  const std::string open = "<details open=\"open\" id=";
  for (std::size_t at = html.find(folded); at != std::string::npos;
       at = html.find(folded, at + open.size()))
    html.replace(at, folded.size(), open);
  return html;
}

kainjow::mustache::list group_data(std::span<const DrawnGroup> groups) {
  List list;
  for (const DrawnGroup& group : groups) {
    List figures;
    for (const DrawnFigure& drawn : group.figures)
      figures.push_back(figure_data(drawn));
    Value entry;
    entry.set("heading", group.heading);
    entry.set("anchor", fmt::format("figures-{}", list.size() + 1));
    entry.set("figures", figures);
    list.push_back(entry);
  }
  return list;
}

} // namespace asperity::reports
