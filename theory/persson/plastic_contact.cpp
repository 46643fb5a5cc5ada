#include "theory/persson/plastic_contact.hpp"

#include "base/require.hpp"
#include "theory/persson/pressure_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::theory {
namespace {

using std::numbers::pi;

/// G/H^2 from which on ten terms of the series give all digits; below it the
/// images of six intervals do.
constexpr double series_from = 0.05;
constexpr int n_terms = 10;
constexpr int n_images = 6;

PlasticShares shares_by_series(double x, double reduced) {
  PlasticShares shares{0.0, x};
  for (int n = 1; n <= n_terms; ++n) {
    const double term = 2.0 / (n * pi) * std::sin(n * pi * x) *
                        std::exp(-n * n * pi * pi * reduced);
    shares.elastic += n % 2 == 1 ? 2.0 * term : 0.0;
    shares.plastic += n % 2 == 1 ? -term : term;
  }
  return shares;
}

/// Each boundary absorbs what reaches it before the other one.
PlasticShares shares_by_images(double x, double reduced) {
  const double width = 2.0 * std::sqrt(reduced);
  double open = 0.0;
  double plastic = 0.0;
  for (int k = 0; k < n_images; ++k) {
    open += std::erfc((2 * k + x) / width) - std::erfc((2 * k + 2 - x) / width);
    plastic +=
        std::erfc((2 * k + 1 - x) / width) - std::erfc((2 * k + 1 + x) / width);
  }
  return {std::max(0.0, 1.0 - open - plastic), plastic};
}

} // namespace

PlasticShares plastic_shares(double nominal_pressure, double variance,
                             double hardness) {
  if (std::isinf(hardness) && hardness > 0.0)
    return {area_fraction(nominal_pressure, variance), 0.0};
  require_positive("variance", variance, "Pa^2");
  if (!(hardness > 0.0))
    refuse_argument("hardness", hardness, "> 0 [Pa]");
  require_between("nominal_pressure", nominal_pressure, 0.0, hardness, "Pa");
  const double x = nominal_pressure / hardness;
  const double reduced = variance / (hardness * hardness);
  return reduced > series_from ? shares_by_series(x, reduced)
                               : shares_by_images(x, reduced);
}

} // namespace asperity::theory
