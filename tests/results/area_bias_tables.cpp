#include "tests/results/area_bias.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace asperity::area_bias {
namespace {

constexpr const char* limit_kernel = "half-space";
constexpr int coarsest_calibrated = 8;
constexpr int finest_calibrated = 32;
constexpr std::size_t slope_end = 2; // the load where the chord of gamma ends

/// An estimate of the area in one solution; none where it cannot be determined.
using Estimator = std::function<std::optional<double>(const Place&)>;

const Sample* sample_at(const Samples& samples, const Place& place) {
  const auto found = samples.find(place);
  return found == samples.end() ? nullptr : &found->second;
}

/// 2 A(h) - A(2h) of one of the areas.
Estimator richardson(const Samples& samples, double Sample::*area) {
  return [&samples, area](const Place& place) -> std::optional<double> {
    const Sample* fine = sample_at(samples, place);
    const Sample* coarse = sample_at(
        samples, {place.kernel, place.r / 2, place.load, place.surface});
    if (fine == nullptr || coarse == nullptr)
      return {};
    return 2.0 * fine->*area - coarse->*area;
  };
}

Estimator plain(const Samples& samples, double Sample::*area) {
  return [&samples, area](const Place& place) -> std::optional<double> {
    const Sample* sample = sample_at(samples, place);
    return sample != nullptr ? std::optional(sample->*area) : std::nullopt;
  };
}

struct Spread {
  int n = 0;
  double sum = 0.0;
  double squares = 0.0;

  void add(double value) {
    ++n;
    sum += value;
    squares += value * value;
  }

  double mean() const { return sum / n; }

  double deviation() const {
    return std::sqrt(std::max(0.0, squares - sum * sum / n) / (n - 1));
  }
};

std::string cell(const Spread& spread) {
  if (spread.n == 0)
    return " |";
  if (spread.n == 1)
    return fmt::format(" {:+.2f} |", 100.0 * spread.mean());
  return fmt::format(" {:+.2f} ± {:.2f} |", 100.0 * spread.mean(),
                     100.0 * spread.deviation());
}

/// A row of a table with one cell per load, of error_at(place, limit).
template <class ErrorAt>
void print_row(const std::string& head, const Kernel& kernel, int r,
               const Limits& limits, std::size_t n_loads, ErrorAt error_at) {
  std::vector<Spread> spread(n_loads);
  for (const auto& [where, limit] : limits)
    if (where.first < n_loads)
      if (const std::optional<double> error =
              error_at({kernel.name, r, where.first, where.second}, limit))
        spread[where.first].add(*error);
  if (spread.front().n == 0)
    return;
  std::string row = head;
  for (const Spread& one : spread)
    row += cell(one);
  fmt::print("{}\n", row);
}

void print_area_rows(const std::string& name, const Kernel& kernel,
                     const Limits& limits, const Estimator& estimate) {
  for (int r = coarsest; r <= finest_calibrated; r *= 2)
    print_row(fmt::format("| {} | {} |", name, r), kernel, r, limits,
              loads.size(), [&](const Place& place, const Limit& limit) {
                auto area = estimate(place);
                if (area)
                  *area = *area / limit.area - 1.0;
                return area;
              });
}

struct Calibration {
  double count_perimeter = 0.0; ///< c of count - c S_d h
  results::AreaCoefficients lines;
};

Calibration calibrate(const Kernel& kernel, const Samples& samples,
                      const Limits& limits) {
  double cc = 0.0, ce = 0.0, ee = 0.0, c_lines = 0.0, e_lines = 0.0;
  double c_count = 0.0;
  for (const auto& [place, sample] : samples) {
    if (place.kernel != kernel.name || place.r < coarsest_calibrated ||
        place.r > finest_calibrated)
      continue;
    const double area = limits.at({place.load, place.surface}).area;
    const double c = sample.perimeter / area;
    const double e = -sample.euler / area;
    cc += c * c;
    ce += c * e;
    ee += e * e;
    c_lines += c * (sample.lines / area - 1.0);
    e_lines += e * (sample.lines / area - 1.0);
    c_count += c * (sample.counted / area - 1.0);
  }
  const double determinant = cc * ee - ce * ce;
  return {c_count / cc,
          {(c_lines * ee - e_lines * ce) / determinant,
           (cc * e_lines - ce * c_lines) / determinant}};
}

} // namespace

