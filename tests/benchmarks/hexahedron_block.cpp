// The cost of a block of second-order hexahedra of any shape by multigrid
// without its matrix (fem/linear/hexahedron_block.hpp) and by algebraic
// multigrid for the matrix of first-order cells on the same nodes, in pairs of
// runs: set-up and one solve in CPU seconds, iterations, memory. The patch of
// nodes in contact with a sphere is displaced by one length; residual to 1e-8
// of the load.
//
//     bench_hexahedron_block [points] [indentation|hanging|grid of boxes]
//     [pairs]
//                            [both|own]
//
// Nodes per side (32); gmsh's mesh that is fine under the sphere, cubes that
// double away from the surface, or equal boxes in graded layers; pairs of runs
// (1); which solvers (both). The set-up time includes the assembly of matrices.
#include "fem/linear/hexahedron_block.hpp"

#include "base/cpu_clock.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/gmsh_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "meshes/layered_mesh.hpp"
#include "meshes/layers/graded_layers.hpp"
#include "tests/benchmarks/matrix_free_block.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace asperity::fem {
namespace {

constexpr double side = 1e-3; // m

BlockProblem problem_of(int points, const std::string& kind) {
  const Grid grid{points, points, side, side};
  const Grid cells{points / 2, points / 2, side, side};
  BlockProblem problem{
      grid, {}, 2, ModuliField(moduli(mechanics::BodyModuli{2e9, 0.3}))};
  if (kind == "indentation") {
    meshes::GmshBlock block;
    block.geometry = mechanics::MeshGeometry::indentation;
    block.length_x = block.length_y = block.depth = side;
    block.size_at_contact = 2.0 * grid.spacing_x();
    block.size_far = 0.125 * side;
    block.fine_radius = 0.15 * side;
    problem.mesh = meshes::gmsh_block(block);
  } else if (kind == "hanging") {
    problem.mesh = meshes::hanging_mesh(cells, side, 4);
  } else {
    problem.mesh = meshes::layered_mesh(
        cells, meshes::graded_layers(cells.spacing_x(), 1.5, side));
  }
  return problem;
}

bool is_touched(const dealii::Point<2>& place) {
  return std::hypot(place[0] - 0.5 * side, place[1] - 0.5 * side) < 0.1 * side;
}

Cost own_cost(const BlockProblem& problem, const BlockSystem& system,
              const Patch& patch, Patch::Vector& displacement) {
  const CpuClock setting_up;
  HexahedronBlock block(problem, system);
  const Cost cost = cost_of(block, setting_up, patch, displacement);
  constexpr int products = 20;
  Patch::Vector image(displacement);
  const CpuClock multiplying;
  for (int i = 0; i < products; ++i)
    block.vmult(image, displacement);
  std::printf(
      "           a product %.1f ns an unknown, %.0f bytes an unknown\n",
      1e9 * multiplying.seconds() / products /
          static_cast<double>(system.n_unknowns()),
      1e6 * cost.memory / static_cast<double>(system.n_unknowns()));
  return cost;
}

void run(int points, const std::string& kind, int pairs, bool with_both) {
  const BlockProblem problem = problem_of(points, kind);
  const CpuClock building;
  const BlockSystem system(problem);
  std::printf("%s%.2f s CPU for mesh and unknowns\n", system.report().c_str(),
              building.seconds());
  const Patch patch(system, HexahedronBlock(problem, system), is_touched);
  compare_in_pairs(problem, system, patch, pairs, with_both,
                   [&](auto& displacement) {
                     return own_cost(problem, system, patch, displacement);
                   });
}

} // namespace
} // namespace asperity::fem

int main(int n_arguments, char** arguments) {
  asperity::fem::start_mpi();
  asperity::fem::run(n_arguments > 1 ? std::atoi(arguments[1]) : 32,
                     n_arguments > 2 ? arguments[2] : "indentation",
                     n_arguments > 3 ? std::atoi(arguments[3]) : 1,
                     n_arguments < 5 || std::strcmp(arguments[4], "own") != 0);
}
