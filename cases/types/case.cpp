#include "cases/types/case.hpp"

namespace asperity::cases {

const MethodSpec* study_theory(const std::vector<MethodSpec>& methods) {
  for (const MethodSpec& method : methods)
    if (const auto* theory =
            std::get_if<mechanics::TheorySettings>(&method.settings);
        theory && theory->spectrum == mechanics::TheorySpectrum::formula)
      return &method;
  return nullptr;
}

} // namespace asperity::cases
