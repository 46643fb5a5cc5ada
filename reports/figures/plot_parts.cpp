#include "reports/figures/plot_parts.hpp"

#include "base/field_sums.hpp"
#include "base/shown_number.hpp"
#include "base/special_numbers.hpp"
#include "reports/analysis/measured_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::reports {
namespace {

/// The mean over the realisations of one number of the surfaces; NaN without.
double mean_of_surfaces(const results::Result& result,
                        double results::SurfaceRecord::*number) {
  double sum = 0.0;
  for (const results::SurfaceRecord& surface : result.surfaces)
    sum += surface.*number;
  return result.surfaces.empty()
             ? not_a_number
             : sum / static_cast<double>(result.surfaces.size());
}

FigureScales scales_of_entry(const ReportEntry& entry) {
  FigureScales scales;
  scales.contact_modulus = entry.result->contact_modulus;
  scales.rms_height =
      mean_of_surfaces(*entry.result, &results::SurfaceRecord::rms_height);
  scales.rms_slope =
      mean_of_surfaces(*entry.result, &results::SurfaceRecord::rms_slope);
  if (!entry.result->surfaces.empty())
    scales.nominal_area = nominal_area(*entry.result);
  const auto is_in_si = [](const mechanics::Quantity& target) {
    return target.reference == mechanics::ReferenceUnit::si;
  };
  const cases::Case& contact_case = *entry.contact_case;
  scales.is_physical =
      !entry.result->case_text.empty() &&
      (contact_case.surface.kind == mechanics::SurfaceKind::measured ||
       std::ranges::any_of(contact_case.load.targets, is_in_si));
  return scales;
}

/// A unit, and the least number that is shown in it.
struct Unit {
  double size = 1.0;
  double from = 0.0;
  const char* name = "";
};

constexpr std::array<Unit, 4> pressure_units{
    {{1e9, 1e10, "GPa"}, {1e6, 1e5, "MPa"}, {1e3, 1e2, "kPa"}, {1, 0, "Pa"}}};
constexpr std::array<Unit, 3> length_units{
    {{1e-3, 2e-3, "mm"}, {1e-6, 2e-6, "µm"}, {1e-9, 0, "nm"}}};
constexpr std::array<Unit, 3> area_units{
    {{1e-6, 1e-6, "mm^2"}, {1e-12, 1e-13, "µm^2"}, {1e-18, 0, "nm^2"}}};

const Unit& unit_for(double number, std::span<const Unit> units) {
  for (const Unit& unit : units)
    if (number >= unit.from)
      return unit;
  return units.back();
}

ChartAxis axis_with_units(const std::string& label, const std::string& name,
                          double scale, const Unit& unit) {
  ChartAxis axis{.label = label};
  if (scale > 0.0 && std::isfinite(scale))
    axis.other = OtherUnits{fmt::format("{} [{}]", name, unit.name),
                            rounded(scale / unit.size, 9)};
  return axis;
}

} // namespace

FigureScales figure_scales(std::span<const ReportEntry> entries) {
  FigureScales shared = scales_of_entry(entries.front());
  for (const ReportEntry& entry : entries.subspan(1)) {
    if (!entry.result->methods.empty() &&
        entry.result->methods.front().kind == measured_kind)
      continue; // it has those of the first result
    const FigureScales scales = scales_of_entry(entry);
    for (double FigureScales::*scale :
         {&FigureScales::contact_modulus, &FigureScales::rms_height,
          &FigureScales::rms_slope, &FigureScales::nominal_area})
      if (!(std::abs(scales.*scale - shared.*scale) <= 1e-6 * shared.*scale))
        shared.*scale = not_a_number;
    shared.is_physical = shared.is_physical && scales.is_physical;
  }
  return shared;
}

FigureScales method_scales(const ReportEntry& entry,
                           const results::MethodRecord& method) {
  FigureScales scales = scales_of_entry(entry);
  const SurfaceScales own =
      scales_of(*entry.result, *entry.contact_case, method, 0);
  scales.rms_height = own.rms_height;
  scales.rms_slope = own.rms_slope;
  return scales;
}

