// Cost of one sum over all pairs, a layer of 400 x 400 atoms on 648 x 648 as in
// the paper, by the cut-off [A]. A flat surface at d_c is the worst case; over
// a rough one, most atoms have no partner within the cut-off.
#include "md/interface/interface.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/realization.hpp"
#include "tests/md/small_interface.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <numbers>
#include <vector>

namespace asperity::md {
namespace {

using problems::angstrom;
using problems::Planes;

const Grid layer = problems::lattice(400, 104e-9);
const Grid substrate = problems::lattice(648, 104e-9);

void run(benchmark::State& state, const std::vector<double>& heights,
         const Planes& atoms, double attraction, double in_reach) {
  Interaction law = problems::paper_atoms(attraction);
  law.cutoff = static_cast<double>(state.range(0)) * angstrom;
  law.taper_begin = 0.9 * law.cutoff;
  const Interface interface(law, layer, substrate, heights);
  Planes forces(layer.size());
  for (auto _ : state)
    benchmark::DoNotOptimize(
        interface.energy_and_forces(atoms.view(), forces.forces()));
  state.counters["ns_per_atom"] =
      benchmark::Counter(static_cast<double>(layer.size()),
                         benchmark::Counter::kIsIterationInvariantRate |
                             benchmark::Counter::kInvert);
  state.counters["in_reach"] = in_reach;
}

void flat_wall(benchmark::State& state, double attraction) {
  Planes atoms(layer.size());
  std::fill(atoms.z.begin(), atoms.z.end(), problems::contact_distance);
  run(state, std::vector<double>(substrate.size()), atoms, attraction, 1.0);
}

BENCHMARK_CAPTURE(flat_wall, repulsion, 0.0)
    ->Arg(8)
    ->Arg(10)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(flat_wall, attraction, 1.0)
    ->Arg(10)
    ->Unit(benchmark::kMillisecond);

/// The paper's roughness, h_rms = 10 A, with the layer flat at `height` [A]
/// except where it is raised to d_c above the surface.
void rough_wall(benchmark::State& state) {
  const double unit = 2.0 * std::numbers::pi / 104e-9;
  const auto spectrum =
      surfaces::SelfAffineSpectrum::with_rms_height(
          {0.8, unit, 3.0 * unit, 216.0 * unit}, 10.0 * angstrom)
          .isotropic();
  const std::vector<double> heights =
      surfaces::realize(spectrum, substrate, {1, 0}).heights;
  const double height = static_cast<double>(state.range(1)) * angstrom;
  Planes atoms(layer.size());
  const std::vector<double> below =
      Interface(problems::paper_atoms(), layer, substrate, heights)
          .heights_below(atoms.view());
  double in_reach = 0.0;
  for (std::size_t i = 0; i < layer.size(); ++i) {
    atoms.z[i] = std::max(height, below[i] + problems::contact_distance);
    in_reach += atoms.z[i] < below[i] + 10.0 * angstrom ? 1.0 : 0.0;
  }
  run(state, heights, atoms, 0.0, in_reach / static_cast<double>(layer.size()));
}

BENCHMARK(rough_wall)
    ->Args({10, 5})
    ->Args({10, 15})
    ->Args({10, 25})
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace asperity::md
