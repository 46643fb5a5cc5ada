#include "cases/types/case.hpp"

namespace asperity::cases {

const MethodSpec* study_theory(const mechanics::SurfaceSpec& surface,
                               const std::vector<MethodSpec>& methods) {
  const bool is_measured = surface.kind == mechanics::SurfaceKind::measured;
  for (const MethodSpec& method : methods)
    if (const auto* theory =
            std::get_if<mechanics::TheorySettings>(&method.settings);
        theory &&
        (is_measured ||
         theory->spectrum == mechanics::TheorySpectrum::formula) &&
        theory->loss_factor == mechanics::LossFactor::yang_persson)
      return &method;
  return nullptr;
}

bool has_partial_slip(const MethodSpec& method,
                      const mechanics::MaterialSpec& material) {
  if (!material.is_uniform() || method.is_adhesive() || method.hardness())
    return false;
  const auto* half =
      std::get_if<mechanics::HalfspaceSettings>(&method.settings);
  return half != nullptr ? !half->thickness.has_value()
                         : std::holds_alternative<mechanics::TheorySettings>(
                               method.settings);
}

} // namespace asperity::cases
