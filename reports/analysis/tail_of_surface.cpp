#include "reports/analysis/tail_of_surface.hpp"

#include "surfaces/build.hpp"
#include "theory/exact/asperity_models.hpp"
#include "theory/persson/highest_peak.hpp"

#include <boost/math/tools/toms748_solve.hpp>

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

void add(MethodSummary& summary, const char* name, double value,
         const char* remark) {
  Estimate& estimate = summary.quantities[name];
  estimate.value = value;
  estimate.realizations = estimate.has_value() ? 1 : 0;
  estimate.remark = remark;
}

} // namespace

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
    add(summary, "highest_asperity", theory::expected_highest(moments, area),
        "expected value for a Gaussian surface of this size");
  const auto rows = loading_rows(method.realizations.front().points);
  if (rows.empty())
    return;
  const double gap = gap_of_asperities(moments, result.contact_modulus,
                                       rows.front().nominal_pressure);
  add(summary, "asperity_shortfall",
      (rows.front().mean_gap - gap) / std::sqrt(moments.height),
      "with u of Bush, Gibson and Thomas at the lightest load");
}

} // namespace asperity::reports
