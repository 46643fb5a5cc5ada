#include "robustness/locking.hpp"

#include "robustness/kinds.hpp"

#include <cmath>
#include <numbers>

namespace asperity::robustness {
namespace {

/// Returns the compliance C of the wave [m/Pa]: the displacement due to its own
/// pressure, projected on the wave.
double compliance_of(const Instance& instance, int waves) {
  const Grid grid = grid_of(instance);
  const std::unique_ptr<contact::SurfaceOperator> block =
      operator_of(instance, grid, 1);
  std::vector<double> wave(grid.size());
  for (std::size_t i = 0; i < wave.size(); ++i)
    wave[i] = std::cos(2.0 * std::numbers::pi * waves * static_cast<double>(i) /
                       grid.points_x);
  std::vector<double> answer(grid.size());
  block->displacement(wave, answer);
  const std::span<const double> weights = block->nodal_weights();
  double moved = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < wave.size(); ++i) {
    const double weight = weights.empty() ? 1.0 : weights[i];
    moved += weight * wave[i] * answer[i];
    square += weight * wave[i] * wave[i];
  }
  return moved / square;
}

} // namespace

std::vector<LockingRow> locking_table() {
  std::vector<LockingRow> rows;
  for (const double thickness : {1.0, 0.1})
    for (const int waves : {1, 4})
      for (const double poisson_ratio : {0.0, 0.3, 0.49, 0.4999}) {
        Instance instance;
        instance.points = 32;
        instance.growth = 1.2;
        instance.thickness = thickness;
        instance.poisson_ratio = poisson_ratio;
        instance.family = Family::slab;
        const double exact = compliance_of(instance, waves);
        instance.family = Family::condensed_q1;
        const double q1 = compliance_of(instance, waves);
        instance.family = Family::condensed_q2;
        const double q2 = compliance_of(instance, waves);
        rows.push_back({poisson_ratio, thickness, waves, q1 / exact - 1.0,
                        q2 / exact - 1.0});
      }
  return rows;
}

} // namespace asperity::robustness
