// The computing time of a curve of Persson's theory.
#include "tests/theory/spectra.hpp"
#include "theory/persson/persson.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

namespace asperity::theory {
namespace {

void thousand_points(benchmark::State& state, const HeightSpectrum& spectrum) {
  const PerssonContact contact(spectrum, modulus_of_the_paper, 0.42);
  for (auto _ : state) {
    double sum = 0.0;
    for (int i = 0; i < 1000; ++i)
      sum += contact.mean_gap(modulus_of_the_paper *
                              std::pow(10.0, i * 6e-3 - 6.0));
    benchmark::DoNotOptimize(sum);
  }
}

std::vector<SpectrumShell> shells_of_a_map(int n_shells) {
  const SelfAffine shape = surface_of_the_paper();
  std::vector<SpectrumShell> shells;
  const double step = (shape.high - shape.low) / n_shells;
  for (int i = 0; i < n_shells; ++i) {
    const double q = shape.low + step * (i + 0.5);
    shells.push_back({q, 2.0 * std::numbers::pi * q * shape(q) * step});
  }
  return shells;
}

void gap_curve_of_formula(benchmark::State& state) {
  thousand_points(state, surface_of_the_paper().spectrum());
}

void gap_curve_of_shells(benchmark::State& state) {
  thousand_points(state, HeightSpectrum(shells_of_a_map(30000)));
}

void pressure_of_gap(benchmark::State& state) {
  const PerssonContact contact(surface_of_the_paper().spectrum(),
                               modulus_of_the_paper, 0.42);
  for (auto _ : state)
    benchmark::DoNotOptimize(contact.nominal_pressure(1e-9));
}

void set_up_formula(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(PerssonContact(surface_of_the_paper().spectrum(),
                                            modulus_of_the_paper, 0.42));
}

void set_up_shells(benchmark::State& state) {
  const std::vector<SpectrumShell> shells = shells_of_a_map(30000);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        PerssonContact(HeightSpectrum(shells), modulus_of_the_paper, 0.42));
}

BENCHMARK(gap_curve_of_formula)->Unit(benchmark::kMillisecond);
BENCHMARK(gap_curve_of_shells)->Unit(benchmark::kMillisecond);
BENCHMARK(pressure_of_gap)->Unit(benchmark::kMicrosecond);
BENCHMARK(set_up_formula)->Unit(benchmark::kMillisecond);
BENCHMARK(set_up_shells)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace asperity::theory
