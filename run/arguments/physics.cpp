#include "run/arguments/physics.hpp"

#include "base/plain_text.hpp"
#include "input/input_error.hpp"

#include <fmt/format.h>

#include <string_view>

namespace asperity::run {

double positive_quantity(const std::string& option, const std::string& text,
                         input::Dimension dimension) {
  const input::ValueReading read = input::read_with_unit(text, dimension);
  if (!read.value)
    throw input::InputError(
        fmt::format("{} = \"{}\" {}", option, printable(text), read.mistake));
  if (!(*read.value > 0.0))
    throw input::InputError(fmt::format("{} = \"{}\", but must be > 0 [{}]",
                                        option, text,
                                        input::si_unit(dimension)));
  return *read.value;
}

std::string length_unit_text(const std::string& option,
                             const std::string& unit) {
  const bool has_number =
      unit.empty() || std::string_view("0123456789.+-").find(unit.front()) !=
                          std::string_view::npos;
  std::string text = has_number ? unit : "1 " + unit;
  (void)positive_quantity(option, text, input::Dimension::length);
  return text;
}

} // namespace asperity::run
