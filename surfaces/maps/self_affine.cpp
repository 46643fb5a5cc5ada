#include "surfaces/maps/self_affine.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace asperity::surfaces {
namespace {

void require_shape(const SelfAffineShape& shape) {
  constexpr double largest = std::numeric_limits<double>::max();
  require_between("hurst", shape.hurst, 0.0, 1.0, "1");
  require_positive("wavevector_low", shape.wavevector_low, "rad/m");
  require_between("wavevector_roll_off", shape.wavevector_roll_off,
                  shape.wavevector_low, largest, "rad/m");
  require_between("wavevector_high", shape.wavevector_high,
                  shape.wavevector_roll_off, largest, "rad/m");
  if (shape.wavevector_high == shape.wavevector_low)
    refuse_argument("wavevector_high", shape.wavevector_high,
                    "above wavevector_low: a band of zero width has no power");
}

} // namespace

SelfAffineSpectrum::SelfAffineSpectrum(const SelfAffineShape& shape,
                                       double plateau)
    : shape_(shape), plateau_(plateau) {}

SelfAffineSpectrum
SelfAffineSpectrum::with_rms_height(const SelfAffineShape& shape,
                                    double rms_height) {
  require_shape(shape);
  require_positive("rms_height", rms_height, "m");
  const SelfAffineSpectrum unit(shape, 1.0);
  return {shape, rms_height * rms_height / unit.moment(0)};
}

SelfAffineSpectrum
SelfAffineSpectrum::with_rms_slope(const SelfAffineShape& shape,
                                   double rms_slope) {
  require_shape(shape);
  require_positive("rms_slope", rms_slope, "1");
  const SelfAffineSpectrum unit(shape, 1.0);
  return {shape, rms_slope * rms_slope / unit.moment(2)};
}

double SelfAffineSpectrum::operator()(double wavevector) const {
  if (!is_in_band(wavevector, shape_.wavevector_low, shape_.wavevector_high))
    return 0.0;
  if (wavevector <= shape_.wavevector_roll_off)
    return plateau_;
  return plateau_ * std::pow(wavevector / shape_.wavevector_roll_off,
                             -2.0 - 2.0 * shape_.hurst);
}

double SelfAffineSpectrum::moment(int order) const {
  const double flat = power_law_integral(order, 0.0, shape_.wavevector_low,
                                         shape_.wavevector_roll_off);
  const double self_affine =
      power_law_integral(order, -2.0 - 2.0 * shape_.hurst,
                         shape_.wavevector_roll_off, shape_.wavevector_high);
  return 2.0 * std::numbers::pi * plateau_ * (flat + self_affine);
}

double SelfAffineSpectrum::rms_height() const {
  return std::sqrt(moment(0));
}

double SelfAffineSpectrum::rms_slope() const {
  return std::sqrt(moment(2));
}

double SelfAffineSpectrum::rms_curvature() const {
  return 0.5 * std::sqrt(moment(4));
}

IsotropicSpectrum SelfAffineSpectrum::isotropic() const {
  std::vector<double> kinks{shape_.wavevector_low, shape_.wavevector_roll_off,
                            shape_.wavevector_high};
  kinks.erase(std::unique(kinks.begin(), kinks.end()), kinks.end());
  return {*this, std::move(kinks), moment(0), moment(2)};
}

} // namespace asperity::surfaces
