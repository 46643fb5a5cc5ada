#include "app/asked/option_quantity.hpp"

#include "input/input_error.hpp"

#include <fmt/format.h>

namespace asperity::app {

double positive_quantity(const std::string& option, const std::string& text,
                         cases::Dimension dimension) {
  const cases::QuantityReading read = cases::read_quantity(text, dimension, {});
  if (!read.quantity)
    throw input::InputError(
        fmt::format("{} = \"{}\" {}", option, text, read.mistake));
  if (!(read.quantity->value > 0.0))
    throw input::InputError(fmt::format("{} = \"{}\", but must be > 0 [{}]",
                                        option, text,
                                        cases::si_unit(dimension)));
  return read.quantity->value;
}

} // namespace asperity::app
