// Compares our solver with plain conjugate gradients (Polonsky and Keer) near
// full contact, on one surface, without an initial guess and to the same gap
// error: iterations and processor time. Argument: points per side (1024). It
// takes some minutes and is not part of the tests.
#include "contact/solvers/polonsky_keer.hpp"
#include "contact/solvers/solver.hpp"
#include "tests/contact/problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <limits>

namespace {

using namespace asperity;
using namespace asperity::contact;

double processor_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Answer {
  ContactSolution solution;
  double seconds = 0.0;
};

template <class Solve>
Answer timed(Solve solve, SurfaceOperator& elasticity,
             const ContactProblem& problem, double pressure) {
  const double start = processor_time();
  Answer answer;
  answer.solution = solve(
      elasticity, problem,
      mechanics::LoadTarget{mechanics::Control::nominal_pressure, pressure},
      std::span<const double>{});
  answer.seconds = processor_time() - start;
  return answer;
}

std::string cells(const Answer& answer) {
  return fmt::format("{}{} | {:.1f}", answer.solution.iterations,
                     answer.solution.converged ? "" : " (not converged)",
                     answer.seconds);
}

} // namespace

int main(int argc, char** argv) {
  const int points = argc > 1 ? std::atoi(argv[1]) : 1024;
  const Grid grid{points, points, 1.0, 1.0};
  const std::vector<double> heights = problems::rough_heights(grid, {});
  FourierOperator elasticity = halfspace_operator(
      grid, {1.0, 0.0, std::numeric_limits<double>::infinity(), {}});
  const ContactProblem problem{heights, 0.0, 1e-8 * problems::rms(heights),
                               5000};
  fmt::print("{0} x {0} nodes, to 1e-8 h_rms\n"
             "| p/(E* h') | in contact, % | iterations | s | plain: iterations "
             "| s |\n|---|---|---|---|---|---|\n",
             points);
  for (const double pressure : std::array{0.3, 0.6, 1.0, 1.5, 2.0}) {
    const Answer ours = timed(solve_contact, elasticity, problem, pressure);
    const Answer plain = timed(polonsky_keer, elasticity, problem, pressure);
    const auto& map = ours.solution.pressure;
    const auto in_contact =
        std::count_if(map.begin(), map.end(), [](double p) { return p > 0; });
    fmt::print("| {} | {:.3f} | {} | {} |\n", pressure,
               100.0 * static_cast<double>(in_contact) /
                   static_cast<double>(map.size()),
               cells(ours), cells(plain));
    std::fflush(stdout);
  }
  return EXIT_SUCCESS;
}
