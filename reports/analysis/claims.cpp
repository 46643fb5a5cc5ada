#include "reports/analysis/claims.hpp"

#include "input/types/expectations.hpp"
#include "reports/analysis/comparison.hpp"
#include "reports/analysis/rough.hpp"
#include "reports/analysis/summary.hpp"
#include "reports/analysis/two_surfaces.hpp"
#include "reports/numbers/determined.hpp"
#include "surfaces/build.hpp"
#include "theory/exact/asperity_models.hpp"
#include "theory/persson/highest_peak.hpp"
#include "theory/persson/persson.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

theory::ProfileMoments moments_of(const mechanics::SurfaceSpec& surface,
                                  std::optional<double> magnification) {
  const surfaces::IsotropicSpectrum formula =
      surfaces::formula_spectrum(surface);
  const theory::HeightSpectrum spectrum(
      theory::SpectrumFormula{formula.density, formula.kinks});
  if (!magnification)
    return spectrum.profile_moments();
  return spectrum.between(0.0, *magnification * surface.wavevector_roll_off)
      .profile_moments();
}

// Returns u [m] at which independent asperities carry the load; NaN if they
// would have to be compressed beyond the mean plane.
double gap_of_asperities(const theory::ProfileMoments& moments,
                         double contact_modulus, double nominal_pressure) {
  const double rms_height = std::sqrt(moments.height);
  const auto excess = [&](double reduced_gap) {
    return std::log(theory::bush_gibson_thomas(moments, contact_modulus,
                                               reduced_gap * rms_height)
                        .nominal_pressure /
                    nominal_pressure);
  };
  const double highest = 10.0; // where p is of the order of e^-50 E*
  if (!(excess(0.0) > 0.0 && excess(highest) < 0.0))
    return not_a_number;
  std::uintmax_t steps = 100;
  const auto root = boost::math::tools::toms748_solve(
      excess, 0.0, highest, boost::math::tools::eps_tolerance<double>(40),
      steps);
  return 0.5 * (root.first + root.second) * rms_height;
}

/// Adds to a theory that used the analytical spectrum of a self-affine case
///  - highest_asperity: expected_highest() of a cell of the case's length
///  - asperity_shortfall: (u_theory - u)/h_rms at the lightest load, with u of
///    Bush, Gibson and Thomas, which describes asperities of an infinite
///    surface that do not interact
void add_tail_quantities(const results::Result& result,
                         const cases::Case& contact_case,
                         const results::MethodRecord& method,
                         MethodSummary& summary) {
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  if (!uses_formula(contact_case, method) ||
      surface.kind != mechanics::SurfaceKind::self_affine ||
      method.realizations.empty())
    return;
  const theory::ProfileMoments moments =
      moments_of(surface, magnification_of(contact_case, method));
  const double area = surface.length ? *surface.length * *surface.length : 0.0;
  if (theory::peaks_above(moments, std::fmax(area, 1e-300), 1.0) >= 4.0)
    summary.quantities["highest_asperity"] =
        single_number(theory::expected_highest(moments, area),
                      "expected value for a Gaussian surface of this size",
                      "expected value for a Gaussian surface of this size");
  const auto rows = loading_rows(method.realizations.front().points);
  if (rows.empty())
    return;
  const double gap = gap_of_asperities(moments, result.contact_modulus,
                                       rows.front().nominal_pressure);
  const std::string remark =
      "with u of Bush, Gibson and Thomas at the lightest load";
  summary.quantities["asperity_shortfall"] =
      single_number((rows.front().mean_gap - gap) / std::sqrt(moments.height),
                    remark, remark);
}

using results::CurvePoint;
using results::MethodRecord;
using results::SurfaceRecord;

double log_linearity(std::span<const CurvePoint> points, double rms_height) {
  std::vector<double> log_pressure;
  std::vector<double> gap;
  for (const CurvePoint& row : loading_rows(points))
    if (const double reduced = row.mean_gap / rms_height;
        reduced >= log_linear_from && reduced <= log_linear_to) {
      log_pressure.push_back(std::log(row.nominal_pressure));
      gap.push_back(reduced);
    }
  return gap.size() < 4 ? not_a_number
                        : fit_line(log_pressure, gap).largest_residual;
}

double area_linearity(std::span<const CurvePoint> points) {
  std::vector<double> ratios;
  double sum = 0.0;
  for (const CurvePoint& row : loading_rows(points))
    if (row.area_fraction_corrected > 0.0 &&
        row.area_fraction_corrected <= linear_area) {
      ratios.push_back(row.area_fraction_corrected / row.nominal_pressure);
      sum += ratios.back();
    }
  if (ratios.size() < 2)
    return not_a_number;
  const double mean = sum / static_cast<double>(ratios.size());
  double largest = 0.0;
  for (const double ratio : ratios)
    largest = std::max(largest, std::abs(ratio / mean - 1.0));
  return largest;
}

