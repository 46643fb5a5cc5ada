// What a block of second-order hexahedra of any shape costs by multigrid
// without its matrix (fem/block/hexahedron_block.hpp) and by algebraic
// multigrid for the matrix of first-order cells on the same nodes, in pairs of
// runs: set-up and one solve in CPU seconds, iterations, memory. The patch of
// nodes that a sphere touches is held and pushed in by one length; residual to
// 1e-8 of the load.
//
//     bench_hexahedron_block [points] [indentation|hanging|lattice] [pairs]
//                            [both|own]
//
// nodes a side (32); gmsh's mesh that is fine where the sphere touches, cubes
// that double away from the surface, or equal boxes in graded layers; pairs of
// runs (1); which solvers (both). Set-ups include the assembly of matrices.
#include "fem/block/hexahedron_block.hpp"

#include "base/cpu_clock.hpp"
#include "fem/block/block_solver.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/gmsh_block.hpp"
#include "meshes/graded_layers.hpp"
#include "meshes/hanging_mesh.hpp"
#include "meshes/layered_mesh.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace asperity::fem {
namespace {

using Vector = dealii::TrilinosWrappers::MPI::Vector;

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

/// The held nodes and the forces of pushing them in.
struct Patch {
  std::vector<bool> held;
  std::vector<double> springs;
  Vector load;

  Patch(const BlockSystem& system, const MatrixFreeBlock& block)
      : held(system.contact().size()),
        springs(held.size(), 0.0),
        load(system.space().make_vector()) {
    Vector pushed(load);
    for (std::size_t i = 0; i < held.size(); ++i) {
      const auto& place = system.contact()[i].place;
      held[i] =
          std::hypot(place[0] - 0.5 * side, place[1] - 0.5 * side) < 0.1 * side;
      if (held[i])
        pushed(system.contact()[i].row.front().first) = -1.0;
    }
    pushed.compress(dealii::VectorOperation::insert);
    block.vmult(load, pushed);
    for (std::size_t i = 0; i < held.size(); ++i)
      if (held[i])
        load(system.contact()[i].row.front().first) = 0.0;
    load.compress(dealii::VectorOperation::insert);
  }
};

struct Cost {
  double set_up = 0.0, solve = 0.0; ///< [s CPU]
  double memory = 0.0;              ///< [MB]

  double total() const { return set_up + solve; }
};

void print(const std::string& name, const Cost& cost, int iterations) {
  std::printf("%-10s %8.3f %8.3f %5d %8.1f\n", name.c_str(), cost.set_up,
              cost.solve, iterations, cost.memory);
  std::fflush(stdout);
}

Cost by_own(const BlockProblem& problem, const BlockSystem& system,
            const Patch& patch, Vector& displacement) {
  Cost cost;
  const CpuClock setting_up;
  HexahedronBlock block(problem, system);
  block.prepare(patch.springs, patch.held);
  cost.set_up = setting_up.seconds();
  displacement = 0.0;
  const CpuClock solving; // with the hierarchy, which the first solve sets up
  const LinearSolution solution =
      block.solve(displacement, patch.load, 1e-8 * patch.load.l2_norm(), 1000);
  cost.solve = solving.seconds();
  cost.memory = 1e-6 * static_cast<double>(block.bytes());
  print(solution.has_converged ? "own" : "failed", cost, solution.iterations);
  constexpr int products = 20;
  Vector image(displacement);
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

Cost by_algebra(const BlockProblem& problem, const Patch& patch,
                Vector& displacement) {
  const BlockSystem system(problem); // its matrix is assembled anew
  Cost cost;
  const CpuClock setting_up;
  BlockSolver solver(system, LinearSolver::multigrid);
  static_cast<void>(system.stiffness());
  solver.set_contact(patch.springs, patch.held);
  cost.set_up = setting_up.seconds();
  displacement = 0.0;
  const CpuClock solving; // with the hierarchy, which the first solve sets up
  const bool converged =
      solver.solve(displacement, patch.load, 1e-8 * patch.load.l2_norm());
  cost.solve = solving.seconds();
  cost.memory = 1e-6 * solver.memory();
  print(converged ? "algebraic" : "failed", cost, solver.iterations());
  return cost;
}

void run(int points, const std::string& kind, int pairs, bool with_both) {
  const BlockProblem problem = problem_of(points, kind);
  const CpuClock building;
  const BlockSystem system(problem);
  std::printf("%s%.2f s CPU for mesh and unknowns\n", system.report().c_str(),
              building.seconds());
  const HexahedronBlock block(problem, system);
  const Patch patch(system, block);
  std::printf("             set-up    solve  iter   memory\n"
              "            [s CPU]  [s CPU]          [MB]\n");
  Vector found(patch.load), expected(patch.load);
  for (int pair = 0; pair < pairs; ++pair) {
    const Cost own = by_own(problem, system, patch, found);
    if (!with_both)
      continue;
    const Cost other = by_algebra(problem, patch, expected);
    const double size = expected.linfty_norm();
    expected -= found;
    std::printf("ratio of CPU %.1f, of the solve %.1f, of memory %.1f; answers "
                "differ by %.1e\n",
                other.total() / own.total(), other.solve / own.solve,
                other.memory / own.memory, expected.linfty_norm() / size);
    std::fflush(stdout);
  }
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
