#include "run/arguments/option_quantity.hpp"

#include "input/input_error.hpp"

#include <fmt/format.h>

namespace asperity::run {

double positive_quantity(const std::string& option, const std::string& text,
                         cases::Dimension dimension) {
  const cases::QuantityReading read = cases::read_quantity(text, dimension, {});
  // The case reader's advice for a number without unit is on quotes, which a
  // shell has removed.
  if (!read.quantity && read.mistake.starts_with("has no unit")) {
    std::string forms;
    for (const std::string& unit : cases::unit_symbols(dimension, {}))
      forms +=
          fmt::format("{}\"{} {}\"", forms.empty() ? "" : " or ", text, unit);
    throw input::InputError(
        fmt::format("{} = \"{}\" has no unit; write {}", option, text, forms));
  }
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
