// The cost of the explicit block: energy and forces per free atom, the exact
// solve per free atom, and its set-up. Arguments: atoms per side, levels of six
// layers.
#include "md/lattice/block_solver.hpp"
#include "tests/md/rough_contact.hpp"

#include <benchmark/benchmark.h>

#include <optional>

namespace asperity::md {
namespace {

MultiscaleBlock block_of(const benchmark::State& run) {
  const auto atoms = static_cast<int>(run.range(0));
  const auto levels = static_cast<int>(run.range(1));
  return {
      problems::paper_crystal(),
      {problems::lattice(atoms, atoms * problems::layer_spacing), levels, 6}};
}

/// CPU seconds of one thread, per atom and call.
void count_an_atom(benchmark::State& run, const MultiscaleBlock& block) {
  run.counters["an_atom"] =
      benchmark::Counter(static_cast<double>(block.size()) / 3.0,
                         benchmark::Counter::kIsIterationInvariantRate |
                             benchmark::Counter::kInvert);
}

void energy_and_forces(benchmark::State& run) {
  const MultiscaleBlock block = block_of(run);
  const std::vector<double> state =
      problems::random_numbers(block.size(), -1e-11, 1e-11, 1);
  std::vector<double> forces(block.size());
  for (auto _ : run)
    benchmark::DoNotOptimize(block.energy_and_forces(state, forces));
  count_an_atom(run, block);
}

void solve(benchmark::State& run) {
  const MultiscaleBlock block = block_of(run);
  const BlockSolver solver(block, {1.2, false});
  const std::vector<double> forces =
      problems::random_numbers(block.size(), -1e-9, 1e-9, 1);
  std::vector<double> answer(block.size());
  for (auto _ : run)
    solver.solve(forces, answer);
  count_an_atom(run, block);
}

void set_up(benchmark::State& run) {
  const MultiscaleBlock block = block_of(run);
  std::optional<BlockSolver> solver;
  for (auto _ : run)
    solver.emplace(block, BlockSupport{1.2, false});
  count_an_atom(run, block);
}

BENCHMARK(energy_and_forces)
    ->Args({96, 1})
    ->Args({96, 4})
    ->Args({400, 4})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(solve)->Args({96, 1})->Args({96, 4})->Args({400, 4})->Unit(
    benchmark::kMillisecond);
BENCHMARK(set_up)->Args({96, 1})->Args({96, 4})->Args({400, 4})->Unit(
    benchmark::kMillisecond);

} // namespace
} // namespace asperity::md
