#include "reports/analysis/asked_interval.hpp"

#include "reports/analysis/measured_curve.hpp"
#include "reports/analysis/surface_theory.hpp"
#include "reports/numbers/number_text.hpp"
#include "results/types/method_columns.hpp"
#include "surfaces/analysis/reliable_range.hpp"

#include <boost/math/special_functions/erf.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity::reports {
namespace {

using mechanics::SurfaceKind;
using results::CurvePoint;

/// Whether a converged step of the method has a number.
template <class Number>
bool has_any(const results::MethodRecord& method, const Number& number) {
  return std::ranges::any_of(
      method.realizations, [&](const results::Curve& curve) {
        return std::ranges::any_of(curve.points, [&](const CurvePoint& row) {
          return row.status == results::StepStatus::converged &&
                 std::isfinite(number(row));
        });
      });
}

double grid_error(const CurvePoint& row) {
  return std::abs(row.area_fraction - row.area_fraction_corrected);
}

double solver_error(const CurvePoint& row) {
  return row[columns::certified_gap_error];
}

double at_least_0(double number) {
  return number > 0.0 ? number : 0.0;
}

/// The shortest reliable wave of a map as a wavevector [rad/m]: that of the
/// noise floor, the sampling, or the cut-off by which it was filtered.
double last_reliable(const std::vector<surfaces::SpectrumRing>& rings,
                     const results::SurfaceRecord& surface, double area) {
  const double sampling = std::numbers::pi / std::max(surface.grid.spacing_x(),
                                                      surface.grid.spacing_y());
  const auto floor = noise_floor_of(rings, surface.grid, area);
  double whole = 0.0;
  for (const surfaces::SpectrumRing& ring : rings)
    whole += ring.wavevector * ring.wavevector * ring.mean_square_height;
  double below = 0.0, last = 0.0;
  for (const surfaces::SpectrumRing& ring : rings) {
    last = ring.wavevector;
    below += ring.wavevector * ring.wavevector * ring.mean_square_height;
    if (below >= 0.999 * whole)
      break;
  }
  return std::min({sampling, last, floor ? floor->wavevector : sampling});
}

/// The theory of the rings up to a wavevector; null if they have none.
std::shared_ptr<const theory::PerssonContact>
theory_up_to(double wavevector,
             const std::vector<surfaces::SpectrumRing>& rings,
             double contact_modulus) {
  std::vector<theory::SpectrumShell> shells;
  for (const surfaces::SpectrumRing& ring : rings)
    if (ring.wavevector <= wavevector && ring.mean_square_height > 0.0)
      shells.push_back({ring.wavevector, ring.mean_square_height});
  if (shells.size() < 2)
    return nullptr;
  return std::make_shared<theory::PerssonContact>(
      theory::HeightSpectrum(std::move(shells)), contact_modulus, 1.0);
}

} // namespace

AskedIntervals::AskedIntervals(const results::Result& result,
                               const cases::Case& contact_case,
                               const results::MethodRecord& method) {
  if (method.kind == measured_kind)
    return;
  if (has_any(method, grid_error))
    parts_.push_back({"grid of the area", true,
                      "as much as the correction of the counted area, of which "
                      "it leaves less than half"});
  else
    parts_.push_back({"grid of the area", false,
                      "this method does not correct its counted area; a "
                      "second run with twice the points tells it"});
  if (has_any(method, solver_error))
    parts_.push_back(
        {"solver", true, "the certified bound of the mean gap on this grid"});
  if (method.realizations.size() > 1)
    parts_.push_back({"realisations", true, "the 95 % interval of their mean"});
  if (result.case_text.empty() ||
      contact_case.surface.kind != SurfaceKind::measured)
    return;
  add_short_waves(result);
  parts_.push_back(
      {"level and form", false, "other values of surface.level tell it"});
  parts_.push_back(
      {"place and size of the map", false, "maps of several places tell it"});
}

void AskedIntervals::add_short_waves(const results::Result& result) {
  IntervalPart part{"short waves", false,
                    "a sweep over surface.cut_off tells it"};
  if (!result.surfaces.empty() && !result.surfaces.front().spectrum.empty()) {
    const results::SurfaceRecord& surface = result.surfaces.front();
    const double area = nominal_area(result);
    const auto rings = spectrum_rings(surface, area);
    const double last = last_reliable(rings, surface, area);
    all_ = theory_up_to(rings.back().wavevector, rings, result.contact_modulus);
    long_ = theory_up_to(0.5 * last, rings, result.contact_modulus);
    part.is_known = all_ != nullptr && long_ != nullptr;
    if (part.is_known)
      part.text = fmt::format(
          "by Persson's theory, what the waves shorter than {} change, twice "
          "the shortest reliable one",
          quantity_text(4.0 * std::numbers::pi / last, "m", 3));
  }
  parts_.push_back(std::move(part));
}

HalfWidths AskedIntervals::of(const CurvePoint& row) const {
  HalfWidths widths{at_least_0(grid_error(row)), at_least_0(solver_error(row))};
  if (all_ == nullptr || long_ == nullptr)
    return widths;
  const double area = std::isfinite(row.area_fraction_corrected)
                          ? row.area_fraction_corrected
                          : row.area_fraction;
  if (!(area > 0.0 && area < 1.0))
    return widths;
  // Of the theory, the load with this area: A = erf(x), x = 2^(1/2) p/(E* h').
  const double slope = all_->spectrum().rms_slope();
  const double x = boost::math::erf_inv(area);
  const double load = x * all_->contact_modulus() * slope / std::numbers::sqrt2;
  const double growth = slope / long_->spectrum().rms_slope();
  widths.area +=
      std::max(std::erf(x * growth) - area, area - std::erf(x / growth));
  // Near full contact the gap of the theory is too small to be changed by much.
  const double gap = all_->mean_gap(load);
  const double change = std::abs(long_->mean_gap(load) - gap);
  widths.gap +=
      gap > 0.0 ? change * std::max(1.0, std::abs(row.mean_gap) / gap) : change;
  return widths;
}

std::string parts_sentence(const std::vector<IntervalPart>& parts) {
  std::vector<std::string> known, unknown;
  for (const IntervalPart& part : parts)
    (part.is_known ? known : unknown).push_back(part.name);
  if (known.empty())
    return "";
  return fmt::format(
      "The intervals contain: {}{}{}.", fmt::join(known, ", "),
      unknown.empty() ? "" : "; not: ", fmt::join(unknown, ", "));
}

} // namespace asperity::reports
