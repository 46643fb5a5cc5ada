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

double tangential_anisotropy(const MaterialSpec& material) {
  const auto own = [](const BodyModuli& body) {
    return normal_compliance(body) * body.poisson_ratio /
           (1.0 - body.poisson_ratio);
  };
  double sum = own(material.first_body());
  if (material.counter)
    sum += own(*material.counter);
  return sum * material.contact_modulus;
}

PartialSlip partial_slip(std::span<const NormalContact> path,
                         double coefficient) {
  const double mu = coefficient;
  const NormalContact& pressed = path.back();
  const NormalContact& eased = path.front();
  // The integrals of kappa dD and of kappa (P - P'') dD.
  Directions shift, work;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const NormalContact& low = path[i];
    const NormalContact& high = path[i + 1];
    const double approach = high.approach - low.approach;
    const double done = pressed.pressure * approach -
                        (high.elastic_energy - low.elastic_energy);
    const double bend = (high.pressure - low.pressure) * approach / 12.0;
    for (double Directions::*const along : {&Directions::x, &Directions::y}) {
      const double mean = 0.5 * (low.ratio.*along + high.ratio.*along);
      const double change = high.ratio.*along - low.ratio.*along;
      shift.*along += mean * approach;
      work.*along += mean * done - change * bend;
    }
  }
  const double stress = mu * (pressed.pressure - eased.pressure);
  const auto loss = [=](double own_work, double own_shift) {
    return 8.0 * mu * mu * own_work - 4.0 * stress * mu * own_shift;
  };
  return {
      .tangential_stress = stress,
      .displacement = {mu * shift.x, mu * shift.y},
      .stick_area = eased.area_fraction,
      .slip_area = pressed.area_fraction - eased.area_fraction,
      .loss = {loss(work.x, shift.x), loss(work.y, shift.y)},
  };
}

} // namespace asperity::mechanics
