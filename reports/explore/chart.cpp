#include "reports/explore/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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

namespace {

/// A legend tells lines apart by their dashes, or by a width of a pixel more.
bool looks_like(const CurveStyle& one, const CurveStyle& other) {
  if (one.color != other.color || one.has_markers != other.has_markers ||
      one.has_line != other.has_line)
    return false;
  return one.has_markers ? one.marker == other.marker
                         : one.dash == other.dash &&
                               std::abs(one.width - other.width) < 1.0;
}

/// The same colour with the next symbol, open ones after open ones, or dash.
CurveStyle next_style(CurveStyle style) {
  static constexpr std::array filled{7, 5, 9, 13, 11}; // each before it open
  if (style.has_markers) {
    const int open = style.marker % 2 == 0 ? 1 : 0;
    const auto* const found = std::ranges::find(filled, style.marker + open);
    const bool is_last = found == filled.end() || found + 1 == filled.end();
    style.marker = (is_last ? filled.front() : found[1]) - open;
  } else {
    style.dash = style.dash % 3 + 1;
    style.width += style.dash == 1 ? 1.5 : 0.0;
  }
  return style;
}

} // namespace

ChartCurve& ChartPanel::add(std::string label, CurveStyle style,
                            std::size_t index, int x_column, int y_column) {
  const auto is_taken = [&] {
    return std::ranges::any_of(curves, [&](const ChartCurve& other) {
      return !other.label.empty() && looks_like(style, other.style);
    });
  };
  constexpr int most_styles = 9; // of one colour
  for (int i = 1; i < most_styles && !label.empty() && is_taken(); ++i)
    style = next_style(style);
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
