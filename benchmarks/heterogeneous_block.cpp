// The cost of a linear solve of a block of heterogeneous cells, by algebraic
// multigrid (settings of fem/linear/block_iterations.cpp) and with the Fourier
// solver of the uniform block as the preconditioner of conjugate gradients:
// set-up and solve in CPU seconds, iterations, memory. Moduli of +-50 % per
// cell, layers growing by 1.2 from cubic cells to a depth of one length,
// clamped; loads on every node; residual to 1e-12 of the load, as in
// fem/newton/contact_newton.cpp.
//
//     bench_heterogeneous_block [degree] [points] [multigrid] [k h/E*]
//
// Degree (1), nodes per side (32), whether multigrid is run too (1), stiffness
// of springs under a fifth of the contact surface (0 for none; otherwise none,
// 0.1, 10, 1e4). The memory of multigrid is the growth of the process, which is
// meaningful in its first row only.
#include "tests/fem/heterogeneous_block.hpp"

#include "base/cpu_clock.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/layers/graded_layers.hpp"

#include <deal.II/lac/trilinos_precondition.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <unistd.h>

namespace asperity::fem {
namespace {

using dealii::Vector;
using dealii::TrilinosWrappers::PreconditionAMG;

double resident_megabytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

/// One preconditioned solve, printed.
template <class Preconditioner>
void solve(const char* name, const char* springs,
           const HeterogeneousBlock& block,
           const Preconditioner& preconditioner, double set_up,
           double megabytes, double& seconds) {
  const Vector<double> force = block.loads(5);
  Vector<double> displacement(force.size());
  dealii::SolverControl control(2000, 1e-12 * force.l2_norm(), false, false);
  dealii::SolverCG<Vector<double>> conjugate_gradients(control);
  const CpuClock clock;
  bool converged = true;
  try {
    conjugate_gradients.solve(block.matrix(), displacement, force,
                              preconditioner);
  } catch (const dealii::SolverControl::NoConvergence&) {
    converged = false;
  }
  seconds = set_up + clock.seconds();
  std::printf("%8u  %-8s %-9s %8.3f %8.3f %5u %7.0f %s", force.size(), springs,
              name, set_up, seconds - set_up, control.last_step(), megabytes,
              converged ? "" : "not converged");
}

void run(int degree, int points, bool with_multigrid,
         const std::vector<double>& stiffnesses) {
  const Grid grid{points, points, 1e-5, 1e-5};
  const LayeredBlock uniform = homogeneous_block(
      meshes::graded_layers(degree * grid.spacing_x(), 1.2, grid.length_x),
      soft_modulus, 0.3, mechanics::FarBoundary::clamped);
  std::printf(
      "unknowns  k h/E*   method      set-up    solve  iter  memory\n"
      "                               [s CPU]  [s CPU]          [MB]\n");
  for (const double stiffness : stiffnesses) {
    const double contact_modulus = soft_modulus / (1.0 - 0.3 * 0.3);
    const std::vector<double> springs =
        springs_under_peaks(grid, stiffness > 0.0 ? 0.2 : 1.0,
                            stiffness * contact_modulus * grid.spacing_x());
    const HeterogeneousBlock block(grid, degree, uniform, 0.5, 3, springs);
    char label[16];
    std::snprintf(label, sizeof label, stiffness > 0.0 ? "%g" : "none",
                  stiffness);
    double by_waves = 0.0, by_multigrid = 0.0;
    {
      const CpuClock clock;
      LatticeSolver solver(grid, degree, uniform);
      solver.set_springs(springs);
      const double set_up = clock.seconds();
      const LatticePreconditioner preconditioner(solver, 1e-12);
      solve("waves", label, block, preconditioner, set_up,
            1e-6 * static_cast<double>(solver.bytes()), by_waves);
      std::printf("inner %d\n", preconditioner.inner_iterations());
    }
    if (!with_multigrid)
      continue;
    PreconditionAMG::AdditionalData settings;
    settings.elliptic = true;
    settings.higher_order_elements = degree > 1;
    settings.smoother_sweeps = 2;
    settings.aggregation_threshold = 1e-4;
    settings.constant_modes.assign(
        3, std::vector<bool>(block.lattice().size(), false));
    for (std::size_t i = 0; i < block.lattice().size(); ++i)
      settings.constant_modes[i / grid.size() % 3][i] = true;
    const double before = resident_megabytes();
    const CpuClock clock;
    PreconditionAMG multigrid;
    multigrid.initialize(block.matrix(), settings);
    solve("multigrid", label, block, multigrid, clock.seconds(),
          resident_megabytes() - before, by_multigrid);
    std::printf("ratio %.1f\n", by_multigrid / by_waves);
    std::fflush(stdout);
  }
}

} // namespace
} // namespace asperity::fem

int main(int n_arguments, char** arguments) {
  const auto argument = [&](int i, double otherwise) {
    return n_arguments > i ? std::atof(arguments[i]) : otherwise;
  };
  asperity::fem::start_mpi();
  asperity::fem::run(static_cast<int>(argument(1, 1)),
                     static_cast<int>(argument(2, 32)), argument(3, 1) > 0.0,
                     n_arguments > 4
                         ? std::vector<double>{argument(4, 0.0)}
                         : std::vector<double>{0.0, 0.1, 10.0, 1e4});
}
