#include "studies/theory_quantities.hpp"

#include "base/special_numbers.hpp"

#include <cmath>

namespace asperity::studies {

cases::ExpectationName quantity_of_theory(const char* name,
                                          const char* description,
                                          const char* study,
                                          cases::QuantityOf of) {
  return {.name = name,
          .description = description,
          .theory_answers = true,
          .theory_only = true,
          .study = study,
          .of = of};
}

double between_rows(const std::vector<double>& x, const std::vector<double>& y,
                    double at) {
  for (std::size_t i = 0; i < x.size() && i < y.size(); ++i) {
    if (x[i] == at)
      return y[i];
    if (i + 1 < y.size() && x[i] < at && at < x[i + 1]) {
      const double part = std::log(at / x[i]) / std::log(x[i + 1] / x[i]);
      return y[i] * std::pow(y[i + 1] / y[i], part);
    }
  }
  return not_a_number;
}

bool is_study_theory(const cases::Case& contact_case,
                     const results::MethodRecord& method) {
  const cases::MethodSpec* studied =
      cases::study_theory(contact_case.surface, contact_case.methods);
  return studied != nullptr && studied->name == method.name;
}

} // namespace asperity::studies
