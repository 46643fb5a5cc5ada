#include "theory/persson/gap_kernel.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <numbers>

namespace asperity::theory {
namespace {

using Gauss = boost::math::quadrature::gauss<double, 30>;
using Series = SmallPressureSeries;

constexpr double euler_gamma = std::numbers::egamma;

// erf^2(t) e^{-t^2} = sum_n c_n t^{2n} from
// erf(t) = (2/sqrt pi) e^{-t^2} sum_n 2^n t^{2n+1}/(2n+1)!!.
Series::Coefficients weighted_erf_squared() {
  Series::Coefficients odd{}, product{}, result{};
  odd[0] = 1.0;
  for (std::size_t n = 1; n < odd.size(); ++n)
    odd[n] = odd[n - 1] * 2.0 / (2.0 * static_cast<double>(n) + 1.0);
  for (std::size_t i = 0; i < odd.size(); ++i)
    for (std::size_t j = 0; i + j + 1 < product.size(); ++j)
      product[i + j + 1] += 4.0 / std::numbers::pi * odd[i] * odd[j];
  for (std::size_t i = 0; i < product.size(); ++i) {
    double exponential = 1.0; // coefficient of the series of e^{-3 t^2}
    for (std::size_t j = 0; i + j < result.size(); ++j) {
      result[i + j] += product[i] * exponential;
      exponential *= -3.0 / static_cast<double>(j + 1);
    }
  }
  return result;
}

Series make_small_pressure_series() {
  Series series;
  const Series::Coefficients erf_squared = weighted_erf_squared();
  series.gap_linear[0] = -0.5 * euler_gamma;
  series.gap_cubic[0] = cubic_energy_constant();
  series.slope_linear[0] = 1.0;
  for (std::size_t n = 1; n < series.gap_linear.size(); ++n) {
    const double order = static_cast<double>(n);
    series.slope_linear[n] = -series.slope_linear[n - 1] / order;
    series.slope_cubic[n] = 3.0 * erf_squared[n];
    series.gap_linear[n] = -series.slope_linear[n] / (2.0 * order);
    series.gap_cubic[n] = -series.slope_cubic[n] / (2.0 * order);
  }
  return series;
}

GammaParts from_series(double x) {
  const Series& series = small_pressure_series();
  const double y = x * x;
  GammaParts sum;
  for (std::size_t n = Series::n_terms; n-- > 0;) {
    sum.linear = sum.linear * y + series.gap_linear[n];
    sum.cubic = sum.cubic * y + series.gap_cubic[n];
  }
  sum.linear -= std::log(x);
  return sum;
}

// x^2 e^{x^2} J(x), a smooth function of order one: with v = t^2 - x^2,
// e^{x^2} J = (1/2) int_0^inf [gamma + 3 (1 - gamma) erf^2 t] e^{-v} dv/t^2.
GammaParts scaled_kernel(double x) {
  const double cut_off = 63.0; // e^{-63} = 4e-28
  GammaParts sum;
  for (double low = 0.0; low < cut_off; low = 2.0 * low + 1.0) {
    const double high = 2.0 * low + 1.0;
    sum.linear += Gauss::integrate(
        [x](double v) { return std::exp(-v) / (x * x + v); }, low, high);
    sum.cubic += Gauss::integrate(
        [x](double v) {
          const double root = std::erf(std::sqrt(x * x + v));
          return 3.0 * root * root * std::exp(-v) / (x * x + v);
        },
        low, high);
  }
  return {0.5 * x * x * sum.linear, 0.5 * x * x * sum.cubic};
}

// x^2 e^{x^2} J on octaves limit * 2^k, by Chebyshev interpolation.
class OctaveTable {
public:
  static constexpr int n_octaves = 4;
  static constexpr int n_terms = 26;
  static constexpr double high = Series::limit * (1 << n_octaves);

