// The cost of a load step of the contact solver: iterations and transforms
// (counts, the same on every machine), CPU and wall seconds, peak memory; over
// loads from light to nearly full contact, without an initial guess and along a
// loading path. The ratio is the CPU time of a step over that of its
// transforms, on all grids.
//
//     bench_contact_steps [points] [threads] [thickness] [steps] [loads ...]
//     bench_contact_steps table [points] [threads] [steps] [waves ...]
//
// Points per side (512), threads (1), thickness of a slab with a free far
// boundary in lengths (0: half-space; -1: half-space with free boundaries),
// load steps of the path (16; 0: only steps without an initial guess), nominal
// pressures of the steps without one in E* h' (.003 to 1.3). The table has the
// iterations on half-spaces from .1 to 99 % contact for H of .3 and .95,
// without and with a roll-off, and these numbers of points in the shortest wave
// (2 4 8 16).
#include "base/array_memory.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "tests/contact/problems.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <memory>
#include <string_view>
#include <sys/resource.h>

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

/// CPU time of all applications of operators [s].
const auto transform_seconds = std::make_shared<double>(0.0);

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
  double cpu = 0.0, most_cpu = 0.0, wall = 0.0, transforms = 0.0;

  void take(const char* kind, LoadSequence& sequence, double pressure) {
    *transform_seconds = 0.0;
    const Clock clock;
    const ContactSolution solution =
        sequence.solve({mechanics::Control::nominal_pressure, pressure});
    const double seconds = clock.cpu_seconds();
    const double wall_seconds = clock.wall_seconds();
    const auto contacts =
        std::count_if(solution.pressure.begin(), solution.pressure.end(),
                      [](double value) { return value > 0.0; });
    std::printf("%-7s %9.4f %7.4f %6d %6d %8.3f %8.3f %6.2f %s\n", kind,
                pressure,
                static_cast<double>(contacts) /
                    static_cast<double>(solution.pressure.size()),
                solution.iterations, solution.transforms, seconds, wall_seconds,
                seconds / *transform_seconds, solution.note.c_str());
    ++steps;
    iterations += solution.iterations;
    most = std::max(most, solution.iterations);
    unconverged += solution.converged ? 0 : 1;
    cpu += seconds;
    most_cpu = std::max(most_cpu, seconds);
    wall += wall_seconds;
    transforms += *transform_seconds;
  }

  void print(const char* kind) const {
    std::printf("%-7s iterations: mean %.1f, most %d; CPU [s]: mean %.3f, most "
                "%.3f; ratio %.2f; wall [s]: mean %.3f; unconverged: %d\n",
                kind, static_cast<double>(iterations) / steps, most,
                cpu / steps, most_cpu, cpu / transforms, wall / steps,
                unconverged);
  }
};

/// @param thickness  [m]; 0: infinite; < 0: infinite with free boundaries
std::unique_ptr<SurfaceOperator> elastic_body(const Grid& grid,
                                              double thickness, int threads) {
  constexpr double modulus = 1.0, ratio = 0.3;
  if (thickness < 0.0)
    return free_halfspace(grid, modulus / (1.0 - ratio * ratio), threads)
        .clone();
  const double infinity = std::numeric_limits<double>::infinity();
  return std::make_unique<FourierOperator>(halfspace_operator(
      grid,
      {modulus, ratio, thickness > 0.0 ? thickness : infinity,
       mechanics::FarBoundary::pressure},
      threads));
}

