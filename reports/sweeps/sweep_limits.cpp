#include "reports/sweeps/sweep_limits.hpp"

#include "reports/numbers/bootstrap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string_view>

namespace asperity::reports {
namespace {

bool varies_only_spectrum_and_grid(const SweepRecord& record) {
  constexpr std::array<std::string_view, 9> keys{"surface.hurst",
                                                 "surface.points",
                                                 "surface.length",
                                                 "surface.wavelength_long",
                                                 "surface.wavelength_short",
                                                 "surface.wavelength_roll_off",
                                                 "surface.wavevector_low",
                                                 "surface.wavevector_high",
                                                 "surface.wavevector_roll_off"};
  return std::ranges::all_of(record.keys, [&](const cases::SweptKey& key) {
    return std::ranges::find(keys, key.key) != keys.end();
  });
}

double value_of(const RealizationFits& fits, const std::string& quantity) {
  return quantity == "gamma_matched"  ? fits.matched.gamma.value
         : quantity == "gamma_curve"  ? fits.curve.gamma.value
         : quantity == "gamma_energy" ? fits.energy.gamma.value
         : quantity == "gamma_slope"  ? fits.slope.gamma_slope.value
                                      : fits.area.kappa.value;
}

/// One point of the sweep in the fit.
struct Sample {
  std::size_t group = 0;
  double size = 0.0;          ///< (lambda_0/L)^2
  double grid = 0.0;          ///< (h/lambda_1)^2
  double weight = 0.0;        ///< 1/variance of the mean
  std::vector<double> values; ///< of the realisations, NaN: none
};

/// Mean and its variance of the finite values of a sample of realisations.
struct MeanOfValues {
  double mean = not_a_number;
  double variance = not_a_number;
};

MeanOfValues mean_of_values(const std::vector<double>& values,
                            std::span<const std::size_t> drawn) {
  double sum = 0.0, squares = 0.0, n = 0.0;
  for (const std::size_t index : drawn)
    if (const double value = values[index % values.size()];
        std::isfinite(value)) {
      sum += value;
      squares += value * value;
      n += 1.0;
    }
  const double mean = sum / n;
  return {mean, (squares / n - mean * mean) / (n - 1.0)};
}

/// Sums over the points of one group, or of all about the means of the groups.
struct Sums {
  double weight = 0.0, size = 0.0, grid = 0.0, value = 0.0;
};

/// The least-squares fit with one constant for each group.
class GroupedFit {
public:
  GroupedFit(const std::vector<Sample>& samples, std::size_t groups)
      : samples_(samples), groups_(groups) {}

  /// y_inf of a group for a sample of realisations.
  double limit(std::size_t group, std::span<const std::size_t> drawn) const {
    std::vector<double> values;
    values.reserve(samples_.size());
    std::vector<Sums> means(groups_);
    for (const Sample& sample : samples_) {
      values.push_back(mean_of_values(sample.values, drawn).mean);
      Sums& sums = means[sample.group];
      sums.weight += sample.weight;
      sums.size += sample.weight * sample.size;
      sums.grid += sample.weight * sample.grid;
      sums.value += sample.weight * values.back();
    }
    for (Sums& sums : means)
      sums = {1.0, sums.size / sums.weight, sums.grid / sums.weight,
              sums.value / sums.weight};
    double aa = 0.0, ab = 0.0, bb = 0.0, ya = 0.0, yb = 0.0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const Sample& sample = samples_[i];
      const double a = sample.size - means[sample.group].size;
      const double b = sample.grid - means[sample.group].grid;
      const double y = values[i] - means[sample.group].value;
      aa += sample.weight * a * a;
      ab += sample.weight * a * b;
      bb += sample.weight * b * b;
      ya += sample.weight * a * y;
      yb += sample.weight * b * y;
    }
    const bool has_size = aa > least_variation();
    const bool has_grid = bb > least_variation() &&
                          (!has_size || aa * bb - ab * ab > 1e-6 * aa * bb);
    const double determinant = aa * bb - ab * ab;
    const double by_size = !has_size  ? 0.0
                           : has_grid ? (ya * bb - yb * ab) / determinant
                                      : ya / aa;
    const double by_grid = !has_grid  ? 0.0
                           : has_size ? (yb * aa - ya * ab) / determinant
                                      : yb / bb;
    const Sums& mean = means[group];
    return mean.value - by_size * mean.size - by_grid * mean.grid;
  }

private:
  /// Roundoff of sums of squares of numbers below 1.
  double least_variation() const {
    double weight = 0.0;
    for (const Sample& sample : samples_)
      weight += sample.weight;
    return 1e-12 * weight;
  }

