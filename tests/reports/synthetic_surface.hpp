#pragma once

// The case and the surfaces of the synthetic results: a random surface of
// exactly the spectrum of the case, and its theory.

#include "base/fourier.hpp"
#include "input/types/case.hpp"
#include "results/types/result.hpp"
#include "surfaces/build.hpp"
#include "theory/persson/persson.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace asperity::reports::synthetic {

inline constexpr double contact_modulus = 2.0e9; // Pa
inline constexpr double length = 10e-6;          // m
inline constexpr double gamma = 0.38;

inline cases::Case contact_case() {
  cases::Case rough;
  rough.name = "polymer";
  rough.title = "A polymer surface & its <surrogate>";
  rough.surface.length = length;
  rough.surface.points = 128;
  rough.surface.rms_height = 34e-9;
  rough.surface.hurst = 0.95;
  const double unit = 2.0 * std::numbers::pi / length;
  rough.surface.wavevector_low = 2.0 * unit;
  rough.surface.wavevector_roll_off = 4.5 * unit;
  rough.surface.wavevector_high = 32.0 * unit;
  mechanics::TheorySettings theory;
  theory.gamma = gamma;
  rough.methods = {{"theory", theory}, {"fem", mechanics::FemSettings{}}};
  rough.expectations = {
      {"gamma_slope", 0.35, 0.45, {"fem", "theory"}},
      {"gap_deviation", -INFINITY, 0.05, {"fem"}},
      {"kappa", 2.6, 3.0, {"fem"}}, // out of reach on purpose
  };
  return rough;
}

inline results::SurfaceRecord surface(const mechanics::SurfaceSpec& spec,
                                      unsigned seed) {
  results::SurfaceRecord record;
  record.grid = {*spec.points, *spec.points, length, length};
  const RealFourier fourier(record.grid);
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> noise(record.grid.size());
  for (double& number : noise)
    number = normal(generator);
  std::vector<std::complex<double>> modes(record.grid.half_spectrum_size());
  fourier.forward(noise, modes);
  const surfaces::IsotropicSpectrum spectrum = surfaces::formula_spectrum(spec);
  const int columns = record.grid.points_x / 2 + 1;
  double squares = 0.0;
  double slopes = 0.0;
  std::vector<double> ring_sum(64, 0.0);
  std::vector<int> ring_count(64, 0);
  for (int jy = 0; jy < record.grid.points_y; ++jy)
    for (int jx = 0; jx < columns; ++jx) {
      const double q = std::hypot(
          wavevector(jx, length),
          wavevector(signed_wavenumber(jy, record.grid.points_y), length));
      auto& mode = modes[static_cast<std::size_t>(jy * columns + jx)];
      mode *= std::sqrt(spectrum.density(q)) / std::abs(mode);
      const double twice = jx == 0 ? 1.0 : 2.0;
      squares += twice * std::norm(mode);
      slopes += twice * q * q * std::norm(mode);
      const auto ring = static_cast<std::size_t>(
          std::lround(q * length / (2.0 * std::numbers::pi)));
      if (ring > 0 && ring < ring_sum.size()) {
        ring_sum[ring] += std::norm(mode);
        ++ring_count[ring];
      }
    }
  record.rms_height = 34e-9;
  record.rms_slope = record.rms_height * std::sqrt(slopes / squares);
  const double scale = record.rms_height / std::sqrt(squares);
  record.heights.resize(record.grid.size());
  for (auto& mode : modes)
    mode *= scale;
  const double ring_area = std::pow(2.0 * std::numbers::pi / length, 2.0);
  for (std::size_t ring = 1; ring < ring_sum.size(); ++ring)
    if (ring_sum[ring] > 0.0)
      record.spectrum.push_back(
          {2.0 * std::numbers::pi * static_cast<double>(ring) / length,
           ring_sum[ring] * scale * scale / ring_count[ring] / ring_area});
  fourier.backward(modes, record.heights);
  record.highest =
      *std::max_element(record.heights.begin(), record.heights.end());
  record.kurtosis = 3.0;
  return record;
}

inline theory::PerssonContact contact_of(const mechanics::SurfaceSpec& spec) {
  const surfaces::IsotropicSpectrum spectrum = surfaces::formula_spectrum(spec);
  return {theory::HeightSpectrum(
              theory::SpectrumFormula{spectrum.density, spectrum.kinks}),
          contact_modulus, gamma};
}

/// Shells of a map by another algorithm than that of the fit: the rows of the
/// full DFT, each with its own |q|, with no symmetry but F(-q) = conj F(q).
inline std::vector<theory::SpectrumShell>
shells_by_sum(const results::SurfaceRecord& surface) {
  const RealFourier fourier(surface.grid);
  std::vector<std::complex<double>> half(surface.grid.half_spectrum_size());
  fourier.forward(surface.heights, half);
  const int n = surface.grid.points_x;
  const int columns = n / 2 + 1;
  std::vector<theory::SpectrumShell> shells;
  for (int jy = 0; jy < n; ++jy)
    for (int jx = 0; jx < n; ++jx) {
      const bool is_stored = jx < columns;
      const int kx = is_stored ? jx : n - jx;
      const int ky = is_stored ? jy : (n - jy) % n;
      const double square =
          std::norm(half[static_cast<std::size_t>(ky * columns + kx)]) /
          std::pow(static_cast<double>(surface.grid.size()), 2);
      const double q = std::hypot(wavevector(signed_wavenumber(jx, n), length),
                                  wavevector(signed_wavenumber(jy, n), length));
      if (q > 0.0 && square > 1e-40)
        shells.push_back({q, square});
    }
  return shells;
}

} // namespace asperity::reports::synthetic
