#include "theory/persson/gap_distribution.hpp"

#include "base/require.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace asperity::theory {

GapDistribution::GapDistribution(MagnifiedContact contact)
    : contact_(std::move(contact)) {
  if (!contact_.contact().spectrum().has_density())
    refuse_argument("number of shells", 1.0,
                    "0: the spectrum must be a formula");
}

double GapDistribution::contact_weight() const {
  return contact_.area_fraction(contact_.highest_magnification());
}

// u_1 falls from infinity to 0 between zeta_0 and zeta_1, by hundreds of orders
// of magnitude at both ends; therefore the root is computed in logarithms.
double GapDistribution::magnification(double gap) const {
  require_positive("gap", gap, "m");
  const double beyond = 700.0;
  const auto excess = [&](double log_magnification) {
    const double found = contact_.opening_gap(std::exp(log_magnification));
    return std::clamp(std::log(found / gap), -beyond, beyond);
  };
  const double low = std::log(contact_.lowest_magnification());
  const double high = std::log(contact_.highest_magnification());
  std::uintmax_t steps = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, low, high, beyond, -beyond,
      boost::math::tools::eps_tolerance<double>(50), steps);
  return std::exp(0.5 * (bracket.first + bracket.second));
}

double GapDistribution::cumulative(double gap) const {
  return contact_.area_fraction(magnification(gap));
}

double GapDistribution::density(double gap) const {
  return contact_.gap_density(magnification(gap));
}

} // namespace asperity::theory
