// Tests of surfaces/analysis/self_affine_fit.hpp.
#include "surfaces/analysis/self_affine_fit.hpp"
#include "surfaces/analysis/surface_analysis.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/realization.hpp"
#include "tests/surfaces/instrument_maps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace asperity::surfaces::self_affine_fit_test {

constexpr double unit = 2.0 * std::numbers::pi; // of a side of 1 m

bool contains(const FittedParameter& parameter, double exact) {
  return parameter.low <= exact * (1.0 + 1e-9) && exact <= parameter.high;
}

/// Rings at the wavevectors of a map of side 1 m, with exact densities.
std::vector<SpectrumRing> exact_rings(const SelfAffineSpectrum& spectrum,
                                      double end, double noise) {
  std::vector<SpectrumRing> rings;
  for (double q = 1.0; q < end; q = std::max(q + 0.5, q * 1.025))
    rings.push_back(
        {q * unit, spectrum(q * unit) + noise, 6.0 * q * q * 0.025 + 1.0, 0.0});
  return rings;
}

SelfAffineSpectrum spectrum_of(double hurst, double roll_off, double cutoff) {
  return SelfAffineSpectrum::with_rms_height(
      {hurst, 0.5 * unit, roll_off * unit, cutoff * unit}, 1e-6);
}

// With densities without scatter every parameter is found, to the spacing of
// the rings for the cut-off and to the convergence of the likelihood (1e-6 of
// the value) for the others.
TEST(SelfAffineFit, FindsTheParametersOfExactDensities) {
  const SelfAffineSpectrum exact = spectrum_of(0.6, 8, 90);
  std::vector<SpectrumRing> rings = exact_rings(exact, 128, 1e-9 * exact(unit));

  const auto found = fit_self_affine(rings, rings.back().wavevector);

  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->hurst.value, 0.6, 2e-3);
  EXPECT_NEAR(found->roll_off.value / (8 * unit), 1.0, 2e-2);
  EXPECT_NEAR(found->cutoff.value / (90 * unit), 1.0, 0.03);
  EXPECT_TRUE(contains(found->cutoff, 90 * unit));
  EXPECT_NEAR(found->density(4 * unit) / exact(4 * unit), 1.0, 1e-2);
  EXPECT_NEAR(found->density(40 * unit) / exact(40 * unit), 1.0, 1e-2);
}

TEST(SelfAffineFit, SeparatesNoiseFromRoughness) {
  const SelfAffineSpectrum exact = spectrum_of(0.8, 4, 1000);
  const double noise = exact(40 * unit);
  const std::vector<SpectrumRing> rings = exact_rings(exact, 128, noise);

  const auto found = fit_self_affine(rings, rings.back().wavevector);

  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->hurst.value, 0.8, 5e-3);
  EXPECT_NEAR(found->noise / noise, 1.0, 2e-2);
  EXPECT_TRUE(std::isnan(found->cutoff.value));
  EXPECT_EQ(found->cutoff.reason, "no cut-off within the reliable range");
}

TEST(SelfAffineFit, ReportsThatThereIsNoRollOff) {
  const SelfAffineSpectrum exact = spectrum_of(0.7, 0.5, 1000);
  const std::vector<SpectrumRing> rings = exact_rings(exact, 64, 0.0);

  const auto found = fit_self_affine(rings, rings.back().wavevector);

  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(std::isnan(found->roll_off.value));
  EXPECT_EQ(found->roll_off.high, unit);
  EXPECT_NEAR(found->hurst.value, 0.7, 1e-3);
}