  const std::vector<Sample>& samples_;
  std::size_t groups_;
};

/// The points of one method and Hurst exponent.
struct Family {
  std::string method;
  double hurst = 0.0;
  std::vector<const SweptResult*> points;
};

std::vector<Family> families_of(const SweptResults& results) {
  std::vector<Family> families;
  for (const auto& result : results)
    for (const MethodSummary& method : result->summary.methods) {
      if (!result->spectrum || method.kind == "theory")
        continue;
      const double hurst = result->spectrum->hurst;
      auto family = std::ranges::find_if(families, [&](const Family& one) {
        return one.method == method.name && one.hurst == hurst;
      });
      if (family == families.end())
        family = families.insert(families.end(), {method.name, hurst, {}});
      family->points.push_back(result.get());
    }
  std::ranges::stable_sort(families, {}, &Family::hurst);
  return families;
}

/// q_1/q_0 to six digits, so that equal ratios are equal numbers.
double rounded_ratio(const SweptResult& point) {
  return std::stod(fmt::format("{:.6g}", point.spectrum->ratio));
}

/// The limits of one family, with one group for each of the ratios, or with one
/// group for all if there is one ratio, NaN.
void add_limits(const Family& family, const std::vector<double>& ratios,
                std::vector<SweepLimit>& limits) {
  const auto group_of = [&](const SweptResult& point) {
    return ratios.size() == 1
               ? std::size_t{0}
               : static_cast<std::size_t>(
                     std::ranges::find(ratios, rounded_ratio(point)) -
                     ratios.begin());
  };
  const std::size_t first = limits.size();
  for (const double ratio : ratios)
    limits.push_back({family.method, family.hurst, ratio});
  double largest = 0.0;
  for (const SweptResult* point : family.points) {
    SweepLimit& limit = limits[first + group_of(*point)];
    ++limit.points;
    if (!std::isnan(limit.ratio) && point->spectrum->size >= largest)
      limit.nayak = point->spectrum->nayak;
  }
  for (const char* quantity : quantities_with_limits) {
    std::vector<Sample> samples;
    std::size_t realizations = 0;
    std::set<std::size_t> found;
    for (const SweptResult* point : family.points) {
      const SpectrumPoint& spectrum = *point->spectrum;
      Sample sample{group_of(*point),
                    std::pow(spectrum.size, -2),
                    std::pow(spectrum.nodes_per_wave, -2),
                    0.0,
                    {}};
      for (const RealizationFits& fits :
           method_called(point->summary.methods, family.method)->fits)
        sample.values.push_back(value_of(fits, quantity));
      std::vector<std::size_t> all(sample.values.size());
      std::iota(all.begin(), all.end(), std::size_t{0});
      const double variance = all.empty()
                                  ? not_a_number
                                  : mean_of_values(sample.values, all).variance;
      if (!(variance > 0.0) || !std::isfinite(variance))
        continue; // fewer than two values
      sample.weight = 1.0 / variance;
      realizations = std::max(realizations, sample.values.size());
      found.insert(sample.group);
      samples.push_back(std::move(sample));
    }
    const GroupedFit fit(samples, ratios.size());
    for (const std::size_t group : found)
      limits[first + group].limits[quantity] =
          bootstrap(realizations, [&](std::span<const std::size_t> drawn) {
            return fit.limit(group, drawn);
          });
  }
}

/// Whether surfaces of one spectrum differ in size or grid.
bool has_limit(const Family& family) {
  return std::ranges::any_of(family.points, [&](const SweptResult* one) {
    return std::ranges::any_of(family.points, [&](const SweptResult* other) {
      return rounded_ratio(*one) == rounded_ratio(*other) &&
             (one->spectrum->size != other->spectrum->size ||
              one->spectrum->nodes_per_wave != other->spectrum->nodes_per_wave);
    });
  });
}

} // namespace

std::vector<SweepLimit> sweep_limits(const SweepRecord& record,
                                     const SweptResults& results) {
  std::vector<SweepLimit> limits;
  if (!varies_only_spectrum_and_grid(record))
    return limits;
  for (const Family& family : families_of(results)) {
    if (!has_limit(family))
      continue;
    std::set<double> ratios;
    for (const SweptResult* point : family.points)
      ratios.insert(rounded_ratio(*point));
    if (ratios.size() > 1)
      add_limits(family, {ratios.begin(), ratios.end()}, limits);
    add_limits(family, {not_a_number}, limits);
  }
  std::erase_if(limits,
                [](const SweepLimit& limit) { return limit.limits.empty(); });
  return limits;
}

} // namespace asperity::reports
