#include "reports/analysis/surface_theory.hpp"

#include "surfaces/build.hpp"
#include "surfaces/maps/shells.hpp"
#include "theory/persson/persson.hpp"

#include <memory>
#include <vector>

namespace asperity::reports {
namespace {

// These are the finest possible shells: the wavevector magnitudes on a square
// grid are proportional to roots of integers and are hardly ever this close to
// each other.
constexpr double shell_width = 1e-6; // in ln q

std::vector<theory::SpectrumShell>
shells_of(const results::SurfaceRecord& surface) {
  std::vector<theory::SpectrumShell> shells;
  for (const surfaces::Shell& shell :
       surfaces::spectral_shells({surface.grid, surface.heights}, shell_width))
    shells.push_back({shell.wavevector, shell.mean_square_height});
  return shells;
}

SurfaceTheory prepared(const theory::HeightSpectrum& spectrum,
                       double contact_modulus) {
  const auto contact =
      std::make_shared<theory::PerssonContact>(spectrum, contact_modulus, 1.0);
  SurfaceTheory prepared;
  prepared.decay_length = contact->gap_decay_length();
  prepared.gap = [contact](double nominal_pressure) {
    const theory::GammaParts parts = contact->mean_gap_parts(nominal_pressure);
    return GapSplit{parts.linear, parts.cubic};
  };
  return prepared;
}

} // namespace

SurfaceTheory theory_of_surface(const results::SurfaceRecord& surface,
                                double contact_modulus) {
  if (surface.heights.empty() || surface.heights.size() != surface.grid.size())
    return {};
  return prepared(theory::HeightSpectrum(shells_of(surface)), contact_modulus);
}

const SurfaceTheory&
SurfaceTheories::of(const results::SurfaceRecord& surface) {
  const auto known = known_.find(&surface);
  if (known != known_.end())
    return known->second;
  return known_[&surface] = theory_of_surface(surface, result_.contact_modulus);
}

SurfaceTheory theory_of_formula(const mechanics::SurfaceSpec& surface,
                                double contact_modulus,
                                std::optional<double> highest) {
  if (surface.kind != mechanics::SurfaceKind::self_affine)
    return {};
  const surfaces::IsotropicSpectrum formula =
      surfaces::formula_spectrum(surface);
  const theory::HeightSpectrum spectrum(
      theory::SpectrumFormula{formula.density, formula.kinks});
  return prepared(highest ? spectrum.between(0.0, *highest) : spectrum,
                  contact_modulus);
}

} // namespace asperity::reports
