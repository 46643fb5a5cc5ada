// The cost of a load step of the contact solver: iterations and transforms
// (counts, the same on every machine), CPU and wall seconds, peak memory; over
// loads from light to nearly full contact, without an initial guess and along a
// loading path.
//
//     bench_contact_steps [points] [threads] [thickness] [steps]
//
// Points per side (512), threads (1), thickness of a slab with a free far
// boundary in lengths (0: half-space), load steps of the path (16; 0: only
// steps without an initial guess).
#include "base/freed_memory.hpp"
#include "contact/solvers/load_sequence.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <memory>
#include <sys/resource.h>

#include "tests/contact/problems.hpp"

namespace asperity::contact {
namespace {

struct Clock {
  std::clock_t cpu = std::clock();
  std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();

  double cpu_seconds() const {
    return static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
  }

  double wall_seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                         wall)
        .count();
  }
};

double peak_gigabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0 * 1e-9;
}

struct RoughProblem {
  Grid grid;
  std::vector<double> heights;
  double gap_tolerance;
  std::unique_ptr<SurfaceOperator> elasticity;

  LoadSequence sequence() const {
    return {elasticity->clone(), heights, {}, gap_tolerance, 2000};
  }
};

/// Solves and prints one step; its cost is added to the total.
struct Totals {
  int steps = 0, iterations = 0, most = 0, unconverged = 0;
  double cpu = 0.0, most_cpu = 0.0, wall = 0.0;

  void take(const char* kind, LoadSequence& sequence, double pressure) {
    const Clock clock;
    const ContactSolution solution =
        sequence.solve({mechanics::Control::nominal_pressure, pressure});
    const double seconds = clock.cpu_seconds();
    const double wall_seconds = clock.wall_seconds();
    const auto contacts =
        std::count_if(solution.pressure.begin(), solution.pressure.end(),
                      [](double value) { return value > 0.0; });
    std::printf("%-7s %9.4f %7.4f %6d %6d %8.3f %8.3f %s\n", kind, pressure,
                static_cast<double>(contacts) /
                    static_cast<double>(solution.pressure.size()),
                solution.iterations, solution.transforms, seconds, wall_seconds,
                solution.note.c_str());
    ++steps;
    iterations += solution.iterations;
    most = std::max(most, solution.iterations);
    unconverged += solution.converged ? 0 : 1;
    cpu += seconds;
    most_cpu = std::max(most_cpu, seconds);
    wall += wall_seconds;
  }

  void print(const char* kind) const {
    std::printf("%-7s iterations: mean %.1f, most %d; CPU [s]: mean %.3f, most "
                "%.3f; wall [s]: mean %.3f; unconverged: %d\n",
                kind, static_cast<double>(iterations) / steps, most,
                cpu / steps, most_cpu, wall / steps, unconverged);
  }
};

void run(int points, int threads, double thickness, int n_steps) {
  const Grid grid{points, points, 1.0, 1.0};
  RoughProblem problem{grid, problems::rough_heights(grid, {}), 0.0, nullptr};
  problem.gap_tolerance = 1e-8 * problems::rms(problem.heights);
  const double infinity = std::numeric_limits<double>::infinity();
  const Clock clock;
  problem.elasticity = std::make_unique<FourierOperator>(
      halfspace_operator(grid,
                         {1.0, 0.3, thickness > 0.0 ? thickness : infinity,
                          mechanics::FarBoundary::pressure},
                         threads));
  std::printf("%d^2, %d threads; set-up CPU %.3f s\n", points, threads,
              clock.cpu_seconds());
  std::printf("%-7s %9s %7s %6s %6s %8s %8s\n", "start", "p0/E*h'", "area",
              "iter", "pairs", "CPU [s]", "wall [s]");
  Totals cold;
  for (const double pressure : {.003, .01, .03, .1, .3, .6, 1.0, 1.3}) {
    LoadSequence sequence = problem.sequence();
    cold.take("cold", sequence, pressure);
  }
  Totals program;
  LoadSequence sequence = problem.sequence();
  for (int step = 0; step < n_steps; ++step)
    program.take("program", sequence,
                 3e-3 * std::pow(400.0, step / std::max(1.0, n_steps - 1.0)));
  cold.print("cold");
  if (n_steps > 0)
    program.print("program");
  std::printf("peak memory %.2f GB\n", peak_gigabytes());
}

} // namespace
} // namespace asperity::contact

int main(int n_arguments, char** arguments) {
  asperity::keep_freed_memory();
  const auto argument = [&](int i, double otherwise) {
    return n_arguments > i ? std::atof(arguments[i]) : otherwise;
  };
  asperity::contact::run(static_cast<int>(argument(1, 512)),
                         static_cast<int>(argument(2, 1)), argument(3, 0.0),
                         static_cast<int>(argument(4, 16)));
}