void run(int points, int threads, double thickness, int n_steps,
         const std::vector<double>& pressures) {
  const Grid grid{points, points, 1.0, 1.0};
  RoughProblem problem{grid, problems::rough_heights(grid, {}), 0.0, nullptr};
  problem.gap_tolerance = 1e-8 * problems::rms(problem.heights);
  const Clock clock;
  problem.elasticity = elastic_body(grid, thickness, threads);
  problem.elasticity->measure(transform_seconds);
  std::printf("%d^2, %d threads; set-up CPU %.3f s\n", points, threads,
              clock.cpu_seconds());
  std::printf("%-7s %9s %7s %6s %6s %8s %8s %6s\n", "start", "p0/E*h'", "area",
              "iter", "pairs", "CPU [s]", "wall [s]", "ratio");
  Totals cold;
  for (const double pressure : pressures) {
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
  std::printf("peak memory %.3f GB, %.0f bytes per node\n", peak_gigabytes(),
              1e9 * peak_gigabytes() / static_cast<double>(grid.size()));
}

/// Iterations of one surface, cold and along a path.
void print_row(const Grid& grid, const problems::Roughness& roughness,
               int threads, int n_steps) {
  RoughProblem problem{grid, problems::rough_heights(grid, roughness), 0.0,
                       elastic_body(grid, 0.0, threads)};
  problem.gap_tolerance = 1e-8 * problems::rms(problem.heights);
  int most = 0, unconverged = 0;
  const auto iterations = [&](LoadSequence& sequence, double pressure) {
    const ContactSolution solution =
        sequence.solve({mechanics::Control::nominal_pressure, pressure});
    most = std::max(most, solution.iterations);
    unconverged += solution.converged ? 0 : 1;
    return solution.iterations;
  };
  constexpr double lightest = 5e-4, heaviest = 2.0; // in E* h'
  std::printf("%4.2f %8.0f %6.0f ", roughness.hurst, roughness.roll_off,
              roughness.shortest_wave);
  for (const double pressure : {lightest, 5e-3, .025, .11, .35, .9, heaviest}) {
    LoadSequence sequence = problem.sequence();
    std::printf(" %3d", iterations(sequence, pressure));
  }
  std::printf("  |");
  LoadSequence path = problem.sequence();
  for (int step = 0; step < n_steps; ++step)
    std::printf(" %2d",
                iterations(path, lightest * std::pow(heaviest / lightest,
                                                     step / (n_steps - 1.0))));
  std::printf("  | %d%s\n", most, unconverged > 0 ? ", not all converged" : "");
  std::fflush(stdout);
}

void print_table(int points, int threads, int n_steps,
                 const std::vector<double>& waves) {
  std::printf("%d^2: iterations by H, roll-off, points in the shortest wave; "
              "cold at .1, 1, 5, 20, 50, 80 and 99 %% contact | path | most\n",
              points);
  for (const double hurst : {.3, .95})
    for (const double roll_off : {1.0, 4.0})
      for (const double wave : waves)
        print_row({points, points, 1.0, 1.0}, {hurst, roll_off, wave}, threads,
                  n_steps);
}

} // namespace
} // namespace asperity::contact

int main(int n_arguments, char** arguments) {
  asperity::keep_freed_memory();
  const auto argument = [&](int i, double otherwise) {
    return n_arguments > i ? std::atof(arguments[i]) : otherwise;
  };
  const auto numbers_from = [&](int first, std::vector<double> otherwise) {
    std::vector<double> numbers;
    for (int i = first; i < n_arguments; ++i)
      numbers.push_back(argument(i, 0.0));
    return numbers.empty() ? otherwise : numbers;
  };
  if (n_arguments > 1 && std::string_view(arguments[1]) == "table") {
    asperity::contact::print_table(static_cast<int>(argument(2, 512)),
                                   static_cast<int>(argument(3, 1)),
                                   static_cast<int>(argument(4, 16)),
                                   numbers_from(5, {2.0, 4.0, 8.0, 16.0}));
    return 0;
  }
  asperity::contact::run(
      static_cast<int>(argument(1, 512)), static_cast<int>(argument(2, 1)),
      argument(3, 0.0), static_cast<int>(argument(4, 16)),
      numbers_from(5, {.003, .01, .03, .1, .3, .6, 1.0, 1.3}));
}
