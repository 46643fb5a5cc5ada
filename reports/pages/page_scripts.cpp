#include "reports/explore/explore_data.hpp"
#include "reports/pages/page_data.hpp"

#include <algorithm>

namespace asperity::reports {
namespace {

bool is_explorable(const DrawnFigure& figure) {
  return !figure.explore.empty();
}

} // namespace

void set_scripts(kainjow::mustache::data& page,
                 std::span<const DrawnGroup> groups, bool is_for_print,
                 const std::string& own_script) {
  kainjow::mustache::list scripts;
  std::string permissions;
  const auto add = [&](const std::string& script) {
    scripts.push_back(text_item(inline_script(script)));
    permissions += " " + script_permission(inline_script(script));
  };
  if (!own_script.empty())
    add(own_script);
  const bool has_any = std::ranges::any_of(groups, [](const DrawnGroup& group) {
    return std::ranges::any_of(group.figures, is_explorable);
  });
  const std::string library = chart_library();
  if (has_any && !is_for_print) {
    if (!library.empty())
      add(library);
    add(explore_script());
  }
  page.set("without_library", has_any && !is_for_print && library.empty());
  page.set("scripts", scripts);
  // The style of elements is set by the page itself and by Chart.js.
  page.set("policy",
           "default-src 'none'; img-src data:; style-src 'unsafe-inline'" +
               (permissions.empty() ? "" : "; script-src" + permissions));
}

void set_figures(kainjow::mustache::data& page,
                 std::span<const DrawnGroup> groups, bool is_for_print) {
  page.set("groups", group_data(groups));
  set_scripts(page, groups, is_for_print);
}

} // namespace asperity::reports