double area_at_highest_load(std::span<const CurvePoint> points) {
  const std::vector<CurvePoint> rows = loading_rows(points);
  return rows.empty() ? not_a_number : rows.back().area_fraction_corrected;
}

double gap_shortfall(std::span<const CurvePoint> points,
                     const CurveFunction& reference, double rms_height) {
  for (const Deviation& row : deviations(points, reference))
    if (std::isfinite(row.reference_gap)) // rows are in ascending pressure
      return (row.reference_gap - row.gap) / rms_height;
  return not_a_number;
}

FittedValue fractal_dimension(const SurfaceRecord& surface,
                              const mechanics::SurfaceSpec& spec,
                              double highest) {
  std::vector<double> log_wavevector;
  std::vector<double> log_spectrum;
  for (const results::SpectrumPoint& point : surface.spectrum)
    if (point.spectrum > 0.0 && point.wavevector >= spec.wavevector_roll_off &&
        point.wavevector <= highest) {
      log_wavevector.push_back(std::log(point.wavevector));
      log_spectrum.push_back(std::log(point.spectrum));
    }
  const LineFit line = fit_line(log_wavevector, log_spectrum);
  // C ~ q^(-2-2H), D = 3 - H
  return {4.0 + 0.5 * line.slope, 0.5 * line.slope_error, line.points - 2};
}

void add_surface_quantities(const results::Result& result,
                            const cases::Case& contact_case,
                            const MethodRecord& method,
                            MethodSummary& summary) {
  const std::size_t count = method.realizations.size();
  const auto of_surface = [&](const char* name, auto number) {
    summary.quantities[name] = mean_over_realizations(
        count, "the surface is not in the result",
        [&](std::size_t r) { return number(*surface_of(result, method, r)); });
  };
  of_surface("rms_height",
             [](const SurfaceRecord& surface) { return surface.rms_height; });
  of_surface("highest_asperity", [](const SurfaceRecord& surface) {
    return surface.highest / surface.rms_height;
  });
  if (contact_case.surface.kind != mechanics::SurfaceKind::self_affine)
    return;
  double highest = contact_case.surface.wavevector_high;
  if (const auto zeta = magnification_of(contact_case, method))
    highest =
        std::min(highest, *zeta * contact_case.surface.wavevector_roll_off);
  std::vector<FittedValue> dimensions;
  for (std::size_t r = 0; r < count; ++r)
    dimensions.push_back(fractal_dimension(*surface_of(result, method, r),
                                           contact_case.surface, highest));
  summary.quantities["fractal_dimension"] =
      determined(mean_over_realizations(dimensions), positive_range);
}

// Each quantity has a single value because the two surfaces form one pair.
void add_sum_quantities(const results::Result& result,
                        const mechanics::SurfaceSpec& surface,
                        MethodSummary& summary) {
  const auto sum = sum_of_two_surfaces(result);
  if (!sum)
    return;
  const std::string remark = "from the sum of both surfaces";
  summary.quantities["sum_rms_height"] =
      single_number(sum->rms_height, remark, remark);
  if (surface.kind == mechanics::SurfaceKind::self_affine)
    summary.quantities["sum_spectrum_ratio"] = single_number(
        sum_spectrum_ratio(result, *sum, surface.wavevector_roll_off,
                           surface.wavevector_high),
        remark, remark);
}

void add_curve_quantities(const MethodRecord& method, MethodSummary& summary) {
  const std::size_t count = method.realizations.size();
  summary.quantities["log_linearity"] = mean_over_realizations(
      count, "fewer than 4 load steps with 1 <= u / h_rms <= 2",
      [&](std::size_t r) {
        return log_linearity(method.realizations[r].points,
                             summary.fits[r].scales.rms_height);
      });
  summary.quantities["area_linearity"] = mean_over_realizations(
      count, "fewer than 2 load steps with a contact fraction up to 10 %",
      [&](std::size_t r) {
        return area_linearity(method.realizations[r].points);
      });
  summary.quantities["area_at_highest_load"] =
      mean_over_realizations(count, "no load steps", [&](std::size_t r) {
        return area_at_highest_load(method.realizations[r].points);
      });
}