Limits find_limits(const Samples& samples, int n_surfaces) {
  Limits limits;
  for (std::size_t load = 0; load < loads.size(); ++load)
    for (int surface = 0; surface < n_surfaces; ++surface) {
      const Sample& sample = samples.at({limit_kernel, finest, load, surface});
      limits[{load, surface}] = {sample.corrected, sample.mean_gap};
    }
  return limits;
}

void print_limit_doubt(const Samples& samples, const Limits& limits) {
  fmt::print("\n| against the limit | 0.01 | 0.03 | 0.1 | 0.3 | 1 |\n"
             "|---|---|---|---|---|---|\n");
  const Kernel kernel{limit_kernel, {}, {}, 0.0, finest};
  for (const auto& [name, area] :
       {std::pair{"Richardson of the lines", &Sample::lines},
        std::pair{"Richardson of the count", &Sample::counted}})
    print_row(fmt::format("| {} |", name), kernel, finest, limits, loads.size(),
              [&, area = area](const Place& place, const Limit& limit) {
                auto other = richardson(samples, area)(place);
                if (other)
                  *other = *other / limit.area - 1.0;
                return other;
              });
}

void print_calibration(const Kernel& kernel, const Samples& samples,
                       const Limits& limits) {
  const Calibration fit = calibrate(kernel, samples, limits);
  fmt::print("\n{}: count c = {:.3f}; lines c = {:.4f}, e = {:.3f} (in use: "
             "{:.4f}, {:.3f})\n",
             kernel.name, fit.count_perimeter, fit.lines.perimeter,
             fit.lines.euler, kernel.coefficients.perimeter,
             kernel.coefficients.euler);
}

void print_areas(const Kernel& kernel, const Samples& samples,
                 const Limits& limits) {
  const double c = calibrate(kernel, samples, limits).count_perimeter;
  fmt::print("\n| area by | r | 0.01 | 0.03 | 0.1 | 0.3 | 1 |\n"
             "|---|---|---|---|---|---|---|\n");
  print_area_rows("count", kernel, limits, plain(samples, &Sample::counted));
  print_area_rows("count - c S_d h", kernel, limits,
                  [&](const Place& place) -> std::optional<double> {
                    const Sample* sample = sample_at(samples, place);
                    if (sample == nullptr)
                      return {};
                    return sample->counted - c * sample->perimeter;
                  });
  print_area_rows("Richardson", kernel, limits,
                  richardson(samples, &Sample::counted));
  print_area_rows("pressure fit", kernel, limits,
                  plain(samples, &Sample::fitted));
  print_area_rows("lines", kernel, limits, plain(samples, &Sample::lines));
  print_area_rows("lines, corrected", kernel, limits,
                  plain(samples, &Sample::corrected));
}

void print_gaps(const Kernel& kernel, const Samples& samples,
                const Limits& limits) {
  fmt::print("\n| mean gap, of h_rms: r | 0.01 | 0.03 | 0.1 | 0.3 | 1 | gamma "
             "|\n|---|---|---|---|---|---|---|\n");
  const auto gap_at = [&](const Place& place) -> std::optional<double> {
    return plain(samples, &Sample::mean_gap)(place);
  };
  for (int r = coarsest; r <= finest_calibrated; r *= 2) {
    Spread slope;
    for (const auto& [where, limit] : limits) {
      if (where.first != 0)
        continue;
      const auto far = gap_at({kernel.name, r, 0, where.second});
      const auto near = gap_at({kernel.name, r, slope_end, where.second});
      if (far && near)
        slope.add((*far - *near) /
                      (limit.mean_gap -
                       limits.at({slope_end, where.second}).mean_gap) -
                  1.0);
    }
    if (slope.n == 0)
      continue;
    std::string row = fmt::format("| {} |", r);
    for (std::size_t load = 0; load < loads.size(); ++load) {
      Spread spread;
      for (const auto& [where, limit] : limits)
        if (where.first == load)
          if (const auto gap = gap_at({kernel.name, r, load, where.second}))
            spread.add(*gap - limit.mean_gap);
      row += cell(spread);
    }
    fmt::print("{}{}\n", row, cell(slope));
  }
}

} // namespace asperity::area_bias
