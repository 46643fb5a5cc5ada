#include "reports/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

// 0.0412 -> 0.042: never less than the number.
double up_to_two_digits(double number) {
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1.0);
  return std::ceil(number / unit * (1.0 - 1e-12)) * unit;
}

std::string distance_words(double value, double difference) {
  if (value == 0.0)
    return fmt::format("off by {:.2g}", up_to_two_digits(difference));
  return fmt::format("within {:.3g} %",
                     up_to_two_digits(100.0 * difference / std::abs(value)));
}

// An interval that much else would lie in as well.
bool is_wide(const cases::ReferenceValue& reference, double interval) {
  return interval > std::max(reference.uncertainty,
                             wide_interval * std::abs(reference.value));
}

} // namespace

const char* reproduction_word(Reproduction reproduction) {
  switch (reproduction) {
  case Reproduction::reproduced:
    return "reproduced";
  case Reproduction::near:
    return "near";
  case Reproduction::not_reproducible:
    return "not_reproducible";
  case Reproduction::input:
    return "input";
  case Reproduction::missing:
    break;
  }
  return "missing";
}

Judgement judge_published(const cases::ReferenceValue& reference,
                          const Estimate& ours) {
  const std::string refusal = "not reproducible: " + reference.why;
  if (ours.is_input)
    return {Reproduction::input, "set in the case"};
  if (!ours.has_value())
    return reference.why.empty()
               ? Judgement{Reproduction::missing, "no number: " + ours.remark}
               : Judgement{Reproduction::not_reproducible, refusal};
  const double difference = std::abs(ours.value - reference.value);
  const double interval = ours.has_interval() ? ours.half_width : 0.0;
  // a number of as many digits as were printed is as near as it can be
  const double rounding = 1e-12 * std::abs(reference.value);
  if (difference <= reference.uncertainty + interval + rounding)
    return {Reproduction::reproduced, is_wide(reference, interval)
                                          ? "reproduced, within a wide interval"
                                          : "reproduced"};
  if (!reference.why.empty())
    return {Reproduction::not_reproducible, refusal};
  return {Reproduction::near, distance_words(reference.value, difference)};
}

} // namespace asperity::reports
