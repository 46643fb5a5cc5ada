#include "run/methods/continuum_block.hpp"

#include "contact/operators/layered_compliance.hpp"

#include <numbers>

namespace asperity::methods {
namespace {

/// Returns E* of the block without its counterface [Pa].
double own_modulus(const mechanics::MaterialSpec& material) {
  const mechanics::BodyModuli own = material.first_body();
  return own.youngs_modulus / (1.0 - own.poisson_ratio * own.poisson_ratio);
}

} // namespace

mechanics::ElasticBlock continuum_of(const cases::MethodSpec& method,
                                     const mechanics::MaterialSpec& material,
                                     const mechanics::Scales& scales) {
  mechanics::ElasticBlock block = mechanics::halfspace(0.0, method.border());
  if (const auto* half =
          std::get_if<mechanics::HalfspaceSettings>(&method.settings))
    block = half->block(scales);
  block.contact_modulus = material.contact_modulus;
  block.poisson_ratio = material.poisson_ratio.value_or(0.0);
  if (const auto* fem = std::get_if<mechanics::FemSettings>(&method.settings)) {
    block.thickness = fem->block.depth.in_si(scales);
    block.far_boundary = fem->block.far_boundary;
  }
  if (!method.uses_layers())
    return block;
  if (!material.layers.empty())
    block.contact_modulus = own_modulus(material);
  for (const mechanics::MaterialLayer& layer : material.layers)
    block.layers.push_back({layer.thickness.in_si(scales),
                            layer.moduli.youngs_modulus,
                            layer.moduli.poisson_ratio});
  return block;
}

double boundary_modulus(const mechanics::ElasticBlock& block, double spacing) {
  if (block.layers.empty())
    return block.contact_modulus;
  const double wavevector = 0.5 * std::numbers::pi / spacing;
  return 2.0 / (contact::layered_compliance(wavevector, block) * wavevector);
}

} // namespace asperity::methods
