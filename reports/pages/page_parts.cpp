#include "base/json.hpp"
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

/// The page inverts its pictures on a dark screen; maps and their colours are
/// inverted once more, so that they keep their meaning.
std::string with_kept_colors(std::string svg) {
  if (svg.find("<image") == svg.npos)
    return svg;
  return svg.insert(svg.find('>', svg.find("<svg")) + 1,
                    "<style>@media screen and (prefers-color-scheme: dark) { "
                    "image, polygon { filter: invert(1) hue-rotate(180deg); } "
                    "}</style>");
}

Json figure_data(const DrawnFigure& drawn) {
  Json figure = {{"title", drawn.title},
                 {"caption", drawn.caption},
                 {"is_wide", is_wide(drawn.svg)},
                 {"picture", drawn.svg.empty()
                                 ? ""
                                 : data_uri(with_kept_colors(drawn.svg))},
                 {"problem", drawn.svg.empty() ? drawn.problem : ""},
                 {"explore", drawn.explore},
                 {"is_first", false}};
  return figure;
}

/// Takes the figures that stand beside the answer out of their groups: gap and
/// area against the load; with adhesion the path instead of the gap; of an
/// exact shape its first figure.
std::vector<DrawnFigure> take_leading(std::vector<DrawnGroup>& groups) {
  std::vector<DrawnFigure> leading;
  const auto take = [&](const auto& is_asked) {
    for (DrawnGroup& group : groups)
      if (const auto found =
              std::ranges::find_if(group.figures, is_asked, &DrawnFigure::name);
          found != group.figures.end()) {
        leading.push_back(*found);
        group.figures.erase(found);
        return true;
      }
    return false;
  };
  const auto called = [](const char* name) {
    return [name](const std::string& other) { return other == name; };
  };
  if (!take(called("adhesion-loop")))
    take(called("pressure-gap"));
  if (!take(called("area-pressure")) && leading.empty())
    take([](const std::string& name) { return name.starts_with("exact-"); });
  return leading;
}

} // namespace

void set_groups(Json& page, std::span<const DrawnGroup> groups) {
  std::vector<DrawnGroup> others(groups.begin(), groups.end());
  page["first_figures"] = Json::array();
  for (const DrawnFigure& figure : take_leading(others)) {
    page["first_figures"].push_back(figure_data(figure));
    page["first_figures"].back()["is_first"] = true;
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

} // namespace asperity::reports
