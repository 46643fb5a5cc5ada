#include "base/require.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace asperity {

void refuse_argument(const std::string& name, double value,
                     const std::string& range) {
  throw std::domain_error(
      fmt::format("{} = {:.6g}, but must be {}", name, value, range));
}

void require_positive(const char* name, double value, const char* unit) {
  if (!std::isfinite(value) || value <= 0.0)
    refuse_argument(name, value, fmt::format("finite and > 0 [{}]", unit));
}

void require_not_negative(const char* name, double value, const char* unit) {
  if (!std::isfinite(value) || value < 0.0)
    refuse_argument(name, value, fmt::format("finite and >= 0 [{}]", unit));
}

void require_between(const char* name, double value, double low, double high,
                     const char* unit) {
  if (!(value >= low && value <= high))
    refuse_argument(
        name, value,
        fmt::format("between {:.6g} and {:.6g} [{}]", low, high, unit));
}

} // namespace asperity
