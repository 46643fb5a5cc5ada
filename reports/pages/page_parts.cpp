#include "base/json.hpp"
#include "reports/explore/explore_data.hpp"
#include "reports/pages/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

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

Json figure_data(const DrawnFigure& drawn) {
  Json figure = {{"title", drawn.title},
                 {"caption", drawn.caption},
                 {"is_wide", is_wide(drawn.svg)},
                 {"picture", drawn.svg.empty() ? "" : data_uri(drawn.svg)},
                 {"problem", drawn.svg.empty() ? drawn.problem : ""},
                 {"explore", drawn.explore}};
  return figure;
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

void set_groups(Json& page, std::span<const DrawnGroup> groups) {
  std::vector<DrawnGroup> others(groups.begin(), groups.end());
  page["first_figures"] = Json::array();
  if (const auto [group, figure] = leading_figure(others); group != nullptr) {
    page["first_figures"].push_back(figure_data(*figure));
    group->figures.erase(figure);
  }
  std::erase_if(others,
                [](const DrawnGroup& one) { return one.figures.empty(); });
  page["groups"] = group_data(others);
}

Json contents_of(const Json& page) {
  Json contents = Json::array();
  const auto add = [&](const std::string& anchor, const std::string& text) {
    contents.push_back({{"anchor", anchor}, {"text", text}});
  };
  const Json& first = page["entries"].front();
  const std::string suffix = page["entries"].size() > 1 ? "-1" : "";
  const auto add_if = [&](const char* rows, const char* anchor,
                          const char* text) {
    if (!first[rows].empty())
      add(anchor + suffix, text);
  };
  add_if("contact_against_load", "physical", "Contact against load");
  add_if("expectations", "expectations", "Expectations");
  add("methods" + suffix, "Comparison and cost");
  add_if("published", "published", "Published values");
  add_if("stiffness", "stiffness", "Stiffness");
  for (const Json& group : page["groups"])
    add(group["anchor"], group["heading"]);
  if (page.contains("agreements") && !page["agreements"].empty())
    add("agreement", "Agreement");
  add("fits", "Fits");
  add("provenance" + suffix, "Provenance");
  add("citation", "Methods and literature");
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

Json group_data(std::span<const DrawnGroup> groups) {
  Json list = Json::array();
  for (const DrawnGroup& group : groups) {
    Json figures = Json::array();
    for (const DrawnFigure& drawn : group.figures)
      figures.push_back(figure_data(drawn));
    list.push_back({{"heading", group.heading},
                    {"anchor", fmt::format("figures-{}", list.size() + 1)},
                    {"figures", std::move(figures)}});
  }
  return list;
}

void set_scripts(Json& page, std::span<const DrawnGroup> groups,
                 bool is_for_print, const std::string& own_script) {
  Json scripts = Json::array();
  std::string permissions;
  const auto add = [&](const std::string& script) {
    scripts.push_back(inline_script(script));
    permissions += " " + script_permission(inline_script(script));
  };
  if (!own_script.empty())
    add(own_script);
  const bool has_any = std::ranges::any_of(groups, [](const DrawnGroup& group) {
    return std::ranges::any_of(group.figures, [](const DrawnFigure& figure) {
      return !figure.explore.empty();
    });
  });
  const std::string library = chart_library();
  if (has_any && !is_for_print) {
    if (!library.empty())
      add(library);
    add(explore_script());
  }
  page["without_library"] = has_any && !is_for_print && library.empty();
  page["scripts"] = std::move(scripts);
  // The style of elements is set by the page itself and by Chart.js.
  page["policy"] =
      "default-src 'none'; img-src data:; style-src 'unsafe-inline'" +
      (permissions.empty() ? "" : "; script-src" + permissions);
}

void set_figures(Json& page, std::span<const DrawnGroup> groups,
                 bool is_for_print) {
  page["groups"] = group_data(groups);
  set_scripts(page, groups, is_for_print);
}

} // namespace asperity::reports
