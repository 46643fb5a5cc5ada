#include "reports/analysis/surface_theory.hpp"

#include "base/parallel_rows.hpp"
#include "surfaces/build.hpp"
#include "surfaces/maps/shells.hpp"
#include "theory/persson/persson.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <span>
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
  return surface.has_heights() && !surface.height_map().is_stored() &&
         !has_spectrum_of_images(surface);
}

/// The rows of a map with its mirror images to the right and below.
class MirroredRows {
public:
  explicit MirroredRows(const SurfaceRecord& surface)
      : surface_(&surface),
        width_(static_cast<std::size_t>(surface.grid.points_x)),
        height_(static_cast<std::size_t>(surface.grid.points_y)) {}

  void operator()(
      const std::function<void(std::span<const double> rows)>& take) const {
    const std::size_t most =
        2 * std::max(std::size_t{1}, results::values_at_a_time / (2 * width_));
    for (std::size_t row = 0; row < 2 * height_; row += most)
      take(rows(row, std::min(2 * height_, row + most)));
  }

private:
  std::size_t image(std::size_t row) const {
    return std::min(row, 2 * height_ - 1 - row);
  }

  std::vector<double> rows(std::size_t begin, std::size_t end) const {
    const std::size_t first = std::min(image(begin), image(end - 1));
    const std::size_t last = begin < height_ && end > height_
                                 ? height_ - 1
                                 : std::max(image(begin), image(end - 1));
    std::vector<double> read, twice;
    const std::span<const double> held = surface_->height_map().values(
        first * width_, (last - first + 1) * width_, read);
    twice.reserve(2 * (end - begin) * width_);
    for (std::size_t row = begin; row < end; ++row) {
      const auto own = held.subspan((image(row) - first) * width_, width_);
      twice.insert(twice.end(), own.begin(), own.end());
      twice.insert(twice.end(), own.rbegin(), own.rend());
    }
    return twice;
  }

  const SurfaceRecord* surface_;
  std::size_t width_, height_;
};

SurfaceTheory prepared(const theory::HeightSpectrum& spectrum,
                       double contact_modulus) {
  const auto contact =
      std::make_shared<theory::PerssonContact>(spectrum, contact_modulus, 1.0);
  SurfaceTheory prepared;
  prepared.contact = contact;
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

/// Of a record whose heights are in memory.
SurfaceTheory theory_on(const SurfaceRecord& surface, double contact_modulus) {
  return theory_of(
      surfaces::spectral_shells({surface.grid, surface.heights}, shell_width),
      contact_modulus);
}

} // namespace

bool has_spectrum_of_images(const SurfaceRecord& surface) {
  const double longest = std::max(surface.grid.length_x, surface.grid.length_y);
  return !surface.spectrum.empty() &&
         surface.spectrum.front().wavevector * longest < 1.5 * std::numbers::pi;
}

SpectrumRows spectrum_rows(const SurfaceRecord& surface) {
  const Grid& grid = surface.grid;
  if (!has_spectrum_of_images(surface))
    return {grid, height_rows(surface)};
  return {{2 * grid.points_x, 2 * grid.points_y, 2.0 * grid.length_x,
           2.0 * grid.length_y},
          MirroredRows(surface)};
}

std::vector<surfaces::SpectrumRing> spectrum_rings(const SurfaceRecord& surface,
                                                   double area) {
  const std::vector<results::SpectrumPoint>& rows = surface.spectrum;
  std::vector<surfaces::SpectrumRing> rings;
  rings.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double q = rows[i].wavevector;
    const double low = i > 0 ? rows[i - 1].wavevector : q;
    const double high = i + 1 < rows.size() ? rows[i + 1].wavevector : q;
    const double around = std::numbers::pi * q * (high - low); // 2 pi q dq
    rings.push_back({q, rows[i].spectrum,
                     around * area / std::pow(2.0 * std::numbers::pi, 2),
                     around * rows[i].spectrum});
  }
  return rings;
}

std::optional<surfaces::NoiseFloor>
noise_floor_of(const std::vector<surfaces::SpectrumRing>& rings,
               const Grid& grid, double area) {
  const double spacing = std::max(grid.spacing_x(), grid.spacing_y());
  return surfaces::noise_floor(
      surfaces::rings_between(rings, 4.0 * std::numbers::pi / std::sqrt(area),
                              std::numbers::pi / spacing));
}

void SurfaceTheories::compute_realizations() {
  is_computed_ = true;
  const auto first = std::ranges::find_if(result_.surfaces, is_in_memory);
  if (first == result_.surfaces.end())
    return;
  std::vector<const SurfaceRecord*> alike;
  for (const SurfaceRecord& surface : result_.surfaces)
    if (is_in_memory(surface) && surface.grid == first->grid)
      alike.push_back(&surface);
  std::vector<SurfaceTheory> computed(alike.size());
  parallel_rows(static_cast<int>(alike.size()), report_threads(), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    try {
      computed[at] = theory_on(*alike[at], result_.contact_modulus);
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
  if (!is_in_memory(surface)) {
    const SpectrumRows rows = spectrum_rows(surface);
    return known_[&surface] = theory_of(
               surfaces::spectral_shells(rows.grid, rows.heights,
                                         report_threads(), shell_width),
               result_.contact_modulus);
  }
  return known_[&surface] = theory_on(surface, result_.contact_modulus);
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
