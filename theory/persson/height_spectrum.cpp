#include "theory/persson/height_spectrum.hpp"

#include "base/require.hpp"
#include "theory/persson/roughness_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace asperity::theory {

struct HeightSpectrum::Prepared {
  double wavevector_low = 0.0;
  double wavevector_high = 0.0;
  ProfileMoments moments;
  double full_contact_moment = 0.0;
  std::vector<RoughnessNode> nodes;

  Prepared(double low, double high, SpectrumIntegrals integrals)
      : wavevector_low(low),
        wavevector_high(high),
        full_contact_moment(integrals.full_contact),
        nodes(std::move(integrals.nodes)) {
    using std::numbers::pi;
    moments.height = 2.0 * pi * integrals.height;
    moments.slope = pi * integrals.slope;
    moments.curvature = 0.75 * pi * integrals.curvature;
    require_positive("rms_slope of the spectrum", rms_slope(), "1");
  }

  double rms_slope() const { return std::sqrt(2.0 * moments.slope); }
};

namespace {

void check(const SpectrumFormula& formula) {
  const std::vector<double>& breaks = formula.breaks;
  if (breaks.size() < 2)
    refuse_argument("number of breaks", static_cast<double>(breaks.size()),
                    ">= 2: q_L, kinks, q_1");
  double before = 0.0;
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    if (!(breaks[i] > before && std::isfinite(breaks[i])))
      refuse_argument("breaks[" + std::to_string(i) + "]", breaks[i],
                      "finite and above the break before it [rad/m]");
    before = breaks[i];
  }
}

// A spectrum that is zero up to one of its breaks is made to start at that
// break.
void drop_empty_start(SpectrumFormula& formula) {
  std::vector<double>& breaks = formula.breaks;
  const int n_samples = 8;
  const auto is_empty = [&](double low, double high) {
    for (int i = 0; i < n_samples; ++i)
      if (formula.height_spectrum(low + (high - low) * (i + 0.5) / n_samples) !=
          0.0)
        return false;
    return true;
  };
  while (breaks.size() > 2 && is_empty(breaks[0], breaks[1]))
    breaks.erase(breaks.begin());
}

void check(std::vector<SpectrumShell>& shells) {
  for (const SpectrumShell& shell : shells) {
    require_positive("wavevector of a shell", shell.wavevector, "rad/m");
    require_not_negative("mean_square_height of a shell",
                         shell.mean_square_height, "m^2");
  }
  std::erase_if(shells, [](const SpectrumShell& shell) {
    return shell.mean_square_height == 0.0;
  });
  if (shells.empty())
    refuse_argument("number of shells with roughness", 0.0, ">= 1");
  std::sort(shells.begin(), shells.end(), [](const auto& a, const auto& b) {
    return a.wavevector < b.wavevector;
  });
}

SpectrumFormula cut(SpectrumFormula formula, double low, double high) {
  std::vector<double>& breaks = formula.breaks;
  low = std::max(low, breaks.front());
  high = std::min(high, breaks.back());
  std::erase_if(breaks, [&](double q) { return q <= low || q >= high; });
  breaks.insert(breaks.begin(), low);
  breaks.push_back(high);
  return formula;
}

std::vector<SpectrumShell> cut(std::vector<SpectrumShell> shells, double low,
                               double high) {
  std::erase_if(shells, [&](const SpectrumShell& shell) {
    return shell.wavevector <= low || shell.wavevector > high;
  });
  return shells;
}

} // namespace

HeightSpectrum::HeightSpectrum(SpectrumFormula formula) {
  check(formula);
  drop_empty_start(formula);
  prepared_ = std::make_shared<const Prepared>(formula.breaks.front(),
                                               formula.breaks.back(),
                                               integrate_formula(formula));
  source_ = std::move(formula);
}

HeightSpectrum::HeightSpectrum(std::vector<SpectrumShell> shells) {
  check(shells);
  prepared_ = std::make_shared<const Prepared>(shells.front().wavevector,
                                               shells.back().wavevector,
                                               integrate_shells(shells));
  source_ = std::move(shells);
}

bool HeightSpectrum::has_density() const {
  return std::holds_alternative<SpectrumFormula>(source_);
}

double HeightSpectrum::density(double wavevector) const {
  const auto* formula = std::get_if<SpectrumFormula>(&source_);
  if (formula == nullptr)
    refuse_argument("wavevector", wavevector,
                    "of a spectrum that is a formula: shells have no density");
  const bool inside = wavevector >= formula->breaks.front() &&
                      wavevector <= formula->breaks.back();
  return inside ? formula->height_spectrum(wavevector) : 0.0;
}

std::span<const double> HeightSpectrum::breaks() const {
  const auto* formula = std::get_if<SpectrumFormula>(&source_);
  if (formula == nullptr)
    return {};
  return formula->breaks;
}

std::span<const SpectrumShell> HeightSpectrum::shells() const {
  const auto* shells = std::get_if<std::vector<SpectrumShell>>(&source_);
  if (shells == nullptr)
    return {};
  return *shells;
}

double HeightSpectrum::wavevector_low() const {
  return prepared_->wavevector_low;
}

double HeightSpectrum::wavevector_high() const {
  return prepared_->wavevector_high;
}

double HeightSpectrum::rms_height() const {
  return std::sqrt(prepared_->moments.height);
}

double HeightSpectrum::rms_slope() const {
  return prepared_->rms_slope();
}

const ProfileMoments& HeightSpectrum::profile_moments() const {
  return prepared_->moments;
}

double HeightSpectrum::full_contact_moment() const {
  return prepared_->full_contact_moment;
}

std::span<const RoughnessNode> HeightSpectrum::nodes() const {
  return prepared_->nodes;
}

HeightSpectrum HeightSpectrum::between(double low, double high) const {
  if (!(low < high))
    refuse_argument("low", low, "below high [rad/m]");
  return std::visit(
      [&](const auto& source) {
        return HeightSpectrum(cut(source, low, high));
      },
      source_);
}

} // namespace asperity::theory
