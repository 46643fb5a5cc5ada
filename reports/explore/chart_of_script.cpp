#include "reports/explore/chart_of_script.hpp"

#include "reports/explore/script_axes.hpp"
#include "reports/explore/script_bands.hpp"
#include "reports/explore/script_curves.hpp"
#include "reports/explore/script_words.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

/// Names contain quotes, "E* h'", but no commas.
std::vector<std::string> names_of(const std::string& header) {
  std::vector<std::string> names(1);
  for (const char c : header.substr(0, header.find('\n')))
    if (c == ',')
      names.emplace_back();
    else
      names.back() += c;
  return names;
}

std::string column_name(const std::vector<std::string>& header, int column) {
  const auto i = static_cast<std::size_t>(column);
  if (i > header.size())
    throw NotUnderstood();
  return header[i - 1];
}

constexpr const char* logarithm = "log10 ";

void show_logarithm(ChartAxis& axis) {
  axis.is_log = axis.is_log10 = true;
  for (const char* word : {"log₁₀ ", "log10 "})
    if (axis.label.starts_with(word))
      axis.label.erase(0, std::string(word).size());
  for (std::optional<double>* limit : {&axis.low, &axis.high})
    if (*limit)
      *limit = std::pow(10.0, **limit);
}

/// Turns axes around of which every column is a logarithm.
void show_logarithms(ChartPanel& panel,
                     const std::vector<std::string>& header) {
  const auto are_logarithms = [&](auto column, bool is_second) {
    bool has_any = false;
    for (const ChartCurve& curve : panel.curves)
      if (curve.x > 0 && curve.is_on_second_axis == is_second) {
        if (!column_name(header, column(curve)).starts_with(logarithm))
          return false;
        has_any = true;
      }
    return has_any;
  };
  const auto x = [](const ChartCurve& curve) { return curve.x; };
  const auto y = [](const ChartCurve& curve) { return curve.y; };
  if (are_logarithms(x, false))
    show_logarithm(panel.x);
  if (are_logarithms(y, false))
    show_logarithm(panel.y);
  for (ChartBand& band : panel.bands)
    for (auto& [across, up] : band.corners) {
      across = panel.x.is_log10 ? std::pow(10.0, across) : across;
      up = panel.y.is_log10 ? std::pow(10.0, up) : up;
    }
}

ChartPanel panel_of(const std::string& plot, const ScriptState& state,
                    const std::vector<std::string>& header,
                    const std::string& polygons) {
  ChartPanel panel{state.x, state.y, std::nullopt, {}, state.marks};
  for (const std::string& part : split_outside(plot, ',')) {
    if (!is_band(part)) {
      panel.curves.push_back(curve_of(part));
      continue;
    }
    const std::optional<ChartBand> band = band_of(part, polygons);
    if (!band)
      throw NotUnderstood();
    panel.bands.push_back(*band);
  }
  for (const ChartCurve& curve : panel.curves)
    for (const int column : {curve.x, curve.y, curve.low, curve.high})
      if (column > 0)
        column_name(header, column);
  if (std::ranges::any_of(panel.curves, &ChartCurve::is_on_second_axis))
    panel.second = state.second;
  show_logarithms(panel, header);
  return panel;
}

} // namespace

std::optional<Chart> chart_of_script(const std::string& script,
                                     const std::string& header,
                                     const std::string& polygons) {
  Chart chart;
  ScriptState state;
  const std::vector<std::string> columns = names_of(header);
  try {
    for (const std::string& line : commands_of(script)) {
      const std::string plot = "plot ";
      if (line.starts_with("set ") || line.starts_with("unset "))
        read_setting(words_of(line), state);
      else if (line.starts_with(plot))
        chart.panels.push_back(
            panel_of(line.substr(plot.size()), state, columns, polygons));
      else
        return std::nullopt;
    }
  } catch (const NotUnderstood&) {
    return std::nullopt;
  }
  return chart.panels.empty() ? std::nullopt : std::optional(chart);
}

} // namespace asperity::reports
