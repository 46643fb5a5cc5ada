#include "input/types/quantity_at_load.hpp"

#include "base/plain_text.hpp"
#include "input/nearest.hpp"
#include "input/types/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace asperity::cases {
namespace {

QuantityAtLoadReading refused_at_load(const std::string& mistake) {
  return {std::nullopt, mistake};
}

/// Returns the text after "@key =" in the given range of `name`, if the key
/// matches.
std::optional<std::string> value_of(const std::string& key,
                                    const std::string& name, std::size_t at,
                                    std::size_t end) {
  if (at == std::string::npos)
    return std::nullopt;
  const std::string clause = name.substr(at + 1, end - at - 1);
  const auto equals = clause.find('=');
  if (equals == std::string::npos || trimmed(clause.substr(0, equals)) != key)
    return std::nullopt;
  return clause.substr(equals + 1);
}

std::optional<double> positive_number(const std::optional<std::string>& text) {
  const std::string digits = trimmed(text.value_or(""));
  double number = 0.0;
  const char* const end = digits.data() + digits.size();
  const auto [rest, error] = std::from_chars(digits.data(), end, number);
  const bool is_good = error == std::errc{} && rest == end &&
                       std::isfinite(number) && number > 0.0;
  return is_good ? std::optional(number) : std::nullopt;
}

/// Returns the mistake in a name that should be one of `known`; "" if it is
/// correct.
std::string mistake_in_name(const std::string& quantity,
                            const std::vector<ExpectationName>& known) {
  std::vector<std::string> names;
  names.reserve(known.size());
  for (const ExpectationName& entry : known)
    names.push_back(entry.name);
  if (std::find(names.begin(), names.end(), quantity) != names.end())
    return "";
  return fmt::format(
      "asks for {} at a load, which is not a known quantity; nearest: {}",
      quantity, input::nearest(quantity, names));
}

} // namespace

const std::vector<ExpectationName>& quantities_at_load() {
  static const std::vector<ExpectationName> names = {
      {.name = "area_fraction",
       .description = "A/A_0 as counted; for theory, Eq. (4) of Yang and "
                      "Persson (2008) [1].",
       .theory_answers = true},
      {.name = "area_fraction_corrected",
       .description = "A/A_0, the best estimate of the method [1].",
       .theory_answers = true},
      {.name = "area_fraction_fit",
       .description = "A/A_0 by Eq. (21) of Yang and Persson (2008) from Eq. "
                      "(20) fitted to the pressure distribution [1]."},
      {.name = "area_fraction_moment",
       .description = "A/A_0 by Eq. (21) of Yang and Persson (2008) from the "
                      "second moment of the pressure [1]."},
      {.name = "area_excess",
       .description = "Counted area over that of theory, minus 1 [1].",
       .needs_theory = true},
      {.name = "area_excess_fit",
       .description = "Area by Eq. (21) of Yang and Persson (2008) from the "
                      "fit, over that of theory, minus 1 [1].",
       .needs_theory = true},
      {.name = "plastic_area",
       .description = "Area at the hardness; needs a hardness and a step at "
                      "this load [1].",
       .theory_answers = true},
      {.name = "reduced_mean_gap",
       .description = "u / h_rms [1].",
       .theory_answers = true},
      {.name = "log10_flow_factor",
       .description = "log10 of the flow factor, the mean of both directions; "
                      "needs [flow] and a step at this load [1].",
       .theory_answers = true},
      {.name = "leak_departure",
       .description = "log10 of the leak rate over that of theory, the mean of "
                      "both directions; needs [flow] and a step at this load "
                      "[1].",
       .needs_theory = true},
      {.name = "curve_stiffness_ratio",
       .description = "-dp/du of the curve over the stiffness of the standing "
                      "contact; needs [conductance] and a step at this load "
                      "[1]."},
      {.name = "spot_stiffness_ratio",
       .description = "Stiffness of the spots as circles alone over that of "
                      "the standing contact; needs [conductance], [spots] and "
                      "a step at this load [1]."},
      {.name = "theory_stiffness_ratio",
       .description = "-dp/du of theory over the stiffness of the standing "
                      "contact; needs [conductance] and a step at this load "
                      "[1].",
       .needs_theory = true},
  };
  return names;
}

const std::vector<ExpectationName>& quantities_at_magnification() {
  static const std::vector<ExpectationName> names = {
      {.name = "area_fraction",
       .description = "A(zeta)/A_0 [1].",
       .theory_answers = true,
       .theory_only = true,
       .study = Study::magnification},
      {.name = "reduced_mean_gap",
       .description = "u(zeta) / h_rms, with h_rms of the full surface [1].",
       .theory_answers = true,
       .theory_only = true,
       .study = Study::magnification},
      {.name = "mean_gap_ratio",
       .description = "u(zeta) divided by the mean gap u [1].",
       .theory_answers = true,
       .theory_only = true,
       .study = Study::magnification},
  };
  return names;
}

bool names_a_load(const std::string& name) {
  return name.find('@') != std::string::npos;
}

QuantityAtLoadReading read_quantity_at_load(const std::string& name) {
  const std::string quantity = trimmed(name.substr(0, name.find('@')));
  const auto at = name.find('@');
  const auto second_at = at == std::string::npos ? at : name.find('@', at + 1);
  const std::optional<std::string> load = value_of("p", name, at, second_at);
  if (!load)
    return refused_at_load("must have the form area_fraction@p=0.01 E*");
  const bool has_magnification = second_at != std::string::npos;
  const std::string mistake = mistake_in_name(
      quantity,
      has_magnification ? quantities_at_magnification() : quantities_at_load());
  if (!mistake.empty())
    return refused_at_load(mistake);
  const QuantityReading pressure = read_quantity(
      *load, Dimension::pressure, {mechanics::ReferenceUnit::contact_modulus});
  if (!pressure.quantity)
    return refused_at_load("has a p that " + pressure.mistake);
  if (!(pressure.quantity->value > 0.0))
    return refused_at_load("has a p that is not > 0");
  QuantityAtLoad read{quantity, *pressure.quantity};
  if (has_magnification) {
    read.magnification =
        positive_number(value_of("zeta", name, second_at, std::string::npos));
    if (!read.magnification)
      return refused_at_load(
          "must have the form area_fraction@p=0.01 E*@zeta=10 with zeta > 0");
  }
  return {read, ""};
}

} // namespace asperity::cases
