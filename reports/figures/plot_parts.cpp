#include "reports/figures/plot_parts.hpp"

#include "base/field_sums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::reports {

std::string of_series(std::size_t index, const std::string& columns) {
  const std::size_t x_end = columns.find(':');
  return fmt::format("using ($2=={} ? {} : NaN):{}", index,
                     columns.substr(0, x_end), columns.substr(x_end + 1));
}

std::string plot_of(const std::vector<std::string>& parts) {
  std::string text = "plot ";
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : ", \\\n  ") + parts[i];
  return text + "\n";
}

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

struct BandCorner {
  double x = 0.0;
  double y = 0.0;
};

/// Joins the lower side of a band with its upper side, which runs back.
std::string polygon_of(const std::vector<BandCorner>& lower,
                       const std::vector<BandCorner>& upper) {
  std::string polygon;
  const auto add = [&](const BandCorner& corner) {
    polygon += fmt::format("{:.8g},{:.8g}\n", corner.x, corner.y);
  };
  if (lower.size() < 2)
    return "";
  std::ranges::for_each(lower, add);
  std::for_each(upper.rbegin(), upper.rend(), add);
  return polygon;
}

} // namespace

std::string gap_band(std::span<const SeriesRow> rows) {
  std::vector<BandCorner> lower;
  std::vector<BandCorner> upper;
  for (const SeriesRow& row : rows) {
    if (!std::isfinite(row.gap_interval))
      return "";
    const double y = std::log10(row.pressure);
    lower.push_back({row.gap - row.gap_interval, y});
    upper.push_back({row.gap + row.gap_interval, y});
  }
  return polygon_of(lower, upper);
}

std::string area_band(std::span<const SeriesRow> rows) {
  std::vector<BandCorner> lower;
  std::vector<BandCorner> upper;
  for (const SeriesRow& row : rows) {
    if (!std::isfinite(row.area_interval))
      return "";
    // On a logarithmic axis the band has to end above zero.
    lower.push_back({row.pressure,
                     std::max(row.area - row.area_interval, 1e-3 * row.area)});
    upper.push_back({row.pressure, row.area + row.area_interval});
  }
  return polygon_of(lower, upper);
}

void Bands::add(const std::string& polygon, const std::string& rgb) {
  if (polygon.empty())
    return;
  polygons_ += (colors_.empty() ? "" : "\n\n") + polygon;
  colors_.push_back(rgb);
}

void Bands::add_to(Figure& figure, std::vector<std::string>& plots) const {
  if (empty())
    return;
  figure.maps.emplace_back("bands", polygons_);
  std::vector<std::string> first;
  for (std::size_t i = 0; i < colors_.size(); ++i)
    first.push_back(fmt::format(
        "'{}-bands.csv' index {} using 1:2 with filledcurves closed fillcolor "
        "rgb '{}' fillstyle transparent solid 0.18 noborder notitle",
        figure.name, i, colors_[i]));
  plots.insert(plots.begin(), first.begin(), first.end());
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

namespace {} // namespace

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

std::string load_color(std::size_t load) {
  constexpr std::array colors{"#56B4E9", "#0072B2", "#35102b"};
  return fmt::format("linecolor rgb '{}'", colors[load % colors.size()]);
}

std::string load_sign(std::size_t load) {
  constexpr std::array signs{8, 4, 6};
  return fmt::format("pointtype {} pointsize 0.6 linewidth 1.2 {}",
                     signs[load % signs.size()], load_color(load));
}

std::vector<std::size_t> three_of(std::size_t count) {
  std::vector<std::size_t> chosen;
  for (const std::size_t i : {std::size_t{0}, count / 2, count - 1})
    if (count > 0 && (chosen.empty() || chosen.back() < i))
      chosen.push_back(i);
  return chosen;
}

} // namespace asperity::reports
