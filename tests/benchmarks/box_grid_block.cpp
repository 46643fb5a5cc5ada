// The cost of a block on a grid of boxes by geometric multigrid without a
// matrix (fem/multigrid) and by algebraic multigrid, in pairs of runs: set-up
// and one solve in CPU seconds, iterations, memory. A rough patch of nodes is
// displaced by one length; layers grow by 1.2 from cubic cells to a depth of
// one side; residual to 1e-8 of the load.
//
//     bench_box_grid_block [degree] [points] [pairs] [both|grid of boxes]
//
// Degree (1), nodes per side (32), pairs of runs (1), which solvers (both). The
// set-up of algebraic multigrid includes the assembly of its matrices.
#include "fem/linear/box_grid_block.hpp"

#include "base/cpu_clock.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/layered_mesh.hpp"
#include "meshes/layers/graded_layers.hpp"
#include "tests/benchmarks/matrix_free_block.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numbers>

namespace asperity::fem {
namespace {

constexpr double side = 1e-3; // m

BlockProblem problem_of(int degree, int points) {
  const Grid grid{points, points, side, side};
  const Grid cells{points / degree, points / degree, side, side};
  return {.grid = grid,
          .mesh = meshes::layered_mesh(
              cells, meshes::graded_layers(cells.spacing_x(), 1.2, side)),
          .degree = degree,
          .moduli = ModuliField(moduli(mechanics::BodyModuli{2e9, 0.3}))};
}

/// About a fifth of the surface, in patches of several sizes.
bool is_touched(const dealii::Point<2>& place) {
  const double u = 2.0 * std::numbers::pi * place[0] / side;
  const double v = 2.0 * std::numbers::pi * place[1] / side;
  return std::cos(u) + std::cos(2.0 * v + 1.0) +
             0.7 * std::cos(3.0 * u + 2.0 * v) +
             0.5 * std::cos(5.0 * u - 4.0 * v + 0.5) >
         1.1;
}

Cost own_cost(const BlockProblem& problem, const BlockSystem& system,
              const Patch& patch, Patch::Vector& displacement) {
  const CpuClock setting_up;
  BoxGridBlock box_grid(system, *box_grid_of(problem));
  const Cost cost = cost_of(box_grid, setting_up, patch, displacement);
  std::printf("           %zu levels, %.0f bytes an unknown\n",
              box_grid.levels(),
              1e6 * cost.memory / static_cast<double>(system.n_unknowns()));
  return cost;
}

void run(int degree, int points, int pairs, bool with_both) {
  const BlockProblem problem = problem_of(degree, points);
  const CpuClock building;
  const BlockSystem system(problem);
  std::printf("%s%.2f s CPU for mesh and unknowns\n", system.report().c_str(),
              building.seconds());
  const Patch patch(system, BoxGridBlock(system, *box_grid_of(problem)),
                    is_touched);
  compare_in_pairs(problem, system, patch, pairs, with_both,
                   [&](auto& displacement) {
                     return own_cost(problem, system, patch, displacement);
                   });
}

} // namespace
} // namespace asperity::fem

int main(int n_arguments, char** arguments) {
  const auto argument = [&](int i, int otherwise) {
    return n_arguments > i ? std::atoi(arguments[i]) : otherwise;
  };
  asperity::fem::start_mpi();
  asperity::fem::run(argument(1, 1), argument(2, 32), argument(3, 1),
                     n_arguments < 5 ||
                         std::strcmp(arguments[4], "box_grid") != 0);
}
