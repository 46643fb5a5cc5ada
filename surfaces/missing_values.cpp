#include "surfaces/missing_values.hpp"

#include "input/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::surfaces {
namespace {

/// An end of the range of all heights, as its sign times the heights.
struct RangeEnd {
  double outer = 0.0;  ///< the largest
  double inner = 0.0;  ///< the largest of the others; -infinity: there is none
  double range = 0.0;  ///< of the others
  double points = 0.0; ///< whose height is the largest

  /// Whether it is farther from the others than a fraction of their range.
  bool is_apart(double fraction) const {
    return outer - inner > fraction * range;
  }
};

RangeEnd range_end(std::span<const double> heights, double sign) {
  constexpr double none = -std::numeric_limits<double>::infinity();
  const auto largest_of = [&](double factor, double below) {
    double largest = none;
    for (const double height : heights)
      if (std::isfinite(height) && factor * height < below)
        largest = std::max(largest, factor * height);
    return largest;
  };
  RangeEnd end;
  end.outer = largest_of(sign, std::numeric_limits<double>::infinity());
  end.inner = largest_of(sign, end.outer);
  end.range = end.inner + largest_of(-sign, -none);
  end.points =
      static_cast<double>(std::ranges::count(heights, sign * end.outer));
  return end;
}

/// Whether a number is a usual mark, as the file writes it or converted between
/// units of length.
bool is_usual_mark(double number) {
  static constexpr double marks[] = {
      -999.0,    -9999.0,  9999.0,  -99999.0, 99999.0,       999999.0,
      -999999.0, -32768.0, 32767.0, 65535.0,  -2147483648.0, 2147483647.0};
  static constexpr double units[] = {1.0, 1e-3, 1e-6, 1e-9, 1e-10, 1e-12};
  constexpr double rounding = 1e-7; // of single precision
  return std::ranges::any_of(marks, [&](double mark) {
    return std::ranges::any_of(units, [&](double unit) {
      return std::abs(number - mark * unit) <= rounding * std::abs(mark * unit);
    });
  });
}

} // namespace

void refuse_marks(std::span<const double> heights, const FileNumbers& numbers,
                  const std::string& name) {
  constexpr double least_impossible = 1e20;
  for (const double sign : {-1.0, 1.0}) {
    const RangeEnd end = range_end(heights, sign);
    const double number = sign * end.outer / numbers.unit;
    const bool is_impossible = std::abs(number) >= least_impossible;
    const bool is_known = is_usual_mark(number) && end.is_apart(0.125);
    const bool is_suspect = numbers.is_converted && end.points > 1.0 &&
                            end.is_apart(1.0) && end.range > 0.0;
    if (is_impossible || is_known || is_suspect)
      throw input::InputError(fmt::format(
          "{}: {} point(s) have the number {:.7g}, which {} and probably marks "
          "missing points; surface.missing_value = {:.7g} takes it for that, "
          "and another value, such as 1e99, takes all numbers for heights",
          name, end.points, number,
          is_impossible ? "is larger than any height"
                        : "is far from all others",
          number));
  }
}

} // namespace asperity::surfaces
