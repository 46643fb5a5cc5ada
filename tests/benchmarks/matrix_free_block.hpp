#pragma once

// The common parts of the benchmarks of blocks without a matrix: a patch of
// nodes in contact, the cost of algebraic multigrid, and pairs of runs.

#include "base/cpu_clock.hpp"
#include "fem/linear/block_solver.hpp"

#include <cstdio>
#include <functional>
#include <vector>

namespace asperity::fem {

/// The nodes in contact and the forces of displacing them by 1 m.
struct Patch {
  using Vector = dealii::TrilinosWrappers::MPI::Vector;
  using IsTouched = std::function<bool(const dealii::Point<2>& place)>;

  std::vector<bool> held;
  std::vector<double> springs; ///< all 0
  Vector load;                 ///< [N]

  Patch(const BlockSystem& system, const BlockInverse& block,
        const IsTouched& is_touched)
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
    block.vmult(load, pushed);
    for (std::size_t i = 0; i < held.size(); ++i)
      if (held[i])
        load(system.contact()[i].row.front().first) = 0.0;
    load.compress(dealii::VectorOperation::insert);
  }
};

struct Cost {
  double set_up = 0.0, solve = 0.0; ///< [s CPU]
  double memory = 0.0;              ///< as the solver reports it [MB]

  double total() const { return set_up + solve; }
};

inline void print(const char* name, const Cost& cost, int iterations) {
  std::printf("%-10s %8.3f %8.3f %5d %8.1f\n", name, cost.set_up, cost.solve,
              iterations, cost.memory);
  std::fflush(stdout);
}

/// Solves to 1e-8 of the load and prints the cost.
/// @param setting_up  started before the block was made
inline Cost cost_of(BlockInverse& block, const CpuClock& setting_up,
                    const Patch& patch, Patch::Vector& displacement) {
  Cost cost;
  block.prepare(patch.springs, patch.held, false);
  cost.set_up = setting_up.seconds();
  displacement = 0.0;
  const CpuClock solving; // with what the first solve sets up
  const LinearSolution solution =
      block.solve(displacement, patch.load, 1e-8 * patch.load.l2_norm(), 1000);
  cost.solve = solving.seconds();
  cost.memory = 1e-6 * static_cast<double>(block.bytes());
  print(solution.has_converged ? "own" : "failed", cost, solution.iterations);
  return cost;
}

inline Cost cost_of_algebra(const BlockProblem& problem,
                            const BlockSystem& same_mesh, const Patch& patch,
                            Patch::Vector& displacement) {
  const BlockSystem system(problem, same_mesh); // assembles its matrix again
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

/// Prints pairs of runs and their ratios.
/// @param own_cost   solves without a matrix and prints the cost
/// @param with_both  whether algebraic multigrid runs, too
inline void
compare_in_pairs(const BlockProblem& problem, const BlockSystem& system,
                 const Patch& patch, int pairs, bool with_both,
                 const std::function<Cost(Patch::Vector&)>& own_cost) {
  std::printf("             set-up    solve  iter   memory\n"
              "            [s CPU]  [s CPU]          [MB]\n");
  Patch::Vector found(patch.load), expected(patch.load);
  for (int pair = 0; pair < pairs; ++pair) {
    const Cost own = own_cost(found);
    if (!with_both)
      continue;
    const Cost other = cost_of_algebra(problem, system, patch, expected);
    const double size = expected.linfty_norm();
    expected -= found;
    std::printf("ratio of CPU %.1f, of the solve %.1f, of memory %.1f; answers "
                "differ by %.1e\n",
                other.total() / own.total(), other.solve / own.solve,
                other.memory / own.memory, expected.linfty_norm() / size);
    std::fflush(stdout);
  }
}

} // namespace asperity::fem
