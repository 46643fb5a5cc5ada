#include "reports/sweeps/sweep_axis.hpp"

#include "input/units.hpp"
#include "reports/explore/chart.hpp"
#include "reports/sweeps/sweep_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace asperity::reports {
namespace {

/// Reads "14 nm" or 0.5; nothing for anything else.
std::optional<input::NumberWithUnit> number_in(const std::string& label) {
  input::NumberWithUnit read =
      input::split_number(label, input::Dimension::none);
  return read.mistake.empty() ? std::optional(std::move(read)) : std::nullopt;
}

/// The number in another unit; nothing if that has not the same dimension.
std::optional<double> number_in_unit(const input::NumberWithUnit& read,
                                     const std::string& unit) {
  if (read.unit == unit)
    return read.number;
  const input::Unit* const from = input::unit_called(read.unit);
  const input::Unit* const to = input::unit_called(unit);
  return from != nullptr && to != nullptr && from->dimension == to->dimension
             ? std::optional(from->in_si(read.number) / to->in_si(1.0))
             : std::nullopt;
}

} // namespace

FigureAxis axis_of(const cases::SweptKey& key) {
  FigureAxis axis;
  axis.is_numeric = true;
  std::string unit;
  for (const std::string& value : key.values) {
    axis.labels.push_back(value_label(value));
    const auto read = number_in(axis.labels.back());
    if (axis.positions.empty() && read)
      unit = read->unit;
    const auto number = read ? number_in_unit(*read, unit) : std::nullopt;
    axis.is_numeric = axis.is_numeric && number.has_value();
    axis.positions.push_back(number.value_or(0.0));
  }
  axis.title = key.key;
  if (!axis.is_numeric)
    for (std::size_t i = 0; i < axis.positions.size(); ++i)
      axis.positions[i] = static_cast<double>(i);
  else if (!unit.empty())
    axis.title += " [" + unit + "]";
  const auto [low, high] = std::ranges::minmax(axis.positions);
  axis.is_log = axis.is_numeric && low > 0.0 && high > 20.0 * low;
  return axis;
}

std::string scale_color(std::size_t i, std::size_t n) {
  // Five colours of the scale "viridis" without its lightest end.
  constexpr std::array<std::array<double, 3>, 5> anchors{{{68, 1, 84},
                                                          {59, 82, 139},
                                                          {33, 145, 140},
                                                          {94, 201, 98},
                                                          {224, 200, 32}}};
  const double place =
      n < 2 ? 1.0 : 4.0 * static_cast<double>(i) / static_cast<double>(n - 1);
  const auto lower = std::min<std::size_t>(3, static_cast<std::size_t>(place));
  const double share = place - static_cast<double>(lower);
  std::array<int, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<int>(std::lround((1.0 - share) * anchors[lower][c] +
                                          share * anchors[lower + 1][c]));
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

std::vector<std::pair<double, std::string>>
named_ticks(const FigureAxis& axis) {
  std::vector<std::pair<double, std::string>> ticks;
  for (const std::string& label : axis.labels)
    ticks.emplace_back(static_cast<double>(ticks.size()),
                       as_markup(label.substr(0, 24)));
  return ticks;
}

} // namespace asperity::reports
