#include "studies/theory_quantities.hpp"

#include "base/special_numbers.hpp"

#include <cmath>

namespace asperity::studies {

using reports::Estimate;

Estimate without(const std::string& reason) {
  Estimate estimate;
  estimate.remark = reason;
  return estimate;
}

Estimate number(double value, const std::string& reason_if_none) {
  Estimate estimate;
  estimate.value = value;
  estimate.realizations = 1;
  estimate.remark = estimate.has_value() ? "from the formula" : reason_if_none;
  return estimate;
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
