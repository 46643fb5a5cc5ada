#include "theory/persson/opening_sums.hpp"

#include "theory/persson/gap_kernel.hpp"

#include <cmath>
#include <numbers>

namespace asperity::theory {
namespace {

// J and S = -dJ/dln x at one m.
struct Kernels {
  double gap = 0.0;
  double slope = 0.0;
};

// Adds `step` times the integrand of beta and its derivatives: with x ~ 1/m,
// d(J/m)/dln p = -S/m, and m^2 = M - M_z gives d(J/m)/dM_z = (J - S)/(2 m^3).
void add_closing(OpeningSums& sums, const Kernels& kernels, double root_moment,
                 double step) {
  const double m = root_moment;
  sums.closing += step * kernels.gap / m;
  sums.closing_rate -= step * kernels.slope / m;
  sums.closing_shift +=
      step * (kernels.gap - kernels.slope) / (2.0 * m * m * m);
}

} // namespace

OpeningSums opening_sums(const HeightSpectrum& hidden, double pressure_ratio,
                         double gamma) {
  const double root_pi = std::sqrt(std::numbers::pi);
  const auto reduced = [&](double m) { return pressure_ratio / (root_pi * m); };
  const auto kernels_at = [&](double x) {
    return Kernels{gap_kernel(x).at(gamma), gap_kernel_slope(x).at(gamma)};
  };
  OpeningSums sums;
  for (const RoughnessNode& node : hidden.nodes()) {
    const double x = reduced(node.root_moment);
    const double underflows = 27.5;
    if (x > underflows)
      break;
    const Kernels kernels = kernels_at(x);
    sums.mean_gap += node.weight * kernels.gap;
    sums.slope += node.weight * kernels.slope;
    sums.slope_rate += node.weight * gap_kernel_slope_rate(x).at(gamma);
    add_closing(sums, kernels, node.root_moment, node.inverse_step);
  }
  const double largest =
      hidden.rms_slope() / std::sqrt(2.0 * std::numbers::pi); // m_1
  add_closing(sums, kernels_at(reduced(largest)), largest,
              1.0 / hidden.wavevector_high());
  return sums;
}

} // namespace asperity::theory