ChartAxis pressure_axis(const std::string& label, const std::string& name,
                        double scale, double largest) {
  return axis_with_units(label, name, scale,
                         unit_for(scale * largest, pressure_units));
}

ChartAxis length_axis(const std::string& label, const std::string& name,
                      double scale, double largest) {
  return axis_with_units(label, name, scale,
                         unit_for(scale * largest, length_units));
}

ChartAxis area_axis(const FigureScales& scales, double largest) {
  const double area = scales.nominal_area;
  return axis_with_units("A / A_0", "contact area A", area,
                         unit_for(area * largest, area_units));
}

std::optional<OtherUnits> density_units(const std::string& name,
                                        const ChartAxis& axis) {
  if (!axis.other)
    return std::nullopt;
  const std::string& label = axis.other->label;
  return OtherUnits{name + " [1/" + label.substr(label.rfind('[') + 1),
                    1.0 / axis.other->factor};
}

ChartAxis load_axis(std::span<const Series> series,
                    const FigureScales& scales) {
  double largest = 0.0;
  for (const Series& one : series)
    for (const SeriesRow& row : one.rows)
      largest = std::max(largest, row.pressure);
  return pressure_axis("nominal pressure p / E*", "nominal pressure p",
                       scales.contact_modulus, largest);
}

std::string load_text(const FigureScales& scales, double nominal_pressure) {
  if (!scales.is_physical)
    return "p/E* = " +
           digits_text(nominal_pressure / scales.contact_modulus, 3);
  return "p = " + quantity_text(nominal_pressure, "Pa", 3);
}

void put_units(Figure& figure, const FigureScales& scales) {
  if (!scales.is_physical)
    return;
  figure.is_physical = true;
  for (ChartPanel& panel : figure.panels)
    use_other_units(panel);
}

bool is_spaced_logarithmically(std::vector<double> numbers) {
  std::erase_if(numbers, [](double number) { return !(number > 0.0); });
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  if (numbers.size() < 3)
    return false;
  double least = infinity, largest = 0.0; // ratios of neighbours, logarithms
  double narrowest = infinity, widest = 0.0;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const double ratio = std::log(numbers[i] / numbers[i - 1]);
    const double distance = numbers[i] - numbers[i - 1];
    least = std::min(least, ratio);
    largest = std::max(largest, ratio);
    narrowest = std::min(narrowest, distance);
    widest = std::max(widest, distance);
  }
  return largest / least < widest / narrowest;
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
    sides.lower.emplace_back(row.gap - row.gap_interval, row.pressure);
    sides.upper.emplace_back(row.gap + row.gap_interval, row.pressure);
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
    sides.lower.emplace_back(row.pressure,
                             std::max(row.area_corrected - row.area_interval,
                                      1e-3 * row.area_corrected));
    sides.upper.emplace_back(row.pressure,
                             row.area_corrected + row.area_interval);
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
  const Estimate* const found = series.method->quantity(name);
  return found == nullptr ? none : *found;
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

std::vector<results::Fields> shown_maps(const results::MethodRecord& method) {
  std::vector<results::Fields> shown;
  for (const results::Fields* fields : whole_maps(method))
    shown.push_back(fields->on_map());
  return shown;
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
  constexpr std::array signs{9, 5, 7};
  return markers(load_color(load), signs[load % signs.size()], 0.6, 1.2);
}

int map_sign(const ReportEntry& entry) {
  return entry.contact_case->surface.kind == mechanics::SurfaceKind::measured
             ? 6
             : 7;
}

std::vector<std::size_t> three_of(std::size_t count) {
  std::vector<std::size_t> chosen;
  for (const std::size_t i : {std::size_t{0}, count / 2, count - 1})
    if (count > 0 && (chosen.empty() || chosen.back() < i))
      chosen.push_back(i);
  return chosen;
}

} // namespace asperity::reports
