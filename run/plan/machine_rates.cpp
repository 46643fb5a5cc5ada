#include "run/plan/machine_rates.hpp"

#include "base/cpu_clock.hpp"
#include "base/fourier.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity::run {
namespace {

constexpr int n_iterations = 8;
constexpr int n_transforms = 8;
constexpr int reference_points = 256;

/// CPU time of a 256 x 256 transform pair on a 2-core AMD EPYC [s].
constexpr double reference_transform_time = 0.5e-3;

double work_of(double nodes) {
  return nodes * std::log2(std::max(nodes, 2.0));
}

/// Returns a sum of waves of several lengths, which makes contact at many spots
/// of a generic kind.
std::vector<double> heights_of(const Grid& grid) {
  std::vector<double> heights(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const double x = 2.0 * std::numbers::pi * ix / grid.points_x;
      const double y = 2.0 * std::numbers::pi * iy / grid.points_y;
      heights[grid.index(ix, iy)] =
          0.01 *
          (std::cos(x) * std::cos(y + 1.0) + 0.5 * std::cos(3.0 * x + 2.0 * y) +
           0.3 * std::sin(5.0 * x) * std::cos(7.0 * y));
    }
  return heights;
}

double transform_time(const Grid& grid) {
  const RealFourier fourier(grid);
  std::vector<double> field(grid.size(), 1.0);
  std::vector<std::complex<double>> spectrum(grid.half_spectrum_size());
  fourier.forward(field, spectrum); // warms up memory pages and caches
  const CpuClock clock;
  for (int i = 0; i < n_transforms; ++i) {
    fourier.forward(field, spectrum);
    fourier.backward(spectrum, field);
    std::fill(field.begin(), field.end(), 1.0);
  }
  return clock.seconds() / n_transforms;
}

double iteration_time(const Grid& grid) {
  contact::FourierOperator elasticity = contact::halfspace_operator(
      grid, {1.0, 0.3, std::numeric_limits<double>::infinity(),
             mechanics::FarBoundary::clamped});
  const std::vector<double> heights = heights_of(grid);
  const contact::ContactProblem problem{heights, 0.0, 1e-14, n_iterations};
  const CpuClock clock;
  const contact::ContactSolution solution = contact::solve_contact(
      elasticity, problem, {mechanics::Control::nominal_pressure, 0.01});
  return clock.seconds() / std::max(1, solution.iterations);
}

} // namespace

MachineRates::MachineRates(int largest_probe) : largest_probe_(largest_probe) {}

double MachineRates::transform_time(const Grid& grid) {
  return times(grid).transform;
}

double MachineRates::iteration_time(const Grid& grid) {
  return times(grid).iteration;
}

double MachineRates::relative_time() {
  const Grid reference{reference_points, reference_points, 1.0, 1.0};
  return transform_time(reference) / reference_transform_time;
}

MachineRates::Times MachineRates::times(const Grid& grid) {
  const int points_x = std::clamp(grid.points_x, 8, largest_probe_);
  const int points_y = std::clamp(grid.points_y, 8, largest_probe_);
  auto [found, is_new] = known_.try_emplace({points_x, points_y});
  if (is_new)
    found->second = probe(points_x, points_y);
  const double larger = work_of(static_cast<double>(grid.size())) /
                        work_of(static_cast<double>(points_x) * points_y);
  return {larger * found->second.transform, larger * found->second.iteration};
}

MachineRates::Times MachineRates::probe(int points_x, int points_y) {
  const Grid grid{points_x, points_y, 1.0, 1.0};
  return {run::transform_time(grid), run::iteration_time(grid)};
}

} // namespace asperity::run
