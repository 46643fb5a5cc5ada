#include "reports/numbers/estimate.hpp"

#include "base/field_sums.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

std::string left_out(std::size_t count) {
  return count == 0 ? std::string()
                    : fmt::format("; {} without a value excluded", count);
}

} // namespace

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
  LineFit fit;
  fit.points = static_cast<int>(x.size());
  if (x.size() < 2 || x.size() != y.size())
    return fit;
  const double n = static_cast<double>(x.size());
  const double centre_x = mean(x);
  const double centre_y = mean(y);
  double spread = 0.0;
  double product = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    spread += (x[i] - centre_x) * (x[i] - centre_x);
    product += (x[i] - centre_x) * (y[i] - centre_y);
  }
  if (!(spread > 0.0) || !std::isfinite(spread) || !std::isfinite(product))
    return fit;

  fit.centre_x = centre_x;
  fit.centre_y = centre_y;
  fit.slope = product / spread;
  fit.intercept = centre_y - fit.slope * centre_x;
  double squares = 0.0;
  fit.largest_residual = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double residual = y[i] - fit.intercept - fit.slope * x[i];
    squares += residual * residual;
    fit.largest_residual = std::max(fit.largest_residual, std::abs(residual));
  }
  if (x.size() > 2) {
    const double variance = squares / (n - 2.0);
    fit.slope_error = std::sqrt(variance / spread);
    fit.centre_error = std::sqrt(variance / n);
    fit.intercept_error =
        std::hypot(fit.centre_error, centre_x * fit.slope_error);
  }
  return fit;
}

Estimate single_number(double value, const std::string& remark,
                       const std::string& missing) {
  Estimate estimate;
  estimate.value = value;
  estimate.realizations = estimate.has_value() ? 1 : 0;
  estimate.remark = estimate.has_value() ? remark : missing;
  return estimate;
}

double student_half_width(double standard_error, int degrees_of_freedom) {
  if (degrees_of_freedom < 1 || !std::isfinite(standard_error))
    return not_a_number;
  const boost::math::students_t distribution(degrees_of_freedom);
  return boost::math::quantile(distribution, 0.975) * standard_error;
}

Estimate mean_over_realizations(std::span<const FittedValue> fits) {
  std::vector<double> values;
  for (const FittedValue& fit : fits)
    if (std::isfinite(fit.value))
      values.push_back(fit.value);

  Estimate estimate;
  estimate.realizations = static_cast<int>(values.size());
  const std::string omitted = left_out(fits.size() - values.size());
  if (values.empty()) {
    const auto told =
        std::find_if(fits.begin(), fits.end(), [](const FittedValue& fit) {
          return !fit.reason.empty();
        });
    estimate.remark =
        told == fits.end() ? "no realisation has a value" : told->reason;
    return estimate;
  }
  estimate.value = mean(values);
  if (values.size() == 1) {
    const auto answered =
        std::find_if(fits.begin(), fits.end(), [](const FittedValue& fit) {
          return std::isfinite(fit.value);
        });
    estimate.half_width = student_half_width(answered->standard_error,
                                             answered->degrees_of_freedom);
    estimate.remark = estimate.has_interval()
                          ? "one realisation: the interval is that of the fit, "
                            "not the spread between surfaces"
                          : "one realisation: no interval";
    estimate.remark += omitted;
    return estimate;
  }
  double squares = 0.0;
  for (const double value : values)
    squares += (value - estimate.value) * (value - estimate.value);
  const double n = static_cast<double>(values.size());
  estimate.half_width = student_half_width(std::sqrt(squares / (n - 1.0) / n),
                                           static_cast<int>(values.size()) - 1);
  estimate.remark =
      fmt::format("Student's t over {} realisations{}", values.size(), omitted);
  return estimate;
}

Spread spread_of(std::span<const double> numbers) {
  if (numbers.empty())
    return {};
  Spread spread{mean(numbers)};
  double squares = 0.0;
  for (const double number : numbers)
    squares += (number - spread.mean) * (number - spread.mean);
  if (numbers.size() > 1)
    spread.deviation =
        std::sqrt(squares / (static_cast<double>(numbers.size()) - 1.0));
  return spread;
}

double median(std::vector<double> numbers) {
  std::ranges::sort(numbers);
  const std::size_t half = numbers.size() / 2;
  return numbers.size() % 2 == 1 ? numbers[half]
                                 : 0.5 * (numbers[half - 1] + numbers[half]);
}

} // namespace asperity::reports
