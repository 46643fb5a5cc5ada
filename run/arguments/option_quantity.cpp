#include "run/arguments/option_quantity.hpp"

#include "input/input_error.hpp"

#include <fmt/format.h>

namespace asperity::run {

double positive_quantity(const std::string& option, const std::string& text,
                         cases::Dimension dimension) {
  const cases::QuantityReading read = cases::read_quantity(text, dimension, {});
  // The case reader's advice for a number without unit is on quotes, which a
  // shell has removed.
  if (!read.quantity && read.mistake.starts_with("has no unit"))
    throw input::InputError(
        fmt::format("{0} = \"{1}\" has no unit; write \"{1} {2}\"", option,
                    text, cases::si_unit(dimension)));
  if (!read.quantity)
    throw input::InputError(
        fmt::format("{} = \"{}\" {}", option, text, read.mistake));
  if (!(read.quantity->value > 0.0))
    throw input::InputError(fmt::format("{} = \"{}\", but must be > 0 [{}]",
                                        option, text,
                                        cases::si_unit(dimension)));
  return read.quantity->value;
}

} // namespace asperity::run