// Between a roll-off and a cut-off a factor of 1.4 apart, with scatter, any H
// fits; the model is still a description of the rings.
TEST(SelfAffineFit, StatesNoHurstExponentOfAShortPart) {
  const SelfAffineSpectrum exact = spectrum_of(0.8, 8, 11);
  const HeightMap map = realize(exact.isotropic(), {64, 64, 1.0, 1.0}, {1, 0},
                                mechanics::Amplitudes::gaussian);
  const SpectrumEstimate spectrum = estimate_spectrum(map, true);

  const auto found = fit_self_affine(spectrum.rings, spectrum.wavevector_high);

  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(std::isnan(found->hurst.value));
  EXPECT_EQ(found->hurst.reason,
            "the self-affine part of the spectrum is too short");
  EXPECT_NEAR(found->density(4 * unit) / exact(4 * unit), 1.0, 0.3);
}

TEST(SelfAffineFit, NeedsEnoughRings) {
  const SelfAffineSpectrum exact = spectrum_of(0.7, 2, 1000);

  EXPECT_FALSE(fit_self_affine(exact_rings(exact, 2.9, 0.0), 3 * unit));
  EXPECT_FALSE(fit_self_affine({}, unit));
}

// A blur of 0.4 spacings leaves an amplitude of 0.45 at the Nyquist wavevector.
// It is told from the roughness, and no cut-off is found.
TEST(SelfAffineFit, SeparatesBlurFromRoughness) {
  const SelfAffineSpectrum exact = spectrum_of(0.8, 4, 1000);
  std::vector<SpectrumRing> rings = exact_rings(exact, 128, 0.0);
  const double blur = 0.4 / 256;
  for (SpectrumRing& ring : rings)
    ring.density *= std::exp(-std::pow(ring.wavevector * blur, 2));

  const auto found = fit_self_affine(rings, rings.back().wavevector);

  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->hurst.value, 0.8, 5e-3);
  EXPECT_NEAR(found->blur.value / blur, 1.0, 1e-2);
  EXPECT_TRUE(contains(found->blur, blur));
  EXPECT_TRUE(std::isnan(found->cutoff.value));
  const double middle = 40 * unit;
  EXPECT_NEAR(found->density(middle) /
                  (exact(middle) * std::exp(-std::pow(middle * blur, 2))),
              1.0, 1e-2);
}

// A surface of two exponents, both steps of which are within the factor of 1.5
// that a cut-off would need, is none of the model: the scatter of many modes
// shows it, and no interval is stated.
TEST(SelfAffineFit, StatesNoIntervalOfAnotherSpectrum) {
  std::vector<SpectrumRing> rings =
      exact_rings(spectrum_of(0.6, 0.5, 1000), 128, 0.0);
  for (SpectrumRing& ring : rings) {
    ring.density *= 1.0 + 0.3 * std::sin(4.0 * std::log(ring.wavevector));
    ring.degrees_of_freedom *= 100.0;
  }

  const auto found = fit_self_affine(rings, rings.back().wavevector);

  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(found->is_model);
  EXPECT_GT(found->dispersion, 3.0);
  for (const FittedParameter& parameter :
       {found->hurst, found->cutoff, found->blur, found->rms_height}) {
    EXPECT_TRUE(std::isnan(parameter.low) && std::isnan(parameter.high));
    EXPECT_NE(parameter.reason, "");
  }

  for (SpectrumRing& ring : rings)
    ring.density *= std::pow(ring.wavevector, -1.0); // H = 1.1
  EXPECT_EQ(fit_self_affine(rings, rings.back().wavevector)->hurst.reason,
            "above 1: the spectrum is not that of a self-affine surface; no "
            "interval: the rings scatter more than the model allows");
}

TEST(SelfAffineFit, SaysThatAnExponentIsAboveThatOfSelfAffineSurfaces) {
  std::vector<SpectrumRing> rings =
      exact_rings(spectrum_of(0.9, 0.5, 1000), 256, 0.0);
  for (SpectrumRing& ring : rings)
    ring.density *= std::pow(ring.wavevector, -0.6); // H = 1.2

  const auto found = fit_self_affine(rings, rings.back().wavevector);

  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->hurst.value, 1.2, 1e-2);
  EXPECT_EQ(found->hurst.reason,
            "above 1: the spectrum is not that of a self-affine surface");
}

