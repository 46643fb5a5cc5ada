// The cost of a load step with the Green's function block: the paper's
// roughness, complete or cut off at four times the roll-off, load by load. The
// harness measures CPU time; counters give evaluations of the forces,
// linearisations (a sum over all pairs each) and products with the second
// derivatives per load step.
#include "md/engines.hpp"
#include "md/lattice/surface_stiffness.hpp"
#include "surfaces/build.hpp"

#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

namespace asperity::md {
namespace {

constexpr double spacing = 2.6e-10;
constexpr double youngs_modulus = 77.2e9;
constexpr double poisson_ratio = 0.42;
constexpr double modulus =
    youngs_modulus / (1.0 - poisson_ratio * poisson_ratio);

/// The paper's block (Sec. 4); a smaller one has its roughness reduced in
/// proportion.
AtomRequest request_of(int points, mechanics::AtomModes modes, bool is_cut) {
  const double length = points * spacing;
  const double longest = 2.0 * std::numbers::pi / length;
  mechanics::SurfaceSpec surface;
  surface.length = length;
  surface.points = mechanics::incommensurate_atoms(points);
  surface.seed = 1;
  surface.rms_height = 1e-9 * points / 400.0;
  surface.hurst = 0.8;
  surface.wavevector_low = 0.999 * longest;
  surface.wavevector_roll_off = 3.0 * longest;
  surface.wavevector_high = is_cut
                                ? 12.001 * longest
                                : 0.996 * std::numbers::pi * std::numbers::phi /
                                      spacing; // the last one of the substrate
  surface.rescale = true;
  const surfaces::HeightMap map = surfaces::build_surface(surface, 0);

  AtomRequest request;
  request.settings.modes = modes;
  request.settings.interaction_energy = 74.4e-3 * 1.602176634e-19;
  request.settings.interaction_distance = 3.28e-10;
  request.settings.cutoff = 10e-10;
  request.settings.contact_distance = 4.3615e-10;
  request.scales = {modulus, length, spacing, *surface.rms_height};
  request.youngs_modulus = youngs_modulus;
  request.poisson_ratio = poisson_ratio;
  request.layer = {points, points, length, length};
  request.substrate = map.grid;
  request.heights = map.heights;
  return request;
}

constexpr double loads[] = {1e-4, 1e-3, 1e-2, 0.03, 0.1, 0.26}; // p/E*

/// Arguments: atoms per side, modes, roughness cut off or complete, number of
/// the loads; the last one is timed.
void bring_to_load(benchmark::State& state) {
  const AtomRequest request =
      request_of(static_cast<int>(state.range(0)),
                 state.range(1) != 0 ? mechanics::AtomModes::normal
                                     : mechanics::AtomModes::vector,
                 state.range(2) != 0);
  const auto last = static_cast<int>(state.range(3));
  AtomStep answer;
  for (auto _ : state) {
    state.PauseTiming();
    const auto contact = make_atomic_contact(request);
    for (int step = 0; step < last; ++step)
      contact->solve(
          {mechanics::Control::nominal_pressure, loads[step] * modulus}, step);
    state.ResumeTiming();
    answer = contact->solve(
        {mechanics::Control::nominal_pressure, loads[last] * modulus}, last);
  }
  if (!answer.converged)
    state.SkipWithError(answer.note.c_str());
  state.counters["pressure_ratio"] = loads[last];
  state.counters["evaluations"] = answer.evaluations;
  state.counters["linearisations"] = answer.linearisations;
  state.counters["products"] = answer.products;
  state.counters["seconds_an_evaluation"] = benchmark::Counter(
      answer.evaluations, benchmark::Counter::kIsIterationInvariantRate |
                              benchmark::Counter::kInvert);
}

BENCHMARK(bring_to_load)
    ->ArgNames({"atoms", "normal", "cut", "load"})
    ->ArgsProduct({{100, 400}, {0, 1}, {0, 1}, {0, 1, 2, 3, 4, 5}})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

void set_up(benchmark::State& state) {
  const auto points = static_cast<int>(state.range(0));
  const Grid layer{points, points, points * spacing, points * spacing};
  for (auto _ : state)
    benchmark::DoNotOptimize(
        SurfaceStiffness({mechanics::AtomLattice::isotropic, spacing,
                          youngs_modulus, poisson_ratio},
                         layer, points, mechanics::AtomModes::vector));
}

BENCHMARK(set_up)->Arg(100)->Arg(400)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace asperity::md
