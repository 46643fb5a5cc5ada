// Set-up time of the condensed block with default layers (cubic surface cells,
// grading ratio 1.2, depth = length) on N^2 nodes.
#include "fem/waves/condensed_q1.hpp"
#include "fem/waves/condensed_q2.hpp"
#include "meshes/layers/graded_layers.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace asperity;

fem::LayeredBlock block_for(const Grid& grid, int nodes_per_cell) {
  return fem::homogeneous_block(
      meshes::graded_layers(nodes_per_cell * grid.spacing_x(), 1.2,
                            grid.length_x),
      2e9, 0.3, mechanics::FarBoundary::clamped);
}

void q1_setup(benchmark::State& state) {
  const int points = static_cast<int>(state.range(0));
  const Grid grid{points, points, 1e-5, 1e-5};
  const fem::LayeredBlock block = block_for(grid, 1);
  for (auto _ : state)
    benchmark::DoNotOptimize(fem::condensed_compliance_q1(grid, block));
}

BENCHMARK(q1_setup)->Arg(256)->Arg(512)->Arg(1024)->Unit(
    benchmark::kMillisecond);

void q2_setup(benchmark::State& state) {
  const int points = static_cast<int>(state.range(0));
  const Grid grid{points, points, 1e-5, 1e-5};
  const fem::LayeredBlock block = block_for(grid, 2);
  for (auto _ : state)
    benchmark::DoNotOptimize(fem::condensed_compliance_q2(grid, block));
}

BENCHMARK(q2_setup)->Arg(128)->Arg(256)->Arg(512)->Unit(
    benchmark::kMillisecond);

} // namespace