// Maps with blur and noise, with and without roll-off and periodicity
// (tests/benchmarks/hurst_coverage.cpp counts 200 of them): of 40 intervals of
// 95 % at most 4 miss the exact value, and most maps have one.
TEST(SelfAffineFit, HasIntervalsThatContainTheExactValueOfInstrumentMaps) {
  int stated = 0;
  int contained = 0;
  for (int number = 0; number < 40; ++number) {
    const InstrumentMap exact = instrument_map(number, 128);
    const MapAnalysis found =
        analyse_map(measured(exact), exact.is_periodic, {});
    ASSERT_TRUE(found.fit.has_value());
    if (std::isnan(found.fit->hurst.low))
      continue;
    ++stated;
    contained += contains(found.fit->hurst, exact.hurst);
  }
  EXPECT_GE(stated, 36);
  EXPECT_GE(contained, stated - 4);
}

// The 95 % intervals contain the exact value in about 95 of 100 Gaussian
// surfaces of 128 x 128 nodes. A binomial count with p = 0.95 is below 88 with
// a probability of 0.2 %. The cut-off is always found to a ring or better.
TEST(SelfAffineFit, HasIntervalsThatContainTheExactValue) {
  const SelfAffineSpectrum exact = spectrum_of(0.8, 4, 50);
  int hurst = 0;
  int roll_off = 0;
  int cutoff = 0;
  int rms_height = 0;
  for (int r = 0; r < 100; ++r) {
    const HeightMap map = realize(exact.isotropic(), {128, 128, 1.0, 1.0},
                                  {21, r}, mechanics::Amplitudes::gaussian);
    const SpectrumEstimate spectrum = estimate_spectrum(map, true);
    const auto found =
        fit_self_affine(spectrum.rings, spectrum.wavevector_high);
    ASSERT_TRUE(found.has_value());
    hurst += contains(found->hurst, 0.8);
    roll_off += contains(found->roll_off, 4 * unit);
    cutoff += contains(found->cutoff, 50 * unit);
    // The band of the map begins at its longest wave, not at q_L.
    const SelfAffineShape band{0.8, unit, 4 * unit, 50 * unit};
    const double whole =
        SelfAffineSpectrum::with_rms_height(band, 1.0).plateau();
    rms_height +=
        contains(found->rms_height, std::sqrt(exact.plateau() / whole));
  }
  for (const int count : {hurst, roll_off, rms_height}) {
    EXPECT_GE(count, 88);
    EXPECT_LE(count, 100);
  }
  EXPECT_GE(cutoff, 95);
}

// The intervals are not merely wide: with blur and noise that are found, so
// that no limit at 0 narrows the distribution of H, they are 3.92 standard
// deviations of H, which 30 values determine to 13 %. Intervals of a surface of
// the model are withheld once in a thousand, here of one map.
TEST(SelfAffineFit, HasIntervalsAsWideAsTheScatter) {
  double maps = 0.0; // with an interval
  double width = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (int r = 0; r < 30; ++r) {
    const SpectrumEstimate spectrum = estimate_spectrum(
        measured({.hurst = 0.7,
                  .blur = 0.6,
                  .noise = 0.4e-9,
                  .is_periodic = true,
                  .seed = static_cast<std::uint64_t>(3000 + r)}),
        true);
    const auto found =
        fit_self_affine(spectrum.rings, spectrum.wavevector_high);
    ASSERT_TRUE(found.has_value());
    if (!std::isfinite(found->hurst.high))
      continue;
    maps += 1.0;
    width += found->hurst.high - found->hurst.low;
    sum += found->hurst.value;
    squares += found->hurst.value * found->hurst.value;
  }
  ASSERT_GE(maps, 29.0);
  const double mean = sum / maps;
  const double scatter = std::sqrt(squares / maps - mean * mean);
  EXPECT_NEAR(width / maps / (3.92 * scatter), 1.0, 0.25);
}

} // namespace asperity::surfaces::self_affine_fit_test
