#include "reports/explore/chart.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>
#include <utility>

namespace asperity::reports {
namespace {

/// Returns a digit below or above the line, or "_rms" for other letters.
std::string shifted(const std::string& text, bool is_below) {
  static const std::vector<std::string> below{"₀", "₁", "₂", "₃", "₄",
                                              "₅", "₆", "₇", "₈", "₉"};
  static const std::vector<std::string> above{"⁰", "¹", "²", "³", "⁴",
                                              "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (text.find_first_not_of("0123456789") != std::string::npos || text.empty())
    return (is_below ? "_" : "^") + text;
  std::string digits;
  for (const char digit : text)
    digits += (is_below ? below : above)[static_cast<std::size_t>(digit - '0')];
  return digits;
}

/// Changes the units of an axis.
/// @return  the factor by which its numbers change
double changed_units(ChartAxis& axis) {
  if (!axis.other)
    return 1.0;
  const double factor = axis.other->factor;
  axis.other->factor = 1.0 / factor;
  std::swap(axis.label, axis.other->label);
  for (std::optional<double>* end : {&axis.low, &axis.high})
    if (*end)
      *end = rounded(**end * factor, 9);
  axis.tick_step = 0.0;
  for (auto& [place, name] : axis.ticks)
    place *= factor;
  return factor;
}

} // namespace

void use_other_units(ChartPanel& panel) {
  const double across = changed_units(panel.x);
  const double up = changed_units(panel.y);
  const double second = panel.second ? changed_units(*panel.second) : up;
  for (ChartCurve& curve : panel.curves) {
    const double factor = curve.is_on_second_axis ? second : up;
    curve.x_factor *= across;
    curve.factor *= factor;
    curve.intercept *= factor;
    curve.slope *= factor / across;
  }
  for (ChartMark& mark : panel.marks) {
    mark.low *= across;
    mark.high *= across;
  }
  for (ChartBand& band : panel.bands)
    for (auto& [x, y] : band.corners) {
      x = rounded(x * across, 8);
      y = rounded(y * up, 8);
    }
}

ChartCurve curve(std::string label, CurveStyle style, std::size_t index, int x,
                 int y) {
  return {.label = std::move(label),
          .style = std::move(style),
          .index = static_cast<int>(index),
          .x = x,
          .y = y};
}

ChartCurve& ChartPanel::add(std::string label, CurveStyle style,
                            std::size_t index, int x_column, int y_column) {
  return curves.emplace_back(
      curve(std::move(label), std::move(style), index, x_column, y_column));
}

ChartCurve level(double y, CurveStyle style, std::string label) {
  return {.label = std::move(label), .style = std::move(style), .intercept = y};
}

CurveStyle line(std::string color, double width, int dash) {
  return {.color = std::move(color),
          .has_line = true,
          .width = width,
          .dash = dash};
}

CurveStyle markers(std::string color, int marker, double size, double width) {
  return {.color = std::move(color),
          .has_markers = true,
          .width = width,
          .marker = marker,
          .marker_size = size};
}

CurveStyle joined(CurveStyle markers) {
  markers.has_line = true;
  return markers;
}

double rounded(double number, int digits) {
  return std::strtod(fmt::format("{:.{}g}", number, digits).c_str(), nullptr);
}

std::string as_markup(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("\\^_{}@&~").find(c) != std::string_view::npos)
      escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string plain_label(const std::string& markup) {
  std::string text;
  for (std::size_t i = 0; i < markup.size(); ++i) {
    const char c = markup[i];
    const bool has_next = i + 1 < markup.size();
    if (c == '\\' && has_next) {
      text += markup[++i];
    } else if ((c == '_' || c == '^') && has_next) {
      const std::size_t end =
          markup[i + 1] == '{' ? markup.find('}', i + 1) : i + 1;
      if (end == std::string::npos)
        return markup;
      text += shifted(markup[i + 1] == '{' ? markup.substr(i + 2, end - i - 2)
                                           : markup.substr(i + 1, 1),
                      c == '_');
      i = end;
    } else if (c == ' ' && !text.empty() && text.back() == ' ') {
      continue; // two blanks widen the gap on paper
    } else if (c != '{' && c != '}') {
      text += c;
    }
  }
  return text;
}

} // namespace asperity::reports
