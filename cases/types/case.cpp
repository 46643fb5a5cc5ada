#include "cases/types/case.hpp"

namespace asperity::cases {

const MethodSpec* study_theory(const std::vector<MethodSpec>& methods) {
  for (const MethodSpec& method : methods)
    if (const auto* theory =
            std::get_if<mechanics::TheorySettings>(&method.settings);
        theory && theory->spectrum == mechanics::TheorySpectrum::formula &&
        theory->loss_factor == mechanics::LossFactor::yang_persson)
      return &method;
  return nullptr;
}

} // namespace asperity::cases
