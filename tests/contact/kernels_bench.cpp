// The kernels of a contact step at N^2 nodes: transforms, extension beyond the
// contact boundary, and one step of the iteration. The benchmarks of the other
// kernels are beside the tests of their modules: fem/condensed (block symbol),
// md/interface (forces), theory/persson (quadrature).
#include "base/fourier.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/boundary_extension.hpp"
#include "contact/solvers/contact_state.hpp"
#include "tests/contact/problems.hpp"

#include <benchmark/benchmark.h>

#include <limits>

namespace asperity::contact {
namespace {

Grid grid_of(const benchmark::State& state) {
  const int points = static_cast<int>(state.range(0));
  return {points, points, 1.0, 1.0};
}

FourierOperator halfspace(const Grid& grid) {
  return halfspace_operator(
      grid, {1.0, 0.0, std::numeric_limits<double>::infinity(), {}});
}

void fourier_pair(benchmark::State& state) {
  const RealFourier fourier(grid_of(state));
  std::vector<double> field(fourier.grid().size(), 1.0);
  std::vector<std::complex<double>> modes(fourier.grid().half_spectrum_size());
  for (auto _ : state) {
    fourier.forward(field, modes);
    fourier.backward(modes, field);
  }
}

void convolution_double(benchmark::State& state) {
  FourierOperator elasticity = halfspace(grid_of(state));
  const std::vector<double> pressure(elasticity.grid().size(), 1.0);
  std::vector<double> answer(pressure.size());
  for (auto _ : state)
    elasticity.displacement(pressure, answer);
}

void convolution_single(benchmark::State& state) {
  FourierOperator elasticity = halfspace(grid_of(state));
  const std::vector<float> pressure(elasticity.grid().size(), 1.0F);
  std::vector<float> answer(pressure.size());
  for (auto _ : state)
    elasticity.displacement_change(pressure, answer);
}

/// A state near a contact fraction of 20 %.
ContactState partial_contact(FourierOperator& elasticity,
                             const std::vector<double>& heights) {
  std::vector<double> start(heights);
  for (double& value : start)
    value = std::max(0.0, value - problems::rms(heights));
  ContactState state(elasticity, {heights, 0.0, 1e-12, 1},
                     {mechanics::Control::nominal_pressure, 0.1}, start);
  state.update_residual();
  return state;
}

void residual(benchmark::State& state) {
  FourierOperator elasticity = halfspace(grid_of(state));
  const std::vector<double> heights =
      problems::rough_heights(elasticity.grid(), {});
  ContactState contact = partial_contact(elasticity, heights);
  for (auto _ : state)
    contact.update_residual();
}

void projection(benchmark::State& state) {
  FourierOperator elasticity = halfspace(grid_of(state));
  const std::vector<double> heights =
      problems::rough_heights(elasticity.grid(), {});
  ContactState contact = partial_contact(elasticity, heights);
  std::vector<float> direction(heights.size(), -1e-3F);
  std::vector<float> displaced(heights.size(), -1e-3F);
  for (auto _ : state)
    contact.advance(1e-6F, direction, displaced);
}

void extension_build(benchmark::State& state) {
  FourierOperator elasticity = halfspace(grid_of(state));
  const std::vector<double> heights =
      problems::rough_heights(elasticity.grid(), {});
  const ContactState contact = partial_contact(elasticity, heights);
  BoundaryExtension extension(elasticity.grid(), 1);
  for (auto _ : state)
    extension.build(1.0, contact.freedom);
}

void extension_extend_and_fold(benchmark::State& state) {
  FourierOperator elasticity = halfspace(grid_of(state));
  const std::vector<double> heights =
      problems::rough_heights(elasticity.grid(), {});
  ContactState contact = partial_contact(elasticity, heights);
  BoundaryExtension extension(elasticity.grid(), 1);
  extension.build(1.0, contact.freedom);
  std::vector<float> extended(heights.size());
  for (auto _ : state) {
    const BoundaryExtension::Active active{contact.freedom, contact.active};
    extension.extend(active, contact.residual, extended);
    extension.fold(active, extended);
  }
}

#define KERNEL(name)                                                           \
  BENCHMARK(name)->RangeMultiplier(2)->Range(64, 2048)->Unit(                  \
      benchmark::kMillisecond)
KERNEL(fourier_pair);
KERNEL(convolution_double);
KERNEL(convolution_single);
KERNEL(residual);
KERNEL(projection);
KERNEL(extension_build);
KERNEL(extension_extend_and_fold);

} // namespace
} // namespace asperity::contact
