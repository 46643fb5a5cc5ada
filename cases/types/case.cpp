#include "cases/types/case.hpp"

#include "base/require.hpp"

#include <stdexcept>

namespace asperity::cases {
namespace {

double known(const char* name, double scale, const char* unit) {
  require_positive(name, scale, unit);
  return scale;
}

} // namespace

double Quantity::in_si(const Scales& scales) const {
  switch (yardstick) {
  case ReferenceUnit::si:
    return value;
  case ReferenceUnit::contact_modulus:
    return value * known("contact_modulus", scales.contact_modulus, "Pa");
  case ReferenceUnit::length:
    return value * known("length", scales.length, "m");
  case ReferenceUnit::spacing:
    return value * known("spacing", scales.spacing, "m");
  case ReferenceUnit::rms_height:
    return value * known("rms_height", scales.rms_height, "m");
  case ReferenceUnit::contact_modulus_per_spacing:
    return value * known("contact_modulus", scales.contact_modulus, "Pa") /
           known("spacing", scales.spacing, "m");
  case ReferenceUnit::contact_modulus_times_slope:
    return value * known("contact_modulus", scales.contact_modulus, "Pa") *
           known("rms_slope", scales.rms_slope, "1");
  }
  throw std::domain_error("yardstick is none of the known ones");
}

double MaterialSpec::block_youngs_modulus() const {
  require_positive("contact_modulus", contact_modulus, "Pa");
  if (!poisson_ratio)
    throw std::domain_error(
        "poisson_ratio is not known, but the block's Young's modulus needs it");
  return contact_modulus * (1.0 - *poisson_ratio * *poisson_ratio);
}

BodyModuli MaterialSpec::first_body() const {
  const double of_pair = block_youngs_modulus();
  const double ratio = *poisson_ratio;
  if (!counter)
    return {of_pair, ratio};
  const double share = (1.0 - counter->poisson_ratio * counter->poisson_ratio) /
                       counter->youngs_modulus;
  return {(1.0 - ratio * ratio) / (1.0 / contact_modulus - share), ratio};
}

const MethodSpec* study_theory(const std::vector<MethodSpec>& methods) {
  for (const MethodSpec& method : methods)
    if (const auto* theory = std::get_if<TheorySettings>(&method.settings);
        theory && theory->spectrum == TheorySpectrum::formula)
      return &method;
  return nullptr;
}

} // namespace asperity::cases
