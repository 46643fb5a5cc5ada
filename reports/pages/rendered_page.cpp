#include "base/atomic_file.hpp"
#include "base/json.hpp"
#include "base/shown_number.hpp"
#include "reports/explore/explore_data.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/pages/page_data.hpp"
#include "reports/pages/pdf_page.hpp"
#include "reports/report_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <kainjow/mustache.hpp>
#include <map>
#include <set>
#include <sstream>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;
using Data = kainjow::mustache::data;
/// The formats that the templates name, by the key in front of the bar.
using Formats = std::map<std::string, std::set<std::string>, std::less<>>;

void add_formats(std::string_view text, Formats& formats) {
  for (std::size_t at = text.find("{{"); at != std::string_view::npos;
       at = text.find("{{", at + 2)) {
    const std::string_view tag =
        text.substr(at + 2, text.find("}}", at) - at - 2);
    const std::size_t bar = tag.find('|');
    if (bar == std::string_view::npos)
      continue;
    const std::size_t start = tag.rfind('.', bar) + 1; // 0 if there is no dot
    formats[std::string(tag.substr(start, bar - start))].emplace(
        tag.substr(bar + 1));
  }
}

bool is_missing(const Json& value) {
  return value.is_null() ||
         (value.is_number_float() && !std::isfinite(value.get<double>()));
}

/// A number in a format such as "4g e9 nm".
std::string formatted(double value, const std::string& format) {
  std::istringstream words(format);
  std::string digits;
  std::string factor;
  std::string unit;
  words >> digits >> factor >> unit;
  if (!factor.starts_with('e'))
    std::swap(factor, unit);
  const double scale = factor.empty() ? 1.0 : std::stod("1" + factor);
  const std::string sign = digits.starts_with('+') ? "+" : "";
  if (sign.empty() && digits.ends_with('g'))
    return digits_text(value * scale, std::stoi(digits)) +
           (unit.empty() ? "" : " " + unit);
  if (value == 0.0 && digits.ends_with('e'))
    return "0";
  return fmt::format(fmt::runtime(fmt::format("{{:{}.{}}}", sign,
                                              digits.substr(sign.size()))),
                     Shown{value * scale}) +
         (unit.empty() ? "" : " " + unit);
}

/// A number with its interval, in a format that begins with ±.
std::string with_interval(const Json& object, double value,
                          const std::string& format) {
  Estimate estimate;
  estimate.value = value;
  if (const auto half = object.find("half_width_95");
      half != object.end() && half->is_number())
    estimate.half_width = half->get<double>();
  const std::string unit = format.substr(std::string("±").size());
  return unit.empty()
             ? number_text(estimate)
             : uncertain_text(estimate.value, estimate.half_width, unit);
}

/// The text of a member of an object in one of the formats of the header.
std::string shown(const Json& object, const Json& value,
                  const std::string& format) {
  if (value.is_string())
    return value.get<std::string>(); // says why there is no number
  const double number = is_missing(value) ? not_a_number : value.get<double>();
  if (format.starts_with("±"))
    return with_interval(object, number, format);
  if (format == "key")
    return std::isnan(number) ? "1e999" : fmt::format("{:.17g}", number);
  if (std::isnan(number))
    return "–";
  if (format == "unit")
    return quantity_text(number, object.at("unit").get<std::string>());
  if (const std::string unit = format.substr(1);
      unit == "m" || unit == "N" || unit == "Pa")
    return quantity_text(number, unit, format.front() - '0');
  return formatted(number, format);
}

Data data_of(Json& value, const Formats& formats) {
  if (value.is_array()) {
    kainjow::mustache::list list;
    for (Json& item : value)
      list.push_back(data_of(item, formats));
    return Data(list);
  }
  if (value.is_object()) {
    Data object(Data::type::object);
    for (auto& [key, member] : value.items()) {
      if (const auto named = formats.find(key);
          named != formats.end() && member.is_primitive())
        for (const std::string& format : named->second)
          object.set(key + "|" + format, shown(value, member, format));
      if (member.is_array())
        object.set("has_" + key, !member.empty());
      object.set(key, data_of(member, formats));
    }
    return object;
  }
  if (value.is_boolean())
    return Data(value.get<bool>());
  if (is_missing(value) || value == "")
    return Data(false);
  if (value.is_string())
    return Data(value.get_ref<const std::string&>());
  return Data(text_of_json(value, -1));
}

std::string rendered_page(std::string_view page_template, Json page) {
  const std::pair<const char*, std::string_view> parts[] = {
      {"page_head", page_head},
      {"page_facts", page_facts},
      {"page_end", page_end},
      {"figure", figure_template},
      {"constants", constants_template},
      {"sample_loads", sample_loads_template},
      {"sample_maps", sample_maps_template}};
  Formats formats;
  add_formats(page_template, formats);
  Data data = data_of(page, formats);
  for (const auto& [name, text] : parts)
    data.set(name, kainjow::mustache::partial{
                       [text = text] { return std::string(text); }});
  kainjow::mustache::mustache view{std::string(page_template)};
  return view.render(data);
}

/// Opens all folded parts of a page.
std::string unfolded(std::string html) {
  const std::string folded = "<details id=";
  const std::string open = "<details open=\"open\" id=";
  for (std::size_t at = html.find(folded); at != std::string::npos;
       at = html.find(folded, at + open.size()))
    html.replace(at, folded.size(), open);
  return html;
}

/// Adds to the page what makes its figures explorable: the scripts, and the
/// policy that permits no others and no network access.
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

} // namespace

std::string page_text(std::string_view page_template, Json page,
                      std::span<const DrawnGroup> groups, bool is_for_print,
                      const std::string& own_script) {
  set_scripts(page, groups, is_for_print, own_script);
  std::string text = rendered_page(page_template, std::move(page));
  return is_for_print ? unfolded(std::move(text)) : text;
}

void write_page(std::string_view page_template, const Json& page,
                std::span<const DrawnGroup> groups,
                const std::filesystem::path& folder, bool has_pdf,
                std::vector<std::string>& problems) {
  write_file_atomically(folder / "report.html",
                        page_text(page_template, page, groups, false));
  if (!has_pdf)
    return;
  const std::string problem =
      print_report(page_text(page_template, page, groups, true), folder);
  if (!problem.empty())
    problems.push_back(problem);
}

Json items_of(const Json& object) {
  Json items = Json::array();
  for (const auto& [key, value] : object.items()) {
    items.push_back({{"key", key}});
    if (value.is_object())
      items.back().update(value);
    else
      items.back()["value"] = value;
  }
  return items;
}

} // namespace asperity::reports
