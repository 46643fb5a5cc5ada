#include "contact/operators/halfspace.hpp"

#include "base/require.hpp"
#include "contact/operators/layered_compliance.hpp"

#include <cmath>

namespace asperity::contact {
namespace {

// Numerator and denominator are divided by exp(2x)/2, so that nothing
// overflows: sinh 2x -> 1 - e, cosh 2x -> 1 + e, with e = exp(-4x).

double clamped_factor(double x, double poisson_ratio) {
  const double e = std::exp(-4.0 * x);
  const double decay = 2.0 * std::exp(-2.0 * x);
  const double kolosov = 3.0 - 4.0 * poisson_ratio;
  const double constant =
      5.0 - 12.0 * poisson_ratio + 8.0 * poisson_ratio * poisson_ratio;
  return (-kolosov * std::expm1(-4.0 * x) - 2.0 * x * decay) /
         (kolosov * (1.0 + e) + (2.0 * x * x + constant) * decay);
}

double sliding_factor(double x) {
  // cosh 2x - 1 = 2 sinh^2 x
  const double decay = 2.0 * std::exp(-2.0 * x);
  const double one_minus = -std::expm1(-2.0 * x);
  return one_minus * one_minus / (-std::expm1(-4.0 * x) + 2.0 * x * decay);
}

/// cosh 2x - 1 - 2x^2 = 2 (sinh x - x)(sinh x + x), by its series where the
/// difference would suffer from cancellation.
double pressure_denominator(double x) {
  if (x > 0.5)
    return 2.0 * (std::sinh(x) - x) * (std::sinh(x) + x);
  double term = x * x * x / 6.0;
  double difference = 0.0;
  for (int n = 4; term > 1e-18 * difference; n += 2) {
    difference += term;
    term *= x * x / (n * (n + 1));
  }
  return 2.0 * difference * (std::sinh(x) + x);
}

double pressure_factor(double x) {
  if (x > 20.0) { // the neglected terms exp(-4x) are below roundoff
    const double decay = 2.0 * std::exp(-2.0 * x);
    return (1.0 + 2.0 * x * decay) / (1.0 - (1.0 + 2.0 * x * x) * decay);
  }
  return (std::sinh(2.0 * x) + 2.0 * x) / pressure_denominator(x);
}

} // namespace

double slab_compliance_factor(double reduced_wavevector,
                              mechanics::FarBoundary far_boundary,
                              double poisson_ratio) {
  require_positive("reduced_wavevector", reduced_wavevector, "1");
  require_between("poisson_ratio", poisson_ratio, -1.0, 0.5, "1");
  switch (far_boundary) {
  case mechanics::FarBoundary::clamped:
    return clamped_factor(reduced_wavevector, poisson_ratio);
  case mechanics::FarBoundary::sliding:
    return sliding_factor(reduced_wavevector);
  case mechanics::FarBoundary::pressure:
    return pressure_factor(reduced_wavevector);
  }
  return 1.0;
}

namespace {

/// C(q) of a block without layers [m/Pa].
double uniform_compliance(double wavevector,
                          const mechanics::ElasticBlock& block) {
  const double factor =
      std::isinf(block.thickness)
          ? 1.0
          : slab_compliance_factor(wavevector * block.thickness,
                                   block.far_boundary, block.poisson_ratio);
  return 2.0 * factor / (block.contact_modulus * wavevector);
}

} // namespace

std::function<double(double)>
compliance_function(const mechanics::ElasticBlock& block) {
  require_positive("contact_modulus", block.contact_modulus, "Pa");
  if (!(block.thickness > 0.0))
    refuse_argument("thickness", block.thickness, "> 0 [m], or infinite");
  if (block.layers.empty())
    return [block](double q) { return uniform_compliance(q, block); };
  return [stack = LayerStack(block)](double q) { return stack.compliance(q); };
}

EvenColumn compliance_column(const Grid& grid,
                             const mechanics::ElasticBlock& block) {
  return [grid, compliance = compliance_function(block)](
             int jx, std::span<double> of_jy) {
    for (std::size_t jy = jx == 0 ? 1 : 0; jy < of_jy.size(); ++jy)
      of_jy[jy] = compliance(wavevector_size(grid, jx, static_cast<int>(jy)));
  };
}

FourierOperator halfspace_operator(const Grid& grid,
                                   const mechanics::ElasticBlock& block,
                                   int threads) {
  return FourierOperator(grid, compliance_column(grid, block), threads);
}

} // namespace asperity::contact
