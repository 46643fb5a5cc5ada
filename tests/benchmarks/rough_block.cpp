// The cost of the stress inside a rough block after its solution: CPU seconds
// of the solve, of the maximum stress and of the files for ParaView, which
// remain for tools/render_block.py.
//
//     bench_rough_block [points] [folder_and_stem]
//
// Nodes per side (64), files (out/rough_block). A self-affine surface, H = 0.8,
// from 2 to points/6 (at least 4) waves per side, rms slope 0.1, on first-order
// boxes growing by 1.2 to a depth of half a side, clamped; nominal pressure
// 0.01 E*.
#include "base/cpu_clock.hpp"
#include "fem/block/full_block.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/layers/graded_layers.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/realization.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace asperity::fem {
namespace {

constexpr double youngs_modulus = 2e9; // Pa
constexpr double poisson_ratio = 0.3;
constexpr double side = 1e-5;             // m
constexpr double reduced_pressure = 0.01; // p_0 / E*
constexpr double penalty_scale = 100.0;   // k h / E

surfaces::HeightMap rough_surface(const Grid& grid) {
  const double unit = 2.0 * std::numbers::pi / side;
  const surfaces::SelfAffineShape shape{0.8, 2.0 * unit, 3.0 * unit,
                                        std::max(4, grid.points_x / 6) * unit};
  return surfaces::realize(
      surfaces::SelfAffineSpectrum::with_rms_slope(shape, 0.1).isotropic(),
      grid, {7, 0});
}

int run(int points, const std::string& folder_and_stem) {
  const Grid grid{points, points, side, side};
  const std::vector<double> heights = rough_surface(grid).heights;
  const auto block = make_full_block(
      grid, 1,
      homogeneous_block(
          meshes::graded_layers(grid.spacing_x(), 1.2, 0.5 * side),
          youngs_modulus, poisson_ratio, mechanics::FarBoundary::clamped));
  const double pressure =
      reduced_pressure * youngs_modulus / (1.0 - poisson_ratio * poisson_ratio);

  const CpuClock solving;
  const BlockSolution found = block->solve(
      heights, {mechanics::Control::nominal_pressure, pressure},
      {mechanics::ContactLaw::penalty,
       penalty_scale * youngs_modulus / grid.spacing_x(), 1e-8, 100});
  const double solve_seconds = solving.seconds();
  const CpuClock looking;
  const StressPeak peak = block->strongest_stress();
  const double look_seconds = looking.seconds();
  const CpuClock writing;
  block->write(folder_and_stem);
  const double write_seconds = writing.seconds();

  const auto touching =
      std::count_if(found.pressure.begin(), found.pressure.end(),
                    [](double p) { return p > 0.0; });
  std::printf("unknowns               %zu\n", block->unknowns());
  std::printf("area fraction, counted %.4f\n",
              static_cast<double>(touching) / static_cast<double>(grid.size()));
  std::printf("strongest von Mises    %.4g Pa, %.3g m deep\n", peak.von_mises,
              peak.depth);
  std::printf("Newton steps           %d\n", found.iterations);
  std::printf("solve                  %.3f s CPU\n", solve_seconds);
  std::printf("strongest stress       %.3f s CPU\n", look_seconds);
  std::printf("files                  %.3f s CPU\n", write_seconds);
  if (!found.converged)
    std::printf("not converged: %s\n", found.note.c_str());
  return found.converged ? 0 : 3;
}

} // namespace
} // namespace asperity::fem

int main(int n_arguments, char** arguments) {
  asperity::fem::start_mpi();
  return asperity::fem::run(n_arguments > 1 ? std::atoi(arguments[1]) : 64,
                            n_arguments > 2 ? arguments[2] : "out/rough_block");
}
