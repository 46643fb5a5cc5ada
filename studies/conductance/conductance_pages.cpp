// The figure and the text of [conductance].
#include "base/special_numbers.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/load_spread.hpp"
#include "reports/figures/plot_parts.hpp"
#include "results/types/method_columns.hpp"
#include "studies/conductance/conductance.hpp"
#include "studies/conductance/conductance_study.hpp"
#include "studies/spots/spots_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::studies {

using namespace reports;

namespace {

using results::CurvePoint;

constexpr double per_millimetre = 1e3; // [1/m]

class ConductanceFigure {
public:
  explicit ConductanceFigure(const ReportEntry& entry) : entry_(entry) {}

  void add_theory(const results::MethodRecord& method) {
    panel_.add(method.name + ", -dp/du", line("#222222", 1.6),
               curve(method, [&](const CurvePoint& row, std::size_t) {
                 return row.contact_stiffness / modulus();
               }));
    panel_.add(method.name + ", p/u_0", line("#222222", 1.0, 2),
               curve(method, [&](const CurvePoint& row, std::size_t r) {
                 return row.nominal_pressure / decay_length(method, r) /
                        modulus();
               }));
  }

  void add_numbers(const results::MethodRecord& method, std::size_t color) {
    Series as_series;
    as_series.kind = method.kind;
    as_series.color = color;
    const std::string own = series_color(as_series);
    panel_.add(method.name + ", standing contact", point_style(as_series),
               curve(method, [](const CurvePoint& row, std::size_t) {
                 return row[columns::relative_conductance];
               }));
    panel_.add(method.name + ", -dp/du of the curve", line(own, 1.4),
               curve(method, [&](const CurvePoint& row, std::size_t) {
                 return row.contact_stiffness / modulus();
               }));
    panel_.add(method.name + ", spots as circles alone", line(own, 1.0, 2),
               curve(method, [](const CurvePoint& row, std::size_t) {
                 return 2.0 * row[columns::spot_radii];
               }));
    panel_.add(method.name + ", Barber's lower bound", line(own, 1.0, 3),
               curve(method, [&](const CurvePoint& row, std::size_t r) {
                 const results::SurfaceRecord* const surface =
                     surface_of(*entry_.result, method, r);
                 return surface == nullptr
                            ? not_a_number
                            : row.nominal_pressure /
                                  (surface->highest - row.mean_gap) / modulus();
               }));
  }

  bool is_empty() const { return panel_.is_empty(); }

  Figure take() && {
    Figure figure;
    figure.name = "conductance";
    figure.title = "Conductance and stiffness against load";
    figure.caption =
        "Conductance over conductivity, G/k, which is the incremental normal "
        "stiffness K over E*, both per nominal area. Markers: of the "
        "standing contact, the median over realisations; bars span their "
        "range, and crosses at the axis are loads without contact, where it "
        "is 0. Lines: the slope of the curve of pressure against mean "
        "gap, which lies between the loads, that of the theory and its limit "
        "p/u_0 at light load, Eq. (18) of Yang and Persson (2008), the spots "
        "as circles of their areas that do not disturb each other, and "
        "Barber's lower bound p/(h_max - u).";
    const CurvePoint unit = unit_row();
    if (unit[columns::thermal_conductance] > 0.0)
      figure.caption +=
          fmt::format(" 1/mm is {:.4g} W/(m^2 K).",
                      unit[columns::thermal_conductance] * per_millimetre);
    if (unit[columns::electrical_conductance] > 0.0)
      figure.caption +=
          fmt::format(" 1/mm is {:.4g} per Ohm m^2.",
                      unit[columns::electrical_conductance] * per_millimetre);
    panel_.move_to(figure, "K/E^* = G/k  [1/mm]");
    return figure;
  }

private:
  double modulus() const { return entry_.result->contact_modulus; }

  /// u_0 of Eq. (18) of a theory [m]; NaN without it.
  double decay_length(const results::MethodRecord& method,
                      std::size_t realization) const {
    const auto& methods = entry_.summary.methods;
    const auto found =
        std::ranges::find(methods, method.name, &MethodSummary::name);
    if (found == methods.end() || found->fits.size() <= realization)
      return not_a_number;
    const RealizationFits& fits = found->fits[realization];
    return fits.asymptotic_slope * fits.scales.rms_height;
  }

  template <class Number>
  SpreadCurve curve(const results::MethodRecord& method,
                    const Number& number) const {
    return spread_curve(method, number);
  }

  /// The conductances over the relative one, of the first row that has them.
  CurvePoint unit_row() const {
    for (const results::MethodRecord& method : entry_.result->methods)
      for (const results::Curve& realization : method.realizations)
        for (CurvePoint row : realization.points)
          if (row[columns::relative_conductance] > 0.0) {
            row[columns::thermal_conductance] /=
                row[columns::relative_conductance];
            row[columns::electrical_conductance] /=
                row[columns::relative_conductance];
            return row;
          }
    return {};
  }

  const ReportEntry& entry_;
  SpreadPanel panel_{"G/k [1/mm]", per_millimetre, "without contact"};
};

std::vector<Figure> conductance_figures(const ReportEntry& entry, std::size_t,
                                        std::span<const Series>) {
  std::vector<Figure> figures;
  if (asks<ConductanceStudy>(*entry.contact_case))
    if (auto figure =
            figure_of_methods(ConductanceFigure(entry), entry.result->methods))
      figures.push_back(std::move(*figure));
  return figures;
}

std::string conductance_text(const cases::Case& contact_case) {
  const auto* const study = contact_case.study<ConductanceStudy>();
  if (study == nullptr)
    return "";
  std::string text =
      " The conductance and the incremental normal stiffness are those of a "
      "rigid punch on the nodes in contact, by Barber's analogy "
      "[barber2003]; the conductance of full blocks follows from Laplace's "
      "equation.";
  if (study->gap_conductivity)
    text += " The medium in the gap conducts as a film beside the contact.";
  return text;
}

} // namespace

const StudyPages& conductance_pages() {
  static const StudyPages pages{.name = "conductance",
                                .figure_names = {"conductance"},
                                .figures = conductance_figures,
                                .methods_text = conductance_text};
  return pages;
}

} // namespace asperity::studies
