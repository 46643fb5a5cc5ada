#include "reports/analysis/surface_theory.hpp"

#include "base/parallel_rows.hpp"
#include "surfaces/build.hpp"
#include "surfaces/maps/shells.hpp"
#include "theory/persson/persson.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

namespace asperity::reports {
namespace {

using results::SurfaceRecord;

// These are the finest possible shells: the wavevector magnitudes on a square
// grid are proportional to roots of integers and are hardly ever this close to
// each other.
constexpr double shell_width = 1e-6; // in ln q

/// Whether the spectrum of the heights is found in memory, with those of the
/// other realisations.
bool is_in_memory(const SurfaceRecord& surface) {
  return surface.has_heights() && !surface.height_map().is_stored();
}

SurfaceTheory prepared(const theory::HeightSpectrum& spectrum,
                       double contact_modulus) {
  const auto contact =
      std::make_shared<theory::PerssonContact>(spectrum, contact_modulus, 1.0);
  SurfaceTheory prepared;
  prepared.decay_length = contact->gap_decay_length();
  prepared.gap = [contact](double nominal_pressure) {
    const theory::GammaParts parts = contact->mean_gap_parts(nominal_pressure);
    return LossSplit{parts.linear, parts.cubic};
  };
  prepared.energy = [contact](double nominal_pressure) {
    const theory::GammaParts parts =
        contact->elastic_energy_parts(nominal_pressure);
    return LossSplit{parts.linear, parts.cubic};
  };
  return prepared;
}

SurfaceTheory theory_of(const std::vector<surfaces::Shell>& found,
                        double contact_modulus) {
  std::vector<theory::SpectrumShell> shells;
  shells.reserve(found.size());
  for (const surfaces::Shell& shell : found)
    shells.push_back({shell.wavevector, shell.mean_square_height});
  return prepared(theory::HeightSpectrum(std::move(shells)), contact_modulus);
}

SurfaceTheory theory_on(const surfaces::ModeShells& shells,
                        const SurfaceRecord& surface, double contact_modulus) {
  return theory_of(shells.of({surface.grid, surface.heights}), contact_modulus);
}

} // namespace

void SurfaceTheories::compute_realizations() {
  is_computed_ = true;
  const auto first = std::ranges::find_if(result_.surfaces, is_in_memory);
  if (first == result_.surfaces.end())
    return;
  const surfaces::ModeShells shells(first->grid, shell_width);
  std::vector<const SurfaceRecord*> alike;
  for (const SurfaceRecord& surface : result_.surfaces)
    if (is_in_memory(surface) && surface.grid == first->grid)
      alike.push_back(&surface);
  std::vector<SurfaceTheory> computed(alike.size());
  parallel_rows(static_cast<int>(alike.size()), report_threads(), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    try {
      computed[at] = theory_on(shells, *alike[at], result_.contact_modulus);
    } catch (const std::domain_error&) {
      // of() computes it again and passes the error to who asks.
    }
  });
  for (std::size_t i = 0; i < alike.size(); ++i)
    if (computed[i].gap)
      known_[alike[i]] = std::move(computed[i]);
}

const SurfaceTheory& SurfaceTheories::of(const SurfaceRecord& surface) {
  if (!is_computed_)
    compute_realizations();
  const auto known = known_.find(&surface);
  if (known != known_.end())
    return known->second;
  if (!surface.has_heights())
    return known_[&surface] = {};
  if (surface.height_map().is_stored())
    return known_[&surface] = theory_of(
               surfaces::spectral_shells(surface.grid, height_rows(surface),
                                         report_threads(), shell_width),
               result_.contact_modulus);
  return known_[&surface] =
             theory_on(surfaces::ModeShells(surface.grid, shell_width), surface,
                       result_.contact_modulus);
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
