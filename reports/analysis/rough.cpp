#include "reports/analysis/rough.hpp"

#include "reports/analysis/area_scale.hpp"
#include "reports/analysis/comparison.hpp"
#include "reports/analysis/law_errors.hpp"
#include "reports/numbers/determined.hpp"
#include "results/types/method_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace asperity::reports {
namespace {

using results::MethodRecord;
using results::Result;

double set_gamma(const cases::Case& contact_case, const MethodRecord& method) {
  const auto* theory =
      settings_of<mechanics::TheorySettings>(contact_case, method);
  return theory == nullptr ? not_a_number : theory->gamma;
}

/// u_0 of Eq. (18) over that for gamma = 1.
double decay_factor(const cases::Case& contact_case,
                    const MethodRecord& method) {
  const auto* theory =
      settings_of<mechanics::TheorySettings>(contact_case, method);
  if (theory == nullptr)
    return not_a_number;
  return theory->loss_factor == mechanics::LossFactor::yang_persson
             ? theory->gamma
             : std::sqrt(theory->gamma); // theory/persson/loss_law.hpp
}

SurfaceTheory theory_for(const Result& result, const cases::Case& contact_case,
                         const MethodRecord& method, std::size_t realization,
                         SurfaceTheories& theories) {
  if (uses_formula(contact_case, method)) {
    const auto magnification = magnification_of(contact_case, method);
    std::optional<double> highest;
    if (magnification)
      highest = *magnification * contact_case.surface.wavevector_roll_off;
    return theory_of_formula(contact_case.surface, result.contact_modulus,
                             highest);
  }
  // A map without its periodic continuation has no spectrum.
  const auto& own = method.realizations[realization].own_surface;
  if (own && !has_free_boundaries(contact_case, method))
    return theories.of(*own);
  if (realization >= result.surfaces.size())
    return {};
  return theories.of(result.surfaces[realization]);
}

theory::PerssonContact
with_settings(const theory::PerssonContact& contact,
              const mechanics::TheorySettings& settings) {
  switch (settings.loss_factor) {
  case mechanics::LossFactor::yang_persson:
    break;
  case mechanics::LossFactor::wang_mueser:
    return contact.with_law(theory::LossLaw::wang_mueser(settings.gamma));
  case mechanics::LossFactor::xu:
    return contact.with_law(theory::LossLaw::xu(settings.gamma));
  }
  return contact.with_gamma(settings.gamma);
}

results::CurvePoint theory_row(const theory::PerssonContact& contact,
                               double nominal_pressure) {
  results::CurvePoint row;
  row.nominal_pressure = nominal_pressure;
  row.area_fraction = row.area_fraction_corrected =
      contact.area_fraction(nominal_pressure);
  row.mean_gap = contact.mean_gap(nominal_pressure);
  return row;
}

/// Evaluates a theory between its loads, at equal ratios, or around a single
/// load up to a factor of 4. The result is empty if that is not the curve of
/// the rows, which have other roughness then.
std::vector<results::CurvePoint>
fine_curve(const theory::PerssonContact& contact,
           const std::vector<results::CurvePoint>& rows) {
  constexpr std::size_t least_points = 96;
  constexpr double tolerance = 1e-3; // of area and gap, relative
  std::vector<results::CurvePoint> fine;
  if (rows.empty() || rows.size() > least_points)
    return fine;
  const std::size_t parts =
      1 + least_points / std::max(std::size_t{1}, rows.size() - 1);
  fine.reserve(parts * rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double start = rows[i].nominal_pressure;
    const double area = contact.area_fraction(start);
    const double gap = contact.mean_gap(start);
    if (std::abs(area - rows[i].area_fraction) > tolerance * area ||
        std::abs(gap - rows[i].mean_gap) > tolerance * gap)
      return {};
    fine.push_back(rows[i]);
    if (i + 1 == rows.size())
      break;
    const double ratio = rows[i + 1].nominal_pressure / start;
    for (std::size_t k = 1; k < parts; ++k) {
      fine.push_back(theory_row(
          contact, start * std::pow(ratio, static_cast<double>(k) /
                                               static_cast<double>(parts))));
    }
  }
  if (rows.size() == 1) {
    const double load = rows.front().nominal_pressure;
    fine.clear();
    for (int k = -16; k <= 16; ++k)
      fine.push_back(theory_row(contact, load * std::pow(4.0, k / 16.0)));
  }
  return fine;
}

bool is_positive(double number) {
  return number > 0.0 && std::isfinite(number);
}

// Adds the fits that compare the curve with the theory of its own surface.
void add_theory_fits(const Result& result, const cases::Case& contact_case,
                     const MethodRecord& method, std::size_t realization,
                     SurfaceTheories& theories, RealizationFits& fits) {
  const double height = fits.scales.rms_height;
  const SurfaceTheory theory =
      theory_for(result, contact_case, method, realization, theories);
  if (method.kind == "theory") { // its parameter is an input
    fits.asymptotic_slope =
        decay_factor(contact_case, method) * theory.decay_length / height;
    if (const auto* settings =
            settings_of<mechanics::TheorySettings>(contact_case, method);
        theory.contact && settings != nullptr)
      fits.fine_curve =
          fine_curve(with_settings(*theory.contact, *settings),
                     loading_rows(method.realizations[realization].points));
    return;
  }
  if (!theory.gap) {
    fits.set_no_gamma("the heights are not in the result");
    return;
  }
  const auto& points = method.realizations[realization].points;
  fits.matched = fit_matched(points, fits.scales, theory.gap);
  fits.curve = fit_curve(points, fits.scales, theory.gap);
  fits.energy = fit_energy(points, fits.scales, theory.energy);
  const FittedValue& gamma = fits.curve.gamma;
  if (why_undetermined(gamma, gamma_range).empty())
    fits.asymptotic_slope = gamma.value * theory.decay_length / height;
}

RealizationFits fits_of(const Result& result, const cases::Case& contact_case,
                        const MethodRecord& method, std::size_t realization,
                        SurfaceTheories& theories) {
  RealizationFits fits;
  fits.scales = scales_of(result, contact_case, method, realization);
  if (!is_positive(fits.scales.rms_height) ||
      !is_positive(fits.scales.rms_slope)) {
    const char* reason =
        "h_rms or the rms slope of the surface is not known, or is 0";
    fits.slope.reason = fits.area.reason = reason;
    fits.set_no_gamma(reason);
    return fits;
  }
  const auto& points = method.realizations[realization].points;
  fits.slope = fit_slope(points, fits.scales);
  fits.area = fit_area(points, fits.scales);
  try {
    add_theory_fits(result, contact_case, method, realization, theories, fits);
  } catch (const std::domain_error& error) { // heights without a theory
    fits.set_no_gamma(
        fmt::format("there is no theory for this surface: {}", error.what()));
  }
  return fits;
}

// Returns the mean of one fitted value over the realisations, if it counts as a
// result. The criterion is applied to the mean and not to each realisation:
// discarding realisations outside the range would bias the mean towards it.
template <class Fit>
Estimate mean_of(const std::vector<RealizationFits>& fits,
                 Fit RealizationFits::*fit, FittedValue Fit::*fitted,
                 const MeaningfulRange& range) {
  std::vector<FittedValue> values;
  for (const RealizationFits& realization : fits) {
    values.push_back((realization.*fit).*fitted);
    if (values.back().reason.empty())
      values.back().reason = (realization.*fit).reason;
  }
  return determined(mean_over_realizations(values), range);
}

Estimate largest_of(const std::vector<double>& values,
                    const std::string& missing) {
  Estimate estimate;
  for (const double number : values) {
    estimate.value = std::fmax(estimate.value, number);
    estimate.realizations += std::isfinite(number);
  }
  estimate.remark =
      estimate.has_value()
          ? fmt::format("largest of {} realisation{}", estimate.realizations,
                        estimate.realizations == 1 ? "" : "s")
          : missing;
  return estimate;
}

Estimate area_excess_of(const MethodRecord& method,
                        const MethodRecord& reference, AreaColumn area) {
  return mean_over_realizations(
      method.realizations.size(),
      "no load step with A/A_0 <= 15 % that the theory also covers",
      [&](std::size_t r) {
        const CurveFunction theory(curve_of(reference, r).points);
        return light_load_area_excess(
            deviations(method.realizations[r].points, theory, area));
      });
}

Estimate gap_deviation_of(const MethodRecord& method,
                          const MethodRecord& reference,
                          const std::vector<RealizationFits>& fits) {
  std::vector<double> largest;
  for (std::size_t r = 0; r < method.realizations.size(); ++r) {
    const CurveFunction theory(curve_of(reference, r).points);
    largest.push_back(
        largest_gap_deviation(deviations(method.realizations[r].points, theory),
                              fits[r].scales.rms_height));
  }
  return largest_of(
      largest,
      fmt::format(
          "no load step with {} < u/h_rms < {} that the theory also covers",
          comparison_gap_low, comparison_gap_high));
}

/// One load of all realisations: u/h_rms and its deviation from the theory.
struct EnsembleLoad {
  double reduced_gap = 0.0; ///< sum over the realisations
  std::vector<FittedValue> deviations;
};

/// Returns the largest deviation of the mean over the realisations from the
/// theory, with the interval of that mean. Loads that a realisation lacks are
/// left out.
Estimate mean_gap_deviation_of(const MethodRecord& method,
                               const MethodRecord& reference,
                               const std::vector<RealizationFits>& fits) {
  constexpr double loads_per_unit = 1e6; // of ln p: equal to six digits
  std::map<long long, EnsembleLoad> loads;
  const std::size_t n = method.realizations.size();
  for (std::size_t r = 0; r < n; ++r) {
    const double height = fits[r].scales.rms_height;
    const CurveFunction theory(curve_of(reference, r).points);
    for (const Deviation& row :
         deviations(method.realizations[r].points, theory)) {
      if (!std::isfinite(row.reference_gap))
        continue;
      EnsembleLoad& load =
          loads[std::llround(loads_per_unit * std::log(row.nominal_pressure))];
      load.reduced_gap += row.gap / height;
      load.deviations.push_back(
          {.value = (row.gap - row.reference_gap) / height});
    }
  }
  Estimate largest;
  for (const auto& [key, load] : loads) {
    const double gap = load.reduced_gap / static_cast<double>(n);
    if (load.deviations.size() != n || gap < comparison_gap_low ||
        gap > comparison_gap_high)
      continue;
    Estimate mean = mean_over_realizations(load.deviations);
    mean.value = std::abs(mean.value);
    if (!largest.has_value() || mean.value > largest.value)
      largest = mean;
  }
  if (!largest.has_value())
    largest.remark = fmt::format("no load that all realisations share has {} < "
                                 "u/h_rms < {}",
                                 comparison_gap_low, comparison_gap_high);
  return largest;
}

Estimate pressure_difference_to(const MethodRecord& method,
                                const MethodRecord& base) {
  std::vector<double> largest;
  for (std::size_t r = 0; r < method.realizations.size(); ++r)
    largest.push_back(
        largest_pressure_difference(method.realizations[r].points,
                                    CurveFunction(curve_of(base, r).points)));
  return largest_of(largest, "no load that " + base.name + " also covers");
}

Estimate set_parameter(const cases::Case& contact_case,
                       const MethodRecord& method) {
  Estimate estimate;
  estimate.value = set_gamma(contact_case, method);
  estimate.remark =
      estimate.has_value() ? "set in the case" : "not set in the case";
  estimate.is_input = estimate.has_value();
  return estimate;
}

} // namespace

