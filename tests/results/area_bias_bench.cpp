// The bias of every estimator of the contact area, and of the mean gap, against
// the limit of fine grids: the tables of docs/measurements/area.md,
// and the calibration of results/area_estimate. It takes some minutes and is
// not part of the tests:
//
//     ninja -C build/release bench_results_area_bias
//     build/release/tests/results/bench_results_area_bias [surfaces] [hurst]
//
// One self-affine surface per realisation, with the shortest wave L/16 and the
// roll-off L/4, sampled at r nodes per shortest wave; loads p/(E* h') of
// `loads`. The limit is the half-space at the finest r, by (A.5).
#include "surfaces/build.hpp"
#include "surfaces/maps/statistics.hpp"
#include "tests/results/area_bias.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <numbers>
#include <utility>

namespace {

using namespace asperity;
using namespace asperity::area_bias;

constexpr int kernel_cost_r = 32; // 512 x 512 nodes

mechanics::SurfaceSpec rough_surface(double hurst) {
  constexpr double longest = 2.0 * std::numbers::pi; // rad per side of 1 m
  mechanics::SurfaceSpec surface;
  surface.kind = mechanics::SurfaceKind::self_affine;
  surface.length = 1.0;
  surface.points = waves * finest;
  surface.seed = 1;
  surface.rescale = true;
  surface.rms_slope = 0.1;
  surface.hurst = hurst;
  surface.wavevector_low = longest;
  surface.wavevector_roll_off = 4.0 * longest;
  surface.wavevector_high = waves * longest;
  return surface;
}

std::vector<double> every_nth(const std::vector<double>& heights, int points,
                              int step) {
  const auto n = static_cast<std::size_t>(points);
  const auto stride = static_cast<std::size_t>(step);
  std::vector<double> read(n * n);
  for (std::size_t iy = 0; iy < n; ++iy)
    for (std::size_t ix = 0; ix < n; ++ix)
      read[iy * n + ix] = heights[(iy * stride * n + ix) * stride];
  return read;
}

double processor_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; // s
}

/// Processor time [s], summed over surfaces; the operator is set up once.
struct Cost {
  double set_up = 0.0;
  double load_programs = 0.0;
};

/// All loads of one operator on one surface, with r nodes per wave.
void run(const Kernel& kernel, const surfaces::HeightMap& map, int surface,
         int r, Samples& samples, Cost& cost) {
  const surfaces::Statistics size = surfaces::statistics(map);
  const Grid grid{waves * r, waves * r, 1.0, 1.0};
  const mechanics::ContactInterface hard_contact =
      kernel.penalty > 0.0
          ? mechanics::ContactInterface{mechanics::ContactLaw::penalty,
                                        kernel.penalty / grid.spacing_x()}
          : mechanics::ContactInterface{};
  double start = processor_time();
  auto elasticity = kernel.make(grid);
  cost.set_up += processor_time() - start;
  contact::LoadSequence sequence(
      std::move(elasticity), every_nth(map.heights, grid.points_x, finest / r),
      hard_contact, 1e-8 * size.rms_height, 3000);
  for (std::size_t load = 0; load < loads.size(); ++load) {
    start = processor_time();
    const contact::ContactSolution solution = sequence.solve(
        {mechanics::Control::nominal_pressure, loads[load] * size.rms_slope});
    cost.load_programs += processor_time() - start;
    if (!solution.converged)
      fmt::print("not converged: {}, r = {}: {}\n", kernel.name, r,
                 solution.note);
    samples[{kernel.name, r, load, surface}] =
        measure(grid, solution, size.rms_height, kernel.coefficients);
  }
}

} // namespace

int main(int argc, char** argv) {
  const int n_surfaces = argc > 1 ? std::atoi(argv[1]) : 3;
  const double hurst = argc > 2 ? std::atof(argv[2]) : 0.8;
  const mechanics::SurfaceSpec surface = rough_surface(hurst);
  const std::vector<Kernel> kernels = all_kernels();
  Samples samples;
  std::map<std::pair<std::string, int>, Cost> costs;
  for (int realization = 0; realization < n_surfaces; ++realization) {
    const surfaces::HeightMap map =
        surfaces::build_surface(surface, realization);
    for (const Kernel& kernel : kernels)
      for (int r = coarsest; r <= kernel.finest; r *= 2)
        run(kernel, map, realization, r, samples, costs[{kernel.name, r}]);
  }

  fmt::print("H = {}, {} surfaces; per cent, mean over surfaces and standard "
             "deviation between them\n",
             hurst, n_surfaces);
  const Limits limits = find_limits(samples, n_surfaces);
  print_limit_doubt(samples, limits);
  for (const Kernel& kernel : kernels) {
    print_calibration(kernel, samples, limits);
    print_areas(kernel, samples, limits);
    print_gaps(kernel, samples, limits);
    const Cost& cost = costs[{kernel.name, kernel_cost_r}];
    fmt::print("\nprocessor time at r = {}: set-up {:.2f} s, a loading path "
               "{:.2f} s\n",
               kernel_cost_r, cost.set_up, cost.load_programs / n_surfaces);
  }
  return EXIT_SUCCESS;
}