const std::vector<std::pair<std::string, std::string>>& meanings() {
  static const std::vector<std::pair<std::string, std::string>> table = {
      {"area_scale_lower_half", "area_scale over the lighter half of the "
                                "loads [1]."},
      {"area_scale_upper_half", "area_scale over the heavier half of the "
                                "loads [1]."},
      {"area_scale_corrected_lower_half",
       "area_scale_corrected over the lighter half of the loads [1]."},
      {"area_scale_corrected_upper_half",
       "area_scale_corrected over the heavier half of the loads [1]."},
      {"epsilon",
       "eps of Eq. (16) of Yang and Persson (2008) at the case's gamma [1]."},
      {"log_linearity", "Largest deviation of u / h_rms from its least-squares "
                        "line over ln p, where 1 < u / h_rms < 2 [1]."},
      {"gap_deviation_to_2", "Largest |u - u of theory| / h_rms where "
                             "0.2 < u / h_rms < 2 [1]."},
      {"area_linearity",
       "Largest |(A/p) / mean - 1| for contact fractions up to 10 % [1]."},
      {"area_at_highest_load", "A/A_0 at the highest load of the case [1]."},
      {"pressure_offset", "Median of ln(p / p of theory) at equal u, where 0.3 "
                          "< u / h_rms < 1.5 [1]."},
      {"departure_low", "u / h_rms below which ln(p / p of theory) at equal u "
                        "differs from its median by more than 0.1 [1]."},
      {"departure_high", "u / h_rms above which ln(p / p of theory) at equal u "
                         "differs from its median by more than 0.1 [1]."},
      {"gap_shortfall", "(Theory's u - u) / h_rms at the lightest load [1]."},
      {"asperity_shortfall",
       "(Theory's u - u) / h_rms at the lightest load, with u of asperities of "
       "an infinite surface that do not interact [1]."},
      {"highest_asperity", "Largest height / h_rms [1]."},
      {"rms_height", "Root mean square of the heights [m]."},
      {"sum_rms_height", "h_rms of the sum of both surfaces [m]."},
      {"sum_spectrum_ratio", "Mean of C(q) of the sum of both surfaces over "
                             "C_0 + C_1, roll-off to cut-off [1]."},
      {"fractal_dimension", "3 - H of the measured spectrum [1]."}};
  return table;
}

} // namespace

void add_claim_quantities(const results::Result& result,
                          const cases::Case& contact_case,
                          const MethodRecord& method,
                          const MethodRecord* reference,
                          MethodSummary& summary) {
  const Estimate* const gamma = summary.quantity("gamma_curve");
  if (method.kind == "theory" && gamma != nullptr && gamma->has_value())
    summary.quantities["epsilon"] = single_number(
        theory::persson_epsilon(gamma->value),
        "Eq. (16) of Yang and Persson (2008) at the gamma of the case", "");
  add_tail_quantities(result, contact_case, method, summary);
  if (!uses_formula(contact_case, method) &&
      surface_of(result, method, 0) != nullptr) {
    add_surface_quantities(result, contact_case, method, summary);
    add_sum_quantities(result, contact_case.surface, summary);
  }
  add_curve_quantities(method, summary);
  if (method.kind == "theory" || reference == nullptr)
    return;
  summary.quantities["gap_shortfall"] = mean_over_realizations(
      method.realizations.size(), "no load that the theory also covers",
      [&](std::size_t r) {
        return gap_shortfall(method.realizations[r].points,
                             CurveFunction(curve_of(*reference, r).points),
                             summary.fits[r].scales.rms_height);
      });
  summary.quantities["gap_deviation_to_2"] = mean_over_realizations(
      method.realizations.size(),
      "no such load step that the theory also covers", [&](std::size_t r) {
        return largest_gap_deviation(
            deviations(method.realizations[r].points,
                       CurveFunction(curve_of(*reference, r).points)),
            summary.fits[r].scales.rms_height, 0.2, 2.0);
      });
  const auto departure_part = [&](const char* name, const char* missing,
                                  double Departure::*part) {
    summary.quantities[name] = mean_over_realizations(
        method.realizations.size(), missing, [&](std::size_t r) {
          return departure_from(method.realizations[r].points,
                                CurveFunction(curve_of(*reference, r).points),
                                summary.fits[r].scales.rms_height).*
                 part;
        });
  };
  const char* together =
      "no departure within the load range, or no agreement at u = h_rms";
  departure_part("pressure_offset",
                 "no load step in the range of the comparison",
                 &Departure::offset);
  departure_part("departure_low", together, &Departure::low);
  departure_part("departure_high", together, &Departure::high);
}

std::string meaning_of(const std::string& quantity) {
  if (const auto* known = cases::expectation_called(quantity))
    return known->description;
  for (const auto& [name, meaning] : meanings())
    if (name == quantity)
      return meaning;
  return "";
}

} // namespace asperity::reports
