#include "reports/analysis/refinement.hpp"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace asperity::reports {
namespace {

constexpr double lowest_order = 0.1;
constexpr double largest_order = 12.0;
constexpr double least_useful_order = 0.5;
constexpr double least_cosine = 0.5;

/// (h_1^p - h_2^p) / (h_2^p - h_3^p)
double difference_ratio(std::span<const double, 3> h, double order) {
  const double coarse = std::pow(h[0] / h[1], order);
  const double fine = std::pow(h[2] / h[1], order);
  return (coarse - 1.0) / (1.0 - fine);
}

/// Returns the cosine of the angle between the two differences, each entry
/// divided by its scale.
double cosine(std::span<const std::vector<double>, 3> answers,
              std::span<const double> scale) {
  double product = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (std::size_t i = 0; i < scale.size(); ++i) {
    const double a = (answers[1][i] - answers[0][i]) / scale[i];
    const double b = (answers[2][i] - answers[1][i]) / scale[i];
    product += a * b;
    first += a * a;
    second += b * b;
  }
  return product / std::sqrt(first * second);
}

} // namespace

double PowerLaw::at(double x) const {
  return factor * std::pow(x, exponent);
}

PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y) {
  std::vector<double> log_x;
  std::vector<double> log_y;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i] > 0.0 && y[i] > 0.0 && std::isfinite(x[i]) &&
        std::isfinite(y[i])) {
      log_x.push_back(std::log(x[i]));
      log_y.push_back(std::log(y[i]));
    }
  PowerLaw law;
  law.points = static_cast<int>(log_x.size());
  const auto [least, largest] = std::minmax_element(log_x.begin(), log_x.end());
  if (log_x.size() < 2 || !(*largest > *least))
    return law;
  const LineFit line = fit_line(log_x, log_y);
  law.exponent = line.slope;
  law.factor = std::exp(line.intercept);
  law.exponent_error = line.slope_error;
  return law;
}

double rms_difference(std::span<const double> a, std::span<const double> b,
                      std::span<const double> scale) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = (a[i] - b[i]) / scale[i];
    sum += difference * difference;
  }
  return a.empty() || !std::isfinite(sum)
             ? not_a_number
             : std::sqrt(sum / static_cast<double>(a.size()));
}

double observed_order(std::span<const double, 3> spacings, double first,
                      double second) {
  const double ratio = first / second;
  if (!(second > 0.0) || !(ratio > difference_ratio(spacings, lowest_order)) ||
      !(ratio < difference_ratio(spacings, largest_order)))
    return not_a_number;
  std::uintmax_t rounds = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      [&](double order) { return difference_ratio(spacings, order) - ratio; },
      lowest_order, largest_order,
      boost::math::tools::eps_tolerance<double>(40), rounds);
  return std::midpoint(bracket.first, bracket.second);
}

RefinementLimit refinement_limit(std::span<const std::vector<double>> answers,
                                 std::span<const double> spacings,
                                 std::span<const double> scale,
                                 double highest_order) {
  RefinementLimit limit;
  if (answers.empty())
    return limit;
  limit.values = answers.back();
  if (answers.size() < 2)
    return limit;
  const auto last = answers.last(std::min<std::size_t>(answers.size(), 3));
  limit.uncertainty =
      rms_difference(last[last.size() - 1], last[last.size() - 2], scale);
  if (last.size() < 3)
    return limit;
  const std::span<const std::vector<double>, 3> three(last);
  const std::span<const double, 3> h(spacings.last(3));
  const double order = observed_order(
      h, rms_difference(three[0], three[1], scale), limit.uncertainty);
  if (!(order >= least_useful_order) || !(cosine(three, scale) >= least_cosine))
    return limit;
  limit.order = order;
  limit.is_extrapolated = true;
  const double share =
      1.0 / (std::pow(h[1] / h[2], std::min(order, highest_order)) - 1.0);
  for (std::size_t i = 0; i < limit.values.size(); ++i)
    limit.values[i] += share * (three[2][i] - three[1][i]);
  limit.uncertainty *= share;
  return limit;
}

std::vector<std::size_t> pareto_front(std::span<const double> costs,
                                      std::span<const double> errors) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < costs.size(); ++i)
    if (std::isfinite(costs[i]) && std::isfinite(errors[i]))
      order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return costs[a] != costs[b] ? costs[a] < costs[b] : errors[a] < errors[b];
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || errors[i] < errors[front.back()])
      front.push_back(i);
  return front;
}

} // namespace asperity::reports
