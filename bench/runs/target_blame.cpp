// Explains why no setting meets an error target: which method, which quantity
// and which contribution to the error is responsible.
#include "bench/analysis/bench_answer.hpp"
#include "bench/pages/bench_report.hpp"
#include "bench/runs/target_error.hpp"
#include "bench/settings/case_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::bench {
namespace {

constexpr double finest_growth = 0.25; ///< factor of ln g

/// The smallest error that a method can achieve, and its quantity.
struct Miss {
  const Forecast* forecast = nullptr;
  std::string quantity;
  double error = std::numeric_limits<double>::infinity();
};

/// Returns the quantity with the largest error for that method and element.
Miss worst_of(const Forecast& forecast,
              const std::vector<std::string>& quantities, int points) {
  Miss worst{&forecast, quantities.front(), -1.0};
  for (const std::string& quantity : quantities) {
    const double error = forecast.error(quantity, points, finest_growth);
    if (error > worst.error)
      worst = {&forecast, quantity, error};
  }
  return worst;
}

/// Returns the smallest achievable error by method, with its best element.
std::map<std::string, Miss> misses(const std::vector<Forecast>& forecasts,
                                   const std::vector<std::string>& quantities,
                                   int points) {
  std::map<std::string, Miss> best;
  for (const Forecast& forecast : forecasts) {
    const Miss miss = worst_of(forecast, quantities, points);
    Miss& known = best[forecast.method];
    if (known.forecast == nullptr || miss.error < known.error)
      known = miss;
  }
  return best;
}

} // namespace

std::string TargetSearch::depth_words(const Forecast& forecast,
                                      const std::string& column) {
  const CaseValues values(case_);
  for (const char* key : {"depth", "thickness"}) {
    const auto own = values.value(forecast.method, key);
    const std::string twice = own ? scaled_value(*own, 2.0) : "";
    if (twice.empty())
      continue;
    const int points = grids_.front();
    const BenchPoint as_it_is =
        run_at(forecast.method, forecast.element, points, 1.0);
    const BenchPoint deeper =
        run_at(forecast.method, forecast.element, points, 1.0,
               {fmt::format("{}.{}={}", forecast.method, key, twice)});
    const double change = error_against(deeper.answer, as_it_is.answer, column);
    if (std::isfinite(change))
      return fmt::format("; doubling the {} changes it by {}", key,
                         per_cent(change));
  }
  return "";
}

std::string TargetSearch::why_none(double target) {
  const int last = finest_points();
  std::string words = fmt::format("no setting up to {} points per side has a "
                                  "predicted error below {} in every quantity",
                                  last, per_cent(target));
  for (const auto& [method, miss] : misses(forecasts_, quantities_, last)) {
    if (miss.error < target)
      continue;
    if (!std::isfinite(miss.error)) {
      words += fmt::format("; {} has no predicted error of {}", method,
                           miss.quantity);
      continue;
    }
    const std::string column =
        miss.forecast->best_column(miss.quantity, last, finest_growth);
    const ErrorParts parts = miss.forecast->parts(column, last, finest_growth);
    words += fmt::format("; {} has an error of {} in {}", method,
                         per_cent(miss.error), miss.quantity);
    if (parts.staying < 0.5 * miss.error)
      continue;
    words += fmt::format(", of which {} is independent of the grid",
                         per_cent(parts.staying));
    if (const std::string exact = exact_words(case_); !exact.empty())
      words += fmt::format(
          ": the case's block differs from that of the exact solution ({}){}",
          exact, depth_words(*miss.forecast, column));
  }
  if (!problem_.empty())
    words += fmt::format("; {}", problem_);
  return words;
}

} // namespace asperity::bench
