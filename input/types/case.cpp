#include "input/types/case.hpp"

namespace asperity::cases {

const MethodSpec* study_theory(const mechanics::SurfaceSpec& surface,
                               const std::vector<MethodSpec>& methods) {
  const bool is_measured = surface.kind == mechanics::SurfaceKind::measured;
  for (const MethodSpec& method : methods)
    if (const auto* theory = method.as<mechanics::TheorySettings>();
        theory &&
        (is_measured ||
         theory->spectrum == mechanics::TheorySpectrum::formula) &&
        theory->loss_factor == mechanics::LossFactor::yang_persson)
      return &method;
  return nullptr;
}

std::string obstacle_to_partial_slip(const MethodSpec& method,
                                     const mechanics::MaterialSpec& material) {
  const auto* half = method.as<mechanics::HalfspaceSettings>();
  if (half == nullptr &&
      !std::holds_alternative<mechanics::TheorySettings>(method.settings))
    return "needs a [halfspace] or a [theory]";
  if (half != nullptr && half->thickness)
    return "needs a half-space without thickness";
  if (method.is_adhesive())
    return "needs a contact without adhesion";
  if (method.hardness())
    return "needs a contact without hardness";
  return material.is_uniform() ? "" : "needs a uniform material";
}

bool has_partial_slip(const MethodSpec& method,
                      const mechanics::MaterialSpec& material) {
  return obstacle_to_partial_slip(method, material).empty();
}

} // namespace asperity::cases
