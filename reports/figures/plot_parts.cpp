#include "reports/figures/plot_parts.hpp"

#include "base/field_sums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::reports {

double round_step(double step) {
  if (!(step > 0.0) || !std::isfinite(step))
    return 1.0; // empty range: any value will do
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= step)
      return digit * power;
  return 10.0 * power;
}

namespace {

/// Sides of a band, from left to right or from below.
struct BandSides {
  std::vector<std::pair<double, double>> lower, upper;
};

/// Joins the lower side of a band with its upper side, which runs back.
void add_band(ChartPanel& panel, BandSides sides, const std::string& color) {
  if (sides.lower.size() < 2)
    return;
  ChartBand band{color, std::move(sides.lower)};
  band.corners.insert(band.corners.end(), sides.upper.rbegin(),
                      sides.upper.rend());
  for (auto& [x, y] : band.corners) {
    x = rounded(x, 8);
    y = rounded(y, 8);
  }
  panel.bands.push_back(std::move(band));
}

} // namespace

void add_gap_band(ChartPanel& panel, std::span<const SeriesRow> rows,
                  const std::string& color) {
  BandSides sides;
  for (const SeriesRow& row : rows) {
    if (!std::isfinite(row.gap_interval))
      return;
    const double y = std::log10(row.pressure);
    sides.lower.emplace_back(row.gap - row.gap_interval, y);
    sides.upper.emplace_back(row.gap + row.gap_interval, y);
  }
  add_band(panel, std::move(sides), color);
}

void add_area_band(ChartPanel& panel, std::span<const SeriesRow> rows,
                   const std::string& color) {
  BandSides sides;
  for (const SeriesRow& row : rows) {
    if (!std::isfinite(row.area_interval))
      return;
    // On a logarithmic axis the band has to end above zero.
    sides.lower.emplace_back(
        row.pressure, std::max(row.area - row.area_interval, 1e-3 * row.area));
    sides.upper.emplace_back(row.pressure, row.area + row.area_interval);
  }
  add_band(panel, std::move(sides), color);
}

PanelGrid side_by_side(double bottom) {
  return {.columns = 2,
          .margins = {{0.086, 0.985, bottom, 0.96}},
          .across = 0.09,
          .down = 0.09,
          .has_shared_legend = true};
}

std::string joined_words(std::span<const Series> series) {
  std::string names;
  for (const Series& one : series)
    if (!one.is_drawn)
      names += (names.empty() ? "" : ", ") + one.label;
  return names.empty() ? ""
                       : fmt::format(" Not drawn because they would coincide "
                                     "with the markers of their method: {}.",
                                     names);
}

const Estimate& quantity(const Series& series, const std::string& name) {
  static const Estimate none;
  const auto found = series.method->quantities.find(name);
  return found == series.method->quantities.end() ? none : found->second;
}

const Series* first_numerical(std::span<const Series> series) {
  for (const Series& one : series)
    if (!one.is_theory() && !one.rows.empty())
      return &one;
  return nullptr;
}

const Series* theory_of(std::span<const Series> series, const Series& method) {
  for (const Series& one : series)
    if (one.is_theory() && one.entry == method.entry && !one.rows.empty())
      return &one;
  return nullptr;
}

std::vector<const results::MethodRecord*>
methods_with_maps(const results::Result& result) {
  std::vector<const results::MethodRecord*> methods;
  for (const results::MethodRecord& method : result.methods) {
    const std::string base = method.name.substr(0, method.name.find('.'));
    const bool is_shown = std::any_of(methods.begin(), methods.end(),
                                      [&](const results::MethodRecord* other) {
                                        return other->name == base;
                                      });
    if (!is_shown && !method.realizations.empty() &&
        !method.realizations.front().fields.empty())
      methods.push_back(&method);
  }
  return methods;
}

std::vector<const results::Fields*>
whole_maps(const results::MethodRecord& method) {
  std::vector<const results::Fields*> whole;
  if (method.realizations.empty())
    return whole; // the run was interrupted before its first step
  // The reader has seen that the values of maps in a file are finite.
  for (const results::Fields& fields : method.realizations.front().fields)
    if (const std::size_t size = fields.grid.size();
        size > 0 && fields.pressure_map().size() == size &&
        fields.gap_map().size() == size && fields.grid.length_x > 0.0 &&
        all_finite(fields.pressure) && all_finite(fields.gap))
      whole.push_back(&fields);
  return whole;
}

std::string file_word(std::string name) {
  for (char& letter : name) {
    if (letter >= 'A' && letter <= 'Z')
      letter = static_cast<char>(letter - 'A' + 'a');
    const bool is_good =
        (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
    letter = is_good ? letter : '-';
  }
  return name.substr(0, 60);
}

const char* load_color(std::size_t load) {
  constexpr std::array colors{"#56B4E9", "#0072B2", "#35102b"};
  return colors[load % colors.size()];
}

CurveStyle load_sign(std::size_t load) {
  constexpr std::array signs{8, 4, 6};
  return markers(load_color(load), signs[load % signs.size()], 0.6, 1.2);
}

std::vector<std::size_t> three_of(std::size_t count) {
  std::vector<std::size_t> chosen;
  for (const std::size_t i : {std::size_t{0}, count / 2, count - 1})
    if (count > 0 && (chosen.empty() || chosen.back() < i))
      chosen.push_back(i);
  return chosen;
}

} // namespace asperity::reports
