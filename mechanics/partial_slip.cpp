#include "mechanics/partial_slip.hpp"

namespace asperity::mechanics {
namespace {

double normal_compliance(const BodyModuli& body) {
  return (1.0 - body.poisson_ratio * body.poisson_ratio) / body.youngs_modulus;
}

/// (1 + nu)(1 - 2 nu)/E [1/Pa]
double coupling_compliance(const BodyModuli& body) {
  return (1.0 + body.poisson_ratio) * (1.0 - 2.0 * body.poisson_ratio) /
         body.youngs_modulus;
}

/// c kappa of one body [1/Pa]
double tangential_compliance(const BodyModuli& body) {
  return normal_compliance(body) * (2.0 - body.poisson_ratio) /
         (2.0 - 2.0 * body.poisson_ratio);
}

} // namespace

double tangential_ratio(const MaterialSpec& material) {
  double sum = tangential_compliance(material.first_body());
  if (material.counter)
    sum += tangential_compliance(*material.counter);
  return sum * material.contact_modulus;
}

double coupling(const MaterialSpec& material) {
  double difference = coupling_compliance(material.first_body());
  if (material.counter)
    difference -= coupling_compliance(*material.counter);
  return 0.5 * material.contact_modulus * difference;
}

PartialSlip partial_slip(const NormalContact& pressed,
                         const NormalContact& eased, const Friction& friction) {
  const double mu = friction.coefficient;
  const double approach = pressed.approach - eased.approach;
  const double energy = pressed.elastic_energy - eased.elastic_energy;
  return {
      .tangential_stress = mu * (pressed.pressure - eased.pressure),
      .displacement = mu * friction.ratio * approach,
      .stick_area = eased.area_fraction,
      .slip_area = pressed.area_fraction - eased.area_fraction,
      .loss = 4.0 * mu * mu * friction.ratio *
              ((pressed.pressure + eased.pressure) * approach - 2.0 * energy),
  };
}

} // namespace asperity::mechanics
