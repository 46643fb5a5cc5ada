#include "reports/explore/explore_data.hpp"

#include "base/content_hash.hpp"
#include "base/json.hpp"
#include "base/read_file.hpp"
#include "reports/explore/explore_script.hpp"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cstdlib>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const ChartAxis& axis) {
  Json json{{"label", plain_label(axis.label)}, {"log", axis.is_log}};
  if (axis.low)
    json["low"] = *axis.low;
  if (axis.high)
    json["high"] = *axis.high;
  for (const auto& [place, name] : axis.ticks)
    json["ticks"].push_back({place, plain_label(name)});
  return json;
}

Json json_of(const ChartCurve& curve) {
  const CurveStyle& style = curve.style;
  Json json{{"label", curve.label},
            {"color", style.color},
            {"line", style.has_line},
            {"markers", style.has_markers},
            {"steps", curve.has_steps},
            {"area", curve.is_area},
            {"width", style.width},
            {"dash", style.dash},
            {"marker", style.marker},
            {"size", style.marker_size},
            {"second", curve.is_on_second_axis}};
  if (curve.x == 0) {
    json["slope"] = curve.slope;
    json["intercept"] = curve.intercept;
    return json;
  }
  json["index"] = curve.index;
  json["x"] = curve.x - 1; // counted from 0 in the browser
  json["y"] = curve.y - 1;
  json["factor"] = curve.factor;
  json["xFactor"] = curve.x_factor;
  if (curve.low > 0) {
    json["low"] = curve.low - 1;
    json["high"] = curve.high - 1;
    json["xInterval"] = curve.has_x_interval;
  }
  return json;
}

Json json_of(const ChartPanel& panel) {
  Json json{{"x", json_of(panel.x)}, {"y", json_of(panel.y)}};
  if (panel.second)
    json["second"] = json_of(*panel.second);
  json["curves"] = Json::array();
  for (const ChartCurve& curve : panel.curves)
    json["curves"].push_back(json_of(curve));
  json["marks"] = Json::array();
  for (const ChartMark& mark : panel.marks) // infinite: null
    json["marks"].push_back({{"low", mark.low},
                             {"high", mark.high},
                             {"height", mark.height},
                             {"color", mark.color},
                             {"label", mark.label}});
  json["bands"] = Json::array();
  for (const ChartBand& band : panel.bands) {
    Json corners = Json::array();
    for (const auto& [x, y] : band.corners)
      corners.push_back({x, y});
    json["bands"].push_back({{"color", band.color}, {"corners", corners}});
  }
  return json;
}

/// Whether the browser can show all of a panel.
bool has_only_curves(const ChartPanel& panel) {
  return !panel.image && !(panel.curves.empty() && panel.bands.empty()) &&
         std::ranges::none_of(panel.curves, &ChartCurve::is_per_row);
}

Json json_of(const MapStack& stack) {
  Json json{{"columns", stack.columns}, {"rows", stack.rows},
            {"left", stack.left},       {"right", stack.right},
            {"lower", stack.lower},     {"upper", stack.upper},
            {"xLabel", stack.x_label},  {"yLabel", stack.y_label},
            {"steps", map_steps}};
  json["quantities"] = Json::array();
  for (const MapQuantity& quantity : stack.quantities) {
    json["quantities"].push_back({{"label", plain_label(quantity.label)},
                                  {"colors", quantity.colors},
                                  {"span", quantity.span}});
    if (quantity.other)
      json["quantities"].back()["other"] = {
          {"label", plain_label(quantity.other->label)},
          {"factor", quantity.other->factor}};
  }
  json["frames"] = Json::array();
  for (const MapFrame& frame : stack.frames) {
    Json maps = Json::array();
    for (const PackedMap& map : frame.maps)
      maps.push_back({{"low", map.low},
                      {"high", map.high},
                      {"shownLow", map.shown_low},
                      {"shownHigh", map.shown_high},
                      {"data", map.data}});
    json["frames"].push_back({{"title", frame.title}, {"maps", maps}});
  }
  return json;
}

} // namespace

std::string explore_data(const std::string& name, const std::string& title,
                         const std::string& table,
                         std::span<const ChartPanel> panels,
                         const std::optional<MapStack>& maps) {
  if (!maps &&
      (panels.empty() || !std::ranges::all_of(panels, has_only_curves)))
    return "";
  Json json{{"name", name}, {"title", title}, {"table", packed(table)}};
  if (maps)
    json["maps"] = json_of(*maps);
  else
    for (ChartPanel panel : panels) {
      json["panels"].push_back(json_of(panel));
      if (!panel.x.other && !panel.y.other)
        continue;
      use_other_units(panel);
      json["panels"].back()["other"] = json_of(panel);
    }
  std::string text = ascii_of_json(json);
  // None of these stands outside a string of JSON, where the escape sequence
  // means the same character. The text can then end no element of a page.
  boost::replace_all(text, "<", "\\u003c");
  boost::replace_all(text, ">", "\\u003e");
  boost::replace_all(text, "&", "\\u0026");
  return text;
}

std::string chart_library() {
  constexpr std::uintmax_t most = 4 << 20; // [B]
  const char* const named = std::getenv("ASPERITY_CHART_JS");
  const std::filesystem::path path =
      named != nullptr ? named : "/usr/share/javascript/chart.js/chart.min.js";
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    return "";
  try {
    return read_file(path, most);
  } catch (const FileError&) {
    return ""; // as if it were not installed
  }
}

std::string explore_script() {
  return std::string(explore_javascript);
}

std::string inline_script(std::string script) {
  boost::replace_all(script, "</script", "<\\/script");
  boost::replace_all(script, "<!--", "<\\!--");
  boost::replace_all(script, "]]>", "]] >");
  return "//<![CDATA[\n" + script + "\n//]]>";
}

std::string script_permission(const std::string& script) {
  const std::string digits = content_hash(script);
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return "'sha256-" + base64(bytes) + "'";
}

} // namespace asperity::reports
