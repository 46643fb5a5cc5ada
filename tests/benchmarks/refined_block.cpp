// The cost of a block whose mesh is halved from a grid of boxes by geometric
// multigrid (fem/refined/refined_block.hpp) and by algebraic multigrid, in
// pairs of runs: set-up and one solve in CPU seconds, iterations, memory. The
// patch of nodes in contact with a sphere is displaced by one length; residual
// to 1e-8 of the load.
//
//     bench_refined_block [points] [hanging|disc] [degree] [pairs]
//                         [both|own|first]
//
// Nodes per side (64); cubes that double away from the surface, or cells halved
// round the boundary of the patch from eight per side; order of the shape
// functions (1); pairs of runs (1); which solvers (both). `first`: of second
// order, also the solver whose first-order functions are left to Trilinos ML.
#include "fem/refined/refined_block.hpp"

#include "base/cpu_clock.hpp"
#include "fem/block/block_triangulation.hpp"
#include "fem/linear/hexahedron_block.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/hanging_mesh.hpp"
#include "tests/benchmarks/matrix_free_block.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

namespace asperity::fem {
namespace {

constexpr double side = 1e-3; // m
constexpr double radius = 0.1 * side;

double distance_of(double x, double y) {
  return std::hypot(x - 0.5 * side, y - 0.5 * side);
}

using Mesh = std::shared_ptr<dealii::parallel::TriangulationBase<3>>;

/// Halves the cells at the contact surface whose neighbourhood the boundary of
/// the patch crosses.
Mesh round_disc(const BlockProblem& problem, int halvings) {
  Mesh mesh = make_triangulation(problem.mesh, false);
  for (int pass = 0; pass < halvings; ++pass) {
    for (const auto& cell : mesh->active_cell_iterators()) {
      if (!cell->is_locally_owned())
        continue;
      const dealii::Point<3> centre = cell->center();
      const double edge = cell->extent_in_direction(0);
      if (centre[2] < edge &&
          std::abs(distance_of(centre[0], centre[1]) - radius) < 1.5 * edge)
        cell->set_refine_flag();
    }
    mesh->execute_coarsening_and_refinement();
  }
  return mesh;
}

/// @param correction  of second-order functions, null for the usual one
Cost own_cost(const BlockProblem& problem, const BlockSystem& system,
              bool is_algebraic, const Patch& patch,
              Patch::Vector& displacement) {
  const CpuClock setting_up;
  std::unique_ptr<BlockInverse> block;
  if (is_algebraic)
    block = std::make_unique<HexahedronBlock>(problem, system);
  else
    block = refined_block_of(problem, system);
  const Cost cost = cost_of(*block, setting_up, patch, displacement);
  constexpr int products = 20;
  Patch::Vector image(displacement);
  const CpuClock multiplying;
  for (int i = 0; i < products; ++i)
    block->vmult(image, displacement);
  std::printf(
      "           a product %.1f ns an unknown, %.0f bytes an unknown\n",
      1e9 * multiplying.seconds() / products /
          static_cast<double>(system.n_unknowns()),
      1e6 * cost.memory / static_cast<double>(system.n_unknowns()));
  return cost;
}

void run(int points, const std::string& kind, int degree, int pairs,
         const std::string& solvers) {
  const Grid grid{points, points, side, side};
  BlockProblem problem{
      grid, {}, degree, ModuliField(moduli(mechanics::BodyModuli{2e9, 0.3}))};
  problem.linear_solver = LinearSolver::multigrid;
  const bool is_disc = kind == "disc";
  const int cells = points / degree;
  problem.mesh =
      is_disc ? meshes::equal_boxes({8, 8, side, side}, side)
              : meshes::hanging_mesh({cells, cells, side, side}, side, 4);
  const CpuClock building;
  Mesh mesh;
  if (is_disc)
    mesh = round_disc(problem,
                      static_cast<int>(std::lround(std::log2(cells / 8.0))));
  const BlockSystem system(problem, mesh);
  std::printf("%s%.2f s CPU for mesh and unknowns\n", system.report().c_str(),
              building.seconds());
  const Patch patch(system, *refined_block_of(problem, system),
                    [](const dealii::Point<2>& place) {
                      return distance_of(place[0], place[1]) < radius;
                    });
  if (solvers == "first") {
    Patch::Vector found(patch.load);
    own_cost(problem, system, true, patch, found);
  }
  compare_in_pairs(
      problem, system, patch, pairs, solvers != "own", [&](auto& displacement) {
        return own_cost(problem, system, false, patch, displacement);
      });
}

} // namespace
} // namespace asperity::fem

int main(int n_arguments, char** arguments) {
  asperity::fem::start_mpi();
  const auto argument = [&](int i, const char* standard) {
    return n_arguments > i ? arguments[i] : standard;
  };
  asperity::fem::run(std::atoi(argument(1, "64")), argument(2, "hanging"),
                     std::atoi(argument(3, "1")), std::atoi(argument(4, "1")),
                     argument(5, "both"));
}
