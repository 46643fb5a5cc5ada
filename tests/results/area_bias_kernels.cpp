#include "contact/operators/halfspace.hpp"
#include "fem/waves/condensed_q1.hpp"
#include "fem/waves/q2_operator.hpp"
#include "meshes/layers/graded_layers.hpp"
#include "results/observables/observables.hpp"
#include "results/observables/pressure_fit.hpp"
#include "tests/results/area_bias.hpp"

#include <fmt/format.h>

namespace asperity::area_bias {
namespace {

constexpr double poisson_ratio = 0.3;
constexpr double youngs_modulus = 1.0 - poisson_ratio * poisson_ratio; // E* = 1
constexpr double default_growth = 1.2; // of the layers

std::unique_ptr<contact::SurfaceOperator> halfspace(const Grid& grid) {
  mechanics::ElasticBlock block;
  block.contact_modulus = 1.0;
  block.poisson_ratio = poisson_ratio;
  block.thickness = grid.length_x; // like that of the finite elements
  return std::make_unique<contact::FourierOperator>(
      contact::halfspace_operator(grid, block));
}

fem::LayeredBlock block(const Grid& grid, double surface_cell,
                        double growth = default_growth) {
  return fem::homogeneous_block(
      meshes::graded_layers(surface_cell, growth, grid.length_x),
      youngs_modulus, poisson_ratio, mechanics::FarBoundary::clamped);
}

/// Set up once per grid and cloned for every surface.
template <class Build>
auto cached(Build build) {
  auto store = std::make_shared<
      std::map<int, std::unique_ptr<contact::SurfaceOperator>>>();
  return [store, build](const Grid& grid) {
    auto& one = (*store)[grid.points_x];
    if (!one)
      one = build(grid);
    return one->clone();
  };
}

Kernel q1_kernel(const std::string& name, double surface_cell_depth,
                 double growth = default_growth) {
  const auto build =
      [surface_cell_depth,
       growth](const Grid& grid) -> std::unique_ptr<contact::SurfaceOperator> {
    return std::make_unique<contact::FourierOperator>(
        grid,
        fem::condensed_compliance_q1(
            grid, block(grid, surface_cell_depth * grid.spacing_x(), growth)));
  };
  return {name, cached(build),
          results::q1_area_coefficients(surface_cell_depth)};
}

std::unique_ptr<contact::SurfaceOperator> q2_operator(const Grid& grid) {
  return std::make_unique<fem::Q2Operator>(
      fem::condensed_compliance_q2(grid, block(grid, 2.0 * grid.spacing_x())));
}

} // namespace

std::vector<Kernel> all_kernels() {
  std::vector<Kernel> kernels;
  kernels.push_back({"half-space", cached(halfspace),
                     results::halfspace_area_coefficients, 0.0, finest});
  for (const double depth : {0.5, 1.0, 1.5})
    kernels.push_back(
        q1_kernel(fmt::format("Q1, surface cells {} h deep", depth), depth));
  kernels.push_back(
      {"Q2, cubic cells", cached(q2_operator), results::q2_area_coefficients});
  kernels.push_back(
      q1_kernel("Q1, cubic cells, layers growing by 1.1", 1.0, 1.1));
  kernels.push_back(q1_kernel("Q1, cubic cells, penalty 100 E*/h", 1.0));
  kernels.back().penalty = 100.0;
  return kernels;
}

Sample measure(const Grid& grid, const contact::ContactSolution& solution,
               double rms_height,
               const results::AreaCoefficients& coefficients) {
  const auto& pressure = solution.pressure;
  Sample sample;
  sample.counted =
      results::counted_area_fraction(results::ContactNodes::under(pressure));
  sample.lines = results::line_area_fraction(grid, pressure, solution.gap, 1.0);
  sample.corrected = results::corrected_area_fraction(
                         grid, pressure, solution.gap, {1.0, coefficients})
                         .value;
  sample.fitted = results::fit_pressure_distribution(pressure).area_fraction;
  sample.perimeter =
      results::contact_perimeter(grid, results::ContactNodes::under(pressure)) *
      grid.spacing_x();
  sample.euler = results::euler_characteristic(grid, pressure) /
                 static_cast<double>(grid.size());
  sample.mean_gap = solution.mean_gap / rms_height;
  return sample;
}

} // namespace asperity::area_bias
