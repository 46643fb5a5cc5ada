#pragma once

// Random rough obstacles for the contact tests, made without the module
// `surfaces`, and an independent check of complementarity.

#include "base/fourier.hpp"
#include "base/maximum.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/solver.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace asperity::contact::problems {

struct Roughness {
  double hurst = 0.8;
  double roll_off = 4.0;      ///< longest wave is length / roll_off
  double shortest_wave = 8.0; ///< in grid points
  unsigned seed = 1;
};

/// The operator of the half-space with E* = 1 Pa.
inline FourierOperator unit_halfspace(const Grid& grid, int threads = 1) {
  return halfspace_operator(grid, mechanics::halfspace(1.0), threads);
}

/// Numbers between -1 and 1.
inline std::vector<double> random_field(std::size_t size) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::vector<double> field(size);
  for (double& one : field)
    one = value(random);
  return field;
}

/// Self-affine heights on a square grid, with random phases, mean 0 and rms
/// slope 1.
inline std::vector<double> rough_heights(const Grid& grid,
                                         const Roughness& roughness) {
  const RealFourier fourier(grid);
  std::vector<std::complex<double>> modes(grid.half_spectrum_size());
  std::mt19937_64 random(roughness.seed);
  std::uniform_real_distribution<double> phase(0.0, 2.0 * std::numbers::pi);
  const double q_high =
      2.0 * std::numbers::pi / (roughness.shortest_wave * grid.spacing_x());
  const double q_roll_off =
      2.0 * std::numbers::pi * roughness.roll_off / grid.length_x;
  double mean_square_slope = 0.0;
  std::size_t at = 0;
  for (int jy = 0; jy < grid.points_y; ++jy)
    for (int jx = 0; jx <= grid.points_x / 2; ++jx, ++at) {
      const int row = signed_wavenumber(jy, grid.points_y);
      const double q = std::hypot(wavevector(jx, grid.length_x),
                                  wavevector(row, grid.length_y));
      const double angle = phase(random);
      const bool is_self_conjugate_column =
          jx == 0 || 2 * jx == grid.points_x || 2 * jy == grid.points_y;
      if (q > q_high || is_self_conjugate_column)
        continue;
      const double amplitude =
          std::pow(std::max(q, q_roll_off), -1.0 - roughness.hurst);
      modes[at] = std::polar(amplitude, angle);
      mean_square_slope += 2.0 * amplitude * amplitude * q * q;
    }
  std::vector<double> heights(grid.size());
  fourier.backward(modes, heights);
  for (double& height : heights)
    height /= std::sqrt(mean_square_slope);
  return heights;
}

inline double rms(const std::vector<double>& field) {
  double sum = 0.0;
  for (const double value : field)
    sum += value * value;
  return std::sqrt(sum / static_cast<double>(field.size()));
}

/// Largest violation of p >= 0, gap + c p >= 0, p (gap + c p) = 0 [m]. The
/// displacement is computed again; of the solution only the pressure and the
/// first gap are used. NaN where any number is not finite, infinity where the
/// fields do not have the size of the grid.
inline double complementarity_error(SurfaceOperator& elasticity,
                                    const ContactProblem& problem,
                                    const ContactSolution& solution) {
  const std::size_t nodes = elasticity.grid().size();
  if (solution.pressure.size() != nodes || solution.gap.size() != nodes ||
      problem.heights.size() != nodes)
    return INFINITY;
  std::vector<double> displacement(nodes);
  elasticity.displacement(solution.pressure, displacement);
  const double rigid_distance =
      solution.gap[0] - displacement[0] + problem.heights[0];
  double error = 0.0;
  for (std::size_t i = 0; i < nodes; ++i) {
    const double excess = displacement[i] - problem.heights[i] +
                          rigid_distance +
                          problem.local_compliance * solution.pressure[i];
    if (solution.pressure[i] < 0.0)
      return INFINITY;
    error =
        maximum(error, solution.pressure[i] > 0.0 ? std::abs(excess) : -excess);
    error += 0.0 * (solution.gap[i] + excess); // NaN where one is not finite
  }
  return error;
}

} // namespace asperity::contact::problems
