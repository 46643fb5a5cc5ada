#include "base/require.hpp"

#include "base/refused_argument.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace asperity {

std::string number_text(double value) {
  return fmt::format("{}", value);
}

std::string number_text(double value, double limit, int digits) {
  constexpr int all_digits = 17;
  for (; digits < all_digits && value != limit; ++digits) {
    std::string text = fmt::format("{:.{}g}", value, digits);
    if (text != fmt::format("{:.{}g}", limit, digits))
      return text;
  }
  return fmt::format("{:.{}g}", value, digits);
}

RefusedArgument::RefusedArgument(const std::string& name_, double value_,
                                 std::string range_, std::string key_)
    : std::domain_error(fmt::format("{} = {}, but must be {}", name_,
                                    number_text(value_), range_)),
      name(name_),
      value(value_),
      range(std::move(range_)),
      key(std::move(key_)) {}

void refuse_argument(const std::string& name, double value,
                     const std::string& range) {
  throw RefusedArgument(name, value, range);
}

void refuse_argument(const Argument& argument, double value,
                     const std::string& range) {
  throw RefusedArgument(argument.name, value, range, argument.key);
}

void require_positive(const char* name, double value, const char* unit) {
  require_positive(Argument{name, ""}, value, unit);
}

void require_positive(const Argument& argument, double value,
                      const char* unit) {
  if (!std::isfinite(value) || value <= 0.0)
    refuse_argument(argument, value, fmt::format("finite and > 0 [{}]", unit));
}

void require_not_negative(const char* name, double value, const char* unit) {
  if (!std::isfinite(value) || value < 0.0)
    refuse_argument(name, value, fmt::format("finite and >= 0 [{}]", unit));
}

void require_between(const char* name, double value, double low, double high,
                     const char* unit) {
  require_between(Argument{name, ""}, value, low, high, unit);
}

void require_between(const Argument& argument, double value, double low,
                     double high, const char* unit) {
  if (!(value >= low && value <= high))
    refuse_argument(argument, value,
                    fmt::format("between {} and {} [{}]",
                                number_text(low, value, 6),
                                number_text(high, value, 6), unit));
}

} // namespace asperity