const results::Curve& curve_of(const MethodRecord& method,
                               std::size_t realization) {
  return method
      .realizations[std::min(realization, method.realizations.size() - 1)];
}

void add_rough_quantities(const Result& result, const cases::Case& contact_case,
                          const MethodRecord& method,
                          const MethodRecord* reference,
                          SurfaceTheories& theories, MethodSummary& summary) {
  for (std::size_t r = 0; r < method.realizations.size(); ++r)
    summary.fits.push_back(fits_of(result, contact_case, method, r, theories));
  auto& quantities = summary.quantities;
  quantities["gamma_slope"] = mean_of(summary.fits, &RealizationFits::slope,
                                      &SlopeFit::gamma_slope, gamma_range);
  quantities["beta"] = mean_of(summary.fits, &RealizationFits::slope,
                               &SlopeFit::beta, positive_range);
  quantities["kappa"] = mean_of(summary.fits, &RealizationFits::area,
                                &AreaFit::kappa, positive_range);
  quantities["kappa_counted"] =
      mean_of(summary.fits, &RealizationFits::area, &AreaFit::kappa_counted,
              positive_range);
  if (method.kind == "theory") {
    quantities["gamma_curve"] = set_parameter(contact_case, method);
    add_law_errors(result, contact_case, method, quantities);
    return;
  }
  quantities["gamma_matched"] = mean_of(summary.fits, &RealizationFits::matched,
                                        &ParameterFit::gamma, gamma_range);
  quantities["gamma_curve"] = mean_of(summary.fits, &RealizationFits::curve,
                                      &ParameterFit::gamma, gamma_range);
  quantities["gamma_energy"] = mean_of(summary.fits, &RealizationFits::energy,
                                       &ParameterFit::gamma, gamma_range);
  if (const MethodRecord* base = base_method(result, method))
    quantities["pressure_difference"] = pressure_difference_to(method, *base);
  if (reference == nullptr)
    return;
  quantities["gap_deviation"] =
      gap_deviation_of(method, *reference, summary.fits);
  quantities["mean_gap_deviation"] =
      mean_gap_deviation_of(method, *reference, summary.fits);
  add_area_scales(method, *reference, result.contact_modulus, summary);
  quantities["area_excess"] =
      area_excess_of(method, *reference, &columns::area_fraction);
  quantities["area_excess_fit"] =
      area_excess_of(method, *reference, &columns::area_fraction_fit);
  quantities["area_excess_moment"] =
      area_excess_of(method, *reference, &columns::area_fraction_moment);
}

} // namespace asperity::reports
