// Reads any bytes as reference.csv: the result is lines with a quantity and a
// source, or an InputError.
#include "input/input_error.hpp"
#include "input/types/reference.hpp"
#include "tests/fuzz/fuzz_target.hpp"

#include <cmath>

namespace asperity::fuzz {

void read_input(const std::string& bytes) {
  try {
    for (const cases::ReferenceValue& value :
         cases::read_reference_text(bytes, "reference.csv")) {
      require(!value.quantity.empty() && !value.source.empty(),
              "each line has a quantity and a source");
      require(std::isfinite(value.value) && value.uncertainty >= 0.0,
              "values are finite, uncertainties not negative");
    }
  } catch (const input::InputError&) {
  }
}

} // namespace asperity::fuzz
