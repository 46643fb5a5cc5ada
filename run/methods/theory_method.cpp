#include "run/methods/theory_method.hpp"

#include "base/cpu_clock.hpp"
#include "base/special_numbers.hpp"
#include "input/types/units.hpp"
#include "results/observables/row_observer.hpp"
#include "results/types/method_columns.hpp"
#include "run/methods/step_solver.hpp"
#include "theory/persson/persson.hpp"
#include "theory/persson/plastic_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace asperity::methods {
namespace {

/// Of the search for the pressure that belongs to a mean gap, over h_rms.
constexpr double gap_accuracy = 1e-9;

theory::PerssonContact contact_of(const mechanics::TheorySettings& settings,
                                  const theory::HeightSpectrum& spectrum,
                                  double contact_modulus) {
  theory::PerssonContact contact(spectrum, contact_modulus, settings.gamma);
  switch (settings.loss_factor) {
  case mechanics::LossFactor::yang_persson:
    break;
  case mechanics::LossFactor::wang_mueser:
    return contact.with_law(theory::LossLaw::wang_mueser(settings.gamma));
  case mechanics::LossFactor::xu:
    return contact.with_law(theory::LossLaw::xu(settings.gamma));
  }
  return contact;
}

const char* law_words(mechanics::LossFactor loss_factor) {
  switch (loss_factor) {
  case mechanics::LossFactor::yang_persson:
    break;
  case mechanics::LossFactor::wang_mueser:
    return " with the loss factor of Wang and Müser";
  case mechanics::LossFactor::xu:
    return " with the loss factor of Xu et al.";
  }
  return "";
}

/// The areas of a row between two absorbing boundaries.
void yield(results::CurvePoint& row, const theory::PerssonContact& contact,
           double hardness) {
  row.area_fraction = row.area_fraction_corrected = not_a_number;
  results::RowObserver observe(row);
  if (row.is_unloading) {
    observe(columns::area_fraction, [] {
      return results::Observed{
          results::Observed::none,
          "the theory knows no imprint of an earlier, larger load"};
    });
    return;
  }
  observe(columns::plastic_area, [&] {
    const theory::PlasticShares shares = theory::plastic_shares(
        row.nominal_pressure, contact.stress_variance(row.nominal_pressure),
        hardness);
    row.area_fraction = row.area_fraction_corrected =
        std::min(1.0, shares.elastic + shares.plastic);
    return std::clamp(shares.plastic, 0.0, 1.0);
  });
}

results::CurvePoint row_at(const theory::PerssonContact& contact,
                           double nominal_pressure) {
  results::CurvePoint row;
  row.nominal_pressure = nominal_pressure;
  results::RowObserver observe(row);
  observe(columns::mean_gap,
          [&] { return contact.mean_gap(nominal_pressure); });
  observe(columns::area_fraction,
          [&] { return contact.area_fraction(nominal_pressure); });
  row.area_fraction_corrected = row.area_fraction;
  row.contact_perimeter = not_a_number;
  observe(columns::elastic_energy,
          [&] { return contact.elastic_energy(nominal_pressure); });
  observe(columns::contact_stiffness,
          [&] { return contact.contact_stiffness(nominal_pressure); });
  if (std::isnan(row.mean_gap))
    row.status = results::StepStatus::not_converged;
  return row;
}

results::CurvePoint row_without_pressure(double mean_gap,
                                         const std::string& why) {
  results::CurvePoint row;
  row.nominal_pressure = not_a_number;
  row.mean_gap = mean_gap;
  row.area_fraction = row.area_fraction_corrected = not_a_number;
  row.contact_perimeter = row.elastic_energy = not_a_number;
  row.contact_stiffness = not_a_number;
  row.status = results::StepStatus::not_converged;
  row.note = why;
  return row;
}

results::CurvePoint row_at_gap(const theory::PerssonContact& contact,
                               double mean_gap) {
  if (mean_gap <= 0.0)
    return row_without_pressure(
        mean_gap, "the theory has no pressure for a mean gap <= 0");
  try {
    return row_at(contact, contact.nominal_pressure(mean_gap));
  } catch (const std::exception& error) {
    return row_without_pressure(mean_gap, error.what());
  }
}

} // namespace

MethodDescription describe(const mechanics::TheorySettings& settings) {
  return {"theory",
          fmt::format("Persson's theory{}, gamma = {:g}{}, spectrum {}",
                      law_words(settings.loss_factor), settings.gamma,
                      settings.hardness ? ", hardness " +
                                              cases::write_quantity(
                                                  *settings.hardness,
                                                  cases::Dimension::pressure) +
                                              " of the areas alone"
                                        : std::string(),
                      settings.spectrum == mechanics::TheorySpectrum::formula
                          ? "by the formula"
                          : "measured on the surface"),
          false};
}

TheoryInput theory_input(const cases::Case& contact_case,
                         const cases::MethodSpec& method,
                         const CaseSurfaces& surfaces, int realization) {
  if (method.needs_surface()) {
    const SurfaceOfCase& surface = surfaces.of(method, realization);
    return {spectrum_of(surface), surface.scales};
  }
  theory::HeightSpectrum spectrum = formula_of_case(contact_case, method);
  const mechanics::Scales scales = formula_scales(contact_case, spectrum);
  return {std::move(spectrum), scales};
}

std::vector<results::CurvePoint>
theory_rows(const mechanics::TheorySettings& settings,
            const mechanics::LoadingPath& load, const TheoryInput& input) {
  const mechanics::Scales& scales = input.scales;
  const theory::PerssonContact contact =
      contact_of(settings, input.spectrum, scales.contact_modulus);
  std::vector<results::CurvePoint> rows;
  for (std::size_t step = 0; step < load.targets.size(); ++step) {
    const CpuClock clock;
    const double target = load.targets[step].in_si(scales);
    const bool by_gap = load.control == mechanics::Control::mean_gap;
    results::CurvePoint row =
        by_gap ? row_at_gap(contact, target) : row_at(contact, target);
    if (row.status == results::StepStatus::converged)
      check_reached(load.target(step, scales),
                    {.nominal_pressure = row.nominal_pressure,
                     .mean_gap = row.mean_gap,
                     .imbalance = 0.0, // a formula
                     .gap_tolerance = gap_accuracy * scales.rms_height},
                    row);
    row.step = static_cast<int>(step);
    row.is_unloading = load.is_unloading[step];
    if (settings.hardness && std::isfinite(row.nominal_pressure))
      yield(row, contact, settings.hardness->in_si(scales));
    row.cpu_time = clock.seconds();
    rows.push_back(row);
  }
  return rows;
}

} // namespace asperity::methods