  OctaveTable() {
    double low = Series::limit;
    for (Octave& octave : octaves_) {
      fill(octave, low);
      low *= 2.0;
    }
  }

  GammaParts operator()(double x) const {
    std::size_t k = 0;
    double low = Series::limit;
    for (; x > 2.0 * low && k + 1 < octaves_.size(); ++k)
      low *= 2.0;
    const Octave& octave = octaves_[k];
    const double t = 2.0 * (x - low) / low - 1.0; // -1..1
    GammaParts one, two;                          // Clenshaw's b_{n+1}, b_{n+2}
    for (std::size_t n = n_terms - 1; n > 0; --n) {
      const double linear = octave.linear[n] + 2.0 * t * one.linear;
      const double cubic = octave.cubic[n] + 2.0 * t * one.cubic;
      const GammaParts next{linear - two.linear, cubic - two.cubic};
      two = one;
      one = next;
    }
    return {octave.linear[0] + t * one.linear - two.linear,
            octave.cubic[0] + t * one.cubic - two.cubic};
  }

private:
  struct Octave {
    std::array<double, n_terms> linear{};
    std::array<double, n_terms> cubic{};
  };

  static void fill(Octave& octave, double low) {
    for (int node = 0; node < n_terms; ++node) {
      const double angle = std::numbers::pi * (node + 0.5) / n_terms;
      const double x = low + 0.5 * low * (1.0 + std::cos(angle));
      const GammaParts at_node = scaled_kernel(x);
      for (std::size_t n = 0; n < n_terms; ++n) {
        const double factor = (n == 0 ? 1.0 : 2.0) / n_terms *
                              std::cos(static_cast<double>(n) * angle);
        octave.linear[n] += factor * at_node.linear;
        octave.cubic[n] += factor * at_node.cubic;
      }
    }
  }

  std::array<Octave, n_octaves> octaves_;
};

// x^2 e^{x^2} J/(gamma + 3 (1 - gamma)) = (1/2) sum_n n! (-1/x^2)^n: here erf
// is 1 to roundoff, and term 12 is below 1e-16 for x > 11.3.
double scaled_asymptote(double x) {
  const double ratio = -1.0 / (x * x);
  double sum = 1.0;
  for (int n = 12; n > 0; --n)
    sum = 1.0 + n * ratio * sum;
  return 0.5 * sum;
}

} // namespace

double cubic_energy_constant() {
  static const double constant =
      12.0 / std::numbers::pi *
      Gauss::integrate([](double t) { return std::atan(std::tanh(t)); }, 0.0,
                       std::asinh(1.0));
  return constant;
}

const SmallPressureSeries& small_pressure_series() {
  static const SmallPressureSeries series = make_small_pressure_series();
  return series;
}

GammaParts gap_kernel(double reduced_pressure) {
  const double x = reduced_pressure;
  if (x <= Series::limit)
    return from_series(x);
  const double scale = std::exp(-x * x) / (x * x);
  if (x > OctaveTable::high) {
    const double asymptote = scaled_asymptote(x);
    return {scale * asymptote, 3.0 * scale * asymptote};
  }
  static const OctaveTable table;
  const GammaParts scaled = table(x);
  return {scale * scaled.linear, scale * scaled.cubic};
}

GammaParts gap_kernel_slope(double reduced_pressure) {
  const double x = reduced_pressure;
  const double gaussian = std::exp(-x * x);
  const double probability = std::erf(x);
  return {gaussian, 3.0 * probability * probability * gaussian};
}

GammaParts gap_kernel_slope_rate(double reduced_pressure) {
  const double x = reduced_pressure;
  const GammaParts slope = gap_kernel_slope(x);
  const double growth =
      12.0 / std::sqrt(std::numbers::pi) * x * std::erf(x) * slope.linear;
  return {-2.0 * x * x * slope.linear,
          -2.0 * x * x * slope.cubic + growth * slope.linear};
}

} // namespace asperity::theory
