// The figure and the text of [conductance].
#include "base/special_numbers.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/load_spread.hpp"
#include "reports/figures/plot_parts.hpp"
#include "results/types/method_columns.hpp"
#include "studies/conductance/conductance.hpp"
#include "studies/spots/spots.hpp"

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
               spread_curve(method, [&](const CurvePoint& row, std::size_t) {
                 return row.contact_stiffness / modulus();
               }));
    panel_.add(method.name + ", p/u_0", line("#222222", 1.0, 2),
               spread_curve(method, [&](const CurvePoint& row, std::size_t r) {
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
               spread_curve(method, [](const CurvePoint& row, std::size_t) {
                 return row[columns::relative_conductance];
               }));
    panel_.add(method.name + ", -dp/du of the curve", line(own, 1.4),
               spread_curve(method, [&](const CurvePoint& row, std::size_t) {
                 return row.contact_stiffness / modulus();
               }));
    panel_.add(method.name + ", spots as circles alone", line(own, 1.0, 2),
               spread_curve(method, [](const CurvePoint& row, std::size_t) {
                 return 2.0 * row[columns::spot_radii];
               }));
    panel_.add(method.name + ", Barber's lower bound", line(own, 1.0, 3),
               spread_curve(method, [&](const CurvePoint& row, std::size_t r) {
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
    const MethodSummary* const found =
        method_called(entry_.summary.methods, method.name);
    if (found == nullptr || found->fits.size() <= realization)
      return not_a_number;
    const RealizationFits& fits = found->fits[realization];
    return fits.asymptotic_slope * fits.scales.rms_height;
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

std::optional<Figure> conductance_figure(const ReportEntry& entry) {
  if (!asks<ConductanceStudy>(*entry.contact_case))
    return std::nullopt;
  return figure_of_methods(ConductanceFigure(entry), entry.result->methods);
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

/// Other stiffnesses over that of the standing contact.
std::vector<NumberAtLoad> stiffness_ratios() {
  return {
      {{.name = "curve_stiffness_ratio",
        .description = "-dp/du of the curve over the stiffness of the standing "
                       "contact; needs [conductance] and a step at this load "
                       "[1].",
        .of = cases::QuantityOf::load},
       [](const StepAtLoad& step) {
         return step.row.contact_stiffness / step.contact_modulus /
                step.row[columns::relative_conductance];
       }},
      {{.name = "spot_stiffness_ratio",
        .description = "Stiffness of the spots as circles alone over that of "
                       "the standing contact; needs [conductance], [spots] and "
                       "a step at this load [1].",
        .of = cases::QuantityOf::load},
       [](const StepAtLoad& step) {
         return 2.0 * step.row[columns::spot_radii] /
                step.row[columns::relative_conductance];
       }},
      {{.name = "theory_stiffness_ratio",
        .description = "-dp/du of theory over the stiffness of the standing "
                       "contact; needs [conductance] and a step at this load "
                       "[1].",
        .needs_theory = true,
        .of = cases::QuantityOf::load},
       [](const StepAtLoad& step) {
         return step.theory->contact_stiffness / step.contact_modulus /
                step.row[columns::relative_conductance];
       }}};
}

} // namespace

const StudyPages& conductance_pages() {
  static const StudyPages pages{.name = "conductance",
                                .figure_names = {"conductance"},
                                .figures = drawn_by<conductance_figure>,
                                .methods_text = conductance_text,
                                .at_load = stiffness_ratios()};
  return pages;
}

} // namespace asperity::studies
