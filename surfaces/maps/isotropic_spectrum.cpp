#include "surfaces/maps/isotropic_spectrum.hpp"

#include <cmath>

namespace asperity::surfaces {

double power_law_integral(int order, double exponent, double start,
                          double end) {
  // start^(order+2) int_1^{end/start} t^(s-1) dt with s = order + 2 + exponent
  const double power = order + 2 + exponent;
  const double logarithm = std::log(end / start);
  const double reduced =
      power == 0.0 ? logarithm : std::expm1(power * logarithm) / power;
  // Products, because the roundoff of std::pow depends on the unit of length.
  double weight = 1.0;
  for (int factor = 0; factor < order + 2; ++factor)
    weight *= start;
  return weight * reduced;
}

} // namespace asperity::surfaces
