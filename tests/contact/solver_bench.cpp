// Cost of one load step from a cold start, and of a warm load program:
// iterations and transforms are counts, so they compare across machines.
// Arguments: points a side, nominal pressure in 1e-3 E* h'.
#include "contact/load_sequence.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>

#include "tests/contact/scenes.hpp"

namespace asperity::contact {
namespace {

void cold_step(benchmark::State& state) {
  const int points = static_cast<int>(state.range(0));
  const double pressure = 1e-3 * static_cast<double>(state.range(1));
  const Grid grid{points, points, 1.0, 1.0};
  const std::vector<double> heights = scenes::rough_heights(grid, {});
  const double tolerance = 1e-8 * scenes::rms(heights);
  FourierOperator elasticity = halfspace_operator(
      grid, {1.0, 0.0, std::numeric_limits<double>::infinity(), {}});
  ContactSolution solution;
  for (auto _ : state)
    solution = solve_contact(elasticity, {heights, 0.0, tolerance, 2000},
                             {LoadTarget::Kind::nominal_pressure, pressure});
  state.counters["iterations"] = solution.iterations;
  state.counters["transforms"] = solution.transforms;
  double in_contact = 0.0;
  for (const double p : solution.pressure)
    in_contact += p > 0.0 ? 1.0 : 0.0;
  state.counters["area"] = in_contact / static_cast<double>(grid.size());
}

BENCHMARK(cold_step)
    ->ArgsProduct({{256, 512}, {3, 30, 100, 300, 600, 1300}})
    ->Args({1024, 30})
    ->Args({1024, 300})
    ->Args({1024, 1000})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

void load_program(benchmark::State& state) {
  const int points = static_cast<int>(state.range(0));
  const Grid grid{points, points, 1.0, 1.0};
  const std::vector<double> heights = scenes::rough_heights(grid, {});
  const FourierOperator elasticity = halfspace_operator(
      grid, {1.0, 0.0, std::numeric_limits<double>::infinity(), {}});
  constexpr int n_steps = 16;
  int iterations = 0;
  int most = 0;
  for (auto _ : state) {
    LoadSequence program(elasticity.clone(), heights, {},
                         1e-8 * scenes::rms(heights), 2000);
    for (int step = 0; step < n_steps; ++step) {
      const double pressure = 3e-3 * std::pow(400.0, step / (n_steps - 1.0));
      const int count =
          program.solve({LoadTarget::Kind::nominal_pressure, pressure})
              .iterations;
      iterations += count;
      most = std::max(most, count);
    }
  }
  state.counters["iterations_a_step"] = iterations / double{n_steps};
  state.counters["most_iterations"] = most;
}

BENCHMARK(load_program)
    ->Arg(256)
    ->Arg(512)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

} // namespace
} // namespace asperity::contact
