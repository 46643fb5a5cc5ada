// What a block on a lattice of boxes costs by geometric multigrid without a
// matrix (fem/multigrid) and by algebraic multigrid, in pairs of runs: set-up
// and one solve in CPU seconds, iterations, memory. A rough patch of nodes is
// held and pushed in by one length, layers grow by 1.2 from cubic cells to a
// depth of one side; residual to 1e-8 of the load.
//
//     bench_lattice_block [degree] [points] [pairs] [both|lattice]
//
// degree (1), nodes a side (32), pairs of runs (1), which solvers (both). The
// set-up of algebraic multigrid includes the assembly of its matrices. Memory
// of the lattice is as reported; of algebraic multigrid it is what the process
// grew by, true in the first pair only.
#include "fem/block/lattice_block.hpp"

#include "base/cpu_clock.hpp"
#include "fem/block/block_solver.hpp"
#include "fem/block/mesh_lattice.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/graded_layers.hpp"
#include "meshes/layered_mesh.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <numbers>
#include <unistd.h>

namespace asperity::fem {
namespace {

using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr double side = 1e-3; // m

double resident_megabytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

BlockProblem problem_of(int degree, int points) {
  const Grid grid{points, points, side, side};
  const Grid cells{points / degree, points / degree, side, side};
  return {.grid = grid,
          .mesh = meshes::layered_mesh(
              cells, meshes::graded_layers(cells.spacing_x(), 1.2, side)),
          .degree = degree,
          .moduli = ModuliField(moduli(mechanics::BodyModuli{2e9, 0.3}))};
}

/// Some fifth of the surface, in patches of several sizes.
bool is_touched(const dealii::Point<2>& place) {
  const double u = 2.0 * std::numbers::pi * place[0] / side;
  const double v = 2.0 * std::numbers::pi * place[1] / side;
  return std::cos(u) + std::cos(2.0 * v + 1.0) +
             0.7 * std::cos(3.0 * u + 2.0 * v) +
             0.5 * std::cos(5.0 * u - 4.0 * v + 0.5) >
         1.1;
}

/// The held nodes and the forces of pushing them in.
struct Patch {
  std::vector<bool> held;
  std::vector<double> springs;
  Vector load;

  explicit Patch(const BlockSystem& system, const LatticeBlock& lattice)
      : held(system.contact().size()),
        springs(held.size(), 0.0),
        load(system.space().make_vector()) {
    Vector pushed(load);
    for (std::size_t i = 0; i < held.size(); ++i) {
      held[i] = is_touched(system.contact()[i].place);
      if (held[i])
        pushed(system.contact()[i].row.front().first) = -1.0;
    }
    pushed.compress(dealii::VectorOperation::insert);
    lattice.vmult(load, pushed);
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

void print(const char* name, const Cost& cost, int iterations) {
  std::printf("%-10s %8.3f %8.3f %5d %8.1f\n", name, cost.set_up, cost.solve,
              iterations, cost.memory);
  std::fflush(stdout);
}

Cost by_lattice(const BlockProblem& problem, const BlockSystem& system,
                const Patch& patch, Vector& displacement) {
  Cost cost;
  const CpuClock setting_up;
  LatticeBlock lattice(system, *box_lattice(problem));
  lattice.prepare(patch.springs, patch.held);
  cost.set_up = setting_up.seconds();
  displacement = 0.0;
  const CpuClock solving;
  const LinearSolution solution = lattice.solve(
      displacement, patch.load, 1e-8 * patch.load.l2_norm(), 1000);
  cost.solve = solving.seconds();
  cost.memory = 1e-6 * static_cast<double>(lattice.bytes());
  print("lattice", cost, solution.iterations);
  std::printf("           %zu levels, %.0f bytes an unknown\n",
              lattice.levels(),
              1e6 * cost.memory / static_cast<double>(system.n_unknowns()));
  return cost;
}

Cost by_algebra(const BlockProblem& problem, const Patch& patch,
                Vector& displacement) {
  const BlockSystem system(problem); // its matrix is assembled anew
  Cost cost;
  const double before = resident_megabytes();
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
  cost.memory = resident_megabytes() - before;
  print(converged ? "algebraic" : "failed", cost, solver.iterations());
  return cost;
}

void run(int degree, int points, int pairs, bool with_both) {
  const BlockProblem problem = problem_of(degree, points);
  const CpuClock building;
  const BlockSystem system(problem);
  const LatticeBlock lattice(system, *box_lattice(problem));
  const Patch patch(system, lattice);
  std::printf("%s%.2f s CPU for mesh and unknowns\n"
              "             set-up    solve  iter   memory\n"
              "            [s CPU]  [s CPU]          [MB]\n",
              system.report().c_str(), building.seconds());
  Vector found(patch.load), expected(patch.load);
  for (int pair = 0; pair < pairs; ++pair) {
    const Cost own = by_lattice(problem, system, patch, found);
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
  const auto argument = [&](int i, int otherwise) {
    return n_arguments > i ? std::atoi(arguments[i]) : otherwise;
  };
  asperity::fem::start_mpi();
  asperity::fem::run(argument(1, 1), argument(2, 32), argument(3, 1),
                     n_arguments < 5 ||
                         std::strcmp(arguments[4], "lattice") != 0);
}
