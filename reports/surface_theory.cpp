#include "reports/surface_theory.hpp"

#include "base/fourier.hpp"
#include "reports/summary.hpp"
#include "theory/persson.hpp"

#include <cmath>
#include <map>
#include <memory>

namespace asperity::reports {
namespace {

// Mean square height of each length of wavevector. On a square grid the length
// is an integer's root, so the shells are exact; on another they are told
// apart to 1e-9 of the smallest wavevector squared.
std::vector<theory::SpectrumShell>
shells_of(const results::SurfaceRecord& surface) {
  const Grid& grid = surface.grid;
  const RealFourier fourier(grid);
  std::vector<std::complex<double>> modes(grid.half_spectrum_size());
  fourier.forward(surface.heights, modes);

  const double unit =
      std::pow(wavevector(1, std::max(grid.length_x, grid.length_y)), 2.0);
  const int columns = grid.points_x / 2 + 1;
  const double norm = std::pow(static_cast<double>(grid.size()), -2.0);
  std::map<long long, double> mean_squares; // key: q^2 in 1e-9 units
  for (int jy = 0; jy < grid.points_y; ++jy) {
    for (int jx = 0; jx < columns; ++jx) {
      const double qx = wavevector(jx, grid.length_x);
      const double qy =
          wavevector(signed_wavenumber(jy, grid.points_y), grid.length_y);
      if (jx == 0 && jy == 0)
        continue;
      // columns strictly inside stand for their mirror image too
      const double twice = jx == 0 || 2 * jx == grid.points_x ? 1.0 : 2.0;
      const auto& mode = modes[static_cast<std::size_t>(jy) *
                                   static_cast<std::size_t>(columns) +
                               static_cast<std::size_t>(jx)];
      mean_squares[std::llround((qx * qx + qy * qy) / unit * 1e9)] +=
          twice * norm * std::norm(mode);
    }
  }
  // What is below rounding of the transform is no roughness.
  const double floor = 1e-24 * surface.rms_height * surface.rms_height;
  std::vector<theory::SpectrumShell> shells;
  for (const auto& [square, mean_square] : mean_squares)
    if (mean_square > floor)
      shells.push_back(
          {std::sqrt(static_cast<double>(square) * 1e-9 * unit), mean_square});
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

SurfaceTheory theory_of_formula(const cases::SurfaceSpec& surface,
                                double contact_modulus) {
  if (surface.kind != cases::SurfaceKind::self_affine)
    return {};
  return prepared(theory::HeightSpectrum(theory::SpectrumFormula{
                      [surface](double wavevector) {
                        return formula_spectrum(surface, wavevector);
                      },
                      {surface.wavevector_low, surface.wavevector_roll_off,
                       surface.wavevector_high}}),
                  contact_modulus);
}

} // namespace asperity::reports
