#include "surfaces/analysis/stitched_spectrum.hpp"

#include "base/require.hpp"
#include "base/special_numbers.hpp"

#include <boost/math/special_functions/digamma.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace asperity::surfaces {
namespace {

constexpr double rows_per_decade = 10.0;

/// Weighted sums of the rings of one step, or of those of one part in it.
struct LogSums {
  double weight = 0.0;
  double log_q = 0.0;
  double log_density = 0.0;
  double mean_square_height = 0.0;

  void add(const SpectrumRing& ring) {
    const double nu = ring.degrees_of_freedom;
    const double bias = boost::math::digamma(0.5 * nu) - std::log(0.5 * nu);
    weight += nu;
    log_q += nu * std::log(ring.wavevector);
    log_density += nu * (std::log(ring.density) - bias);
    mean_square_height += ring.mean_square_height;
  }
};

struct Step {
  LogSums all;
  std::map<std::size_t, LogSums> by_part;
};

/// Mean difference of ln C between the part and all parts of a step. Both are
/// taken at the mean q of the part, by the exponent -3 that is typical; the
/// steps are narrow.
double log_ratio(const LogSums& part, const LogSums& all) {
  constexpr double exponent = -3.0;
  const double shift = part.log_q / part.weight - all.log_q / all.weight;
  return part.log_density / part.weight - all.log_density / all.weight -
         exponent * shift;
}

std::vector<std::pair<double, double>>
gaps_between(std::vector<SpectrumPart> parts) {
  std::sort(parts.begin(), parts.end(),
            [](const SpectrumPart& a, const SpectrumPart& b) {
              return a.low < b.low;
            });
  std::vector<std::pair<double, double>> gaps;
  double end = parts.front().high;
  for (const SpectrumPart& part : parts) {
    if (part.low > end)
      gaps.emplace_back(end, part.low);
    end = std::max(end, part.high);
  }
  return gaps;
}

} // namespace

StitchedSpectrum stitch(const std::vector<SpectrumPart>& parts) {
  std::map<long, Step> steps;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const SpectrumRing& ring :
         rings_between(parts[p].rings, parts[p].low, parts[p].high)) {
      Step& step =
          steps[std::lround(std::log10(ring.wavevector) * rows_per_decade)];
      step.all.add(ring);
      step.by_part[p].add(ring);
    }
  if (steps.empty())
    refuse_argument("rings in the reliable ranges", 0.0, "> 0");
  StitchedSpectrum stitched;
  std::vector<LogSums> shared(parts.size());
  for (const auto& [number, step] : steps) {
    const LogSums& all = step.all;
    stitched.rows.push_back({std::exp(all.log_q / all.weight),
                             std::exp(all.log_density / all.weight), all.weight,
                             all.mean_square_height});
    if (step.by_part.size() < 2)
      continue;
    for (const auto& [p, sums] : step.by_part) {
      shared[p].weight += sums.weight;
      shared[p].log_density += sums.weight * log_ratio(sums, all);
    }
  }
  for (const LogSums& sums : shared)
    stitched.ratios.push_back(sums.weight > 0.0
                                  ? std::exp(sums.log_density / sums.weight)
                                  : not_a_number);
  stitched.gaps = gaps_between(parts);
  return stitched;
}

std::string spectrum_table(const std::vector<SpectrumRing>& rows,
                           const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments)
    text += "# " + comment + "\n";
  text += "# q [1/m]  C [m^4], <h^2> = 2 pi int q C dq\n";
  for (const SpectrumRing& row : rows)
    text += fmt::format("{:.8e} {:.8e}\n", row.wavevector, row.density);
  return text;
}

} // namespace asperity::surfaces
