#include "reports/analysis/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

// Rounds up to two digits, 0.0412 -> 0.042: the result is never less than the
// number.
double up_to_two_digits(double number) {
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1.0);
  return std::ceil(number / unit * (1.0 - 1e-12)) * unit;
}

std::string distance_words(double value, double difference) {
  if (value == 0.0)
    return fmt::format("differs by {:.2g}", up_to_two_digits(difference));
  return fmt::format("differs by {:.3g} %",
                     up_to_two_digits(100.0 * difference / std::abs(value)));
}

bool is_wide(const cases::ReferenceValue& reference, double interval) {
  return interval > std::max(reference.uncertainty,
                             wide_interval * std::abs(reference.value));
}

} // namespace

const char* reproduction_word(Reproduction reproduction) {
  switch (reproduction) {
  case Reproduction::reproduced:
    return "reproduced";
  case Reproduction::inconclusive:
    return "inconclusive";
  case Reproduction::differs:
    return "differs";
  case Reproduction::not_reproducible:
    return "not_reproducible";
  case Reproduction::input:
    return "input";
  case Reproduction::missing:
    break;
  }
  return "missing";
}

Judgement compare_with_published(const cases::ReferenceValue& reference,
                                 const Estimate& ours) {
  const std::string refusal = "not reproducible: " + reference.why;
  if (ours.is_input)
    return {Reproduction::input, "set in the case"};
  if (!ours.has_value())
    return reference.why.empty()
               ? Judgement{Reproduction::missing,
                           "not determined: " + ours.remark}
               : Judgement{Reproduction::not_reproducible, refusal};
  const double difference = std::abs(ours.value - reference.value);
  const double interval = ours.has_interval() ? ours.half_width : 0.0;
  // Allows for the finite number of printed digits of the published number.
  const double rounding = 1e-12 * std::abs(reference.value);
  if (difference <= reference.uncertainty + interval + rounding) {
    if (!reference.input.empty())
      return {Reproduction::input, "set in the case: " + reference.input};
    if (is_wide(reference, interval))
      return {Reproduction::inconclusive,
              fmt::format("inconclusive: our interval, ± {:.2g}, is so wide "
                          "that many other values would agree",
                          interval)};
    return {Reproduction::reproduced, "reproduced"};
  }
  if (!reference.why.empty())
    return {Reproduction::not_reproducible, refusal};
  return {Reproduction::differs, distance_words(reference.value, difference)};
}

} // namespace asperity::reports
