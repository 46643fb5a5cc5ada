#include "mechanics/quantity.hpp"

#include "base/require.hpp"

#include <stdexcept>

namespace asperity::mechanics {
namespace {

double known(const char* name, double scale, const char* unit) {
  require_positive(name, scale, unit);
  return scale;
}

} // namespace

double Quantity::in_si(const Scales& scales) const {
  switch (reference) {
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
  throw std::domain_error("reference is none of the known ones");
}

} // namespace asperity::mechanics
