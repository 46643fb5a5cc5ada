#include "cases/quantity_at_load.hpp"

#include "cases/nearest.hpp"
#include "cases/units.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::cases {
namespace {

std::string without_blanks(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos
             ? ""
             : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

QuantityAtLoadReading refused(const std::string& mistake) {
  return {std::nullopt, mistake};
}

} // namespace

const std::vector<ExpectationName>& quantities_at_load() {
  static const std::vector<ExpectationName> names = {
      {.name = "area_fraction",
       .description = "A/A_0 as counted; the theory's (4) [1].",
       .theory_answers = true},
      {.name = "area_fraction_corrected",
       .description = "A/A_0, the method's best estimate [1].",
       .theory_answers = true},
      {.name = "area_fraction_fit",
       .description =
           "A/A_0 by (21) of (20) fitted to the pressure distribution [1]."},
      {.name = "area_fraction_moment",
       .description = "A/A_0 by (21) of the pressure's second moment [1]."},
      {.name = "area_excess",
       .description = "Counted area over theory's, minus 1 [1].",
       .needs_theory = true},
      {.name = "area_excess_fit",
       .description = "Area by (21) of the fit over theory's, minus 1 [1].",
       .needs_theory = true},
      {.name = "reduced_mean_gap",
       .description = "u / h_rms [1].",
       .theory_answers = true},
  };
  return names;
}

bool names_a_load(const std::string& name) {
  return name.find('@') != std::string::npos;
}

QuantityAtLoadReading read_quantity_at_load(const std::string& name) {
  const auto at = name.find('@');
  const auto equals = name.find('=', at);
  if (at == std::string::npos || equals == std::string::npos ||
      without_blanks(name.substr(at + 1, equals - at - 1)) != "p")
    return refused("must be spelt as area_fraction@p=0.01 E* is");
  const std::string quantity = without_blanks(name.substr(0, at));
  std::vector<std::string> known;
  for (const ExpectationName& entry : quantities_at_load())
    known.push_back(entry.name);
  if (std::find(known.begin(), known.end(), quantity) == known.end())
    return refused(fmt::format("asks for {} at a load, which is not known; "
                               "nearest: {}",
                               quantity, nearest(quantity, known)));
  const QuantityReading load =
      read_quantity(name.substr(equals + 1), Dimension::pressure,
                    {Yardstick::contact_modulus});
  if (!load.quantity)
    return refused("has a p that " + load.mistake);
  if (!(load.quantity->value > 0.0))
    return refused("has a p that is not > 0");
  return {QuantityAtLoad{quantity, *load.quantity}, ""};
}

} // namespace asperity::cases
