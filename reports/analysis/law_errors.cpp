#include "reports/analysis/law_errors.hpp"

#include "reports/analysis/comparison.hpp"
#include "reports/analysis/summary.hpp"
#include "reports/numbers/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity::reports {
namespace {

using results::CurvePoint;
using results::MethodRecord;

constexpr double least_area = 0.01;
constexpr double largest_area = 0.99;
constexpr double largest_gap_of_laws = 2.0; // in h_rms
constexpr std::size_t fewest_loads = 3;

/// A number of all realisations at one load.
struct LoadOfAll {
  std::vector<double> theory;
  std::vector<double> found;
};

const CurvePoint* row_of_step(const MethodRecord& method,
                              std::size_t realization, int step) {
  const auto& points =
      method.realizations[std::min(realization, method.realizations.size() - 1)]
          .points;
  const auto row = std::ranges::find(points, step, &CurvePoint::step);
  return row == points.end() || row->status != results::StepStatus::converged
             ? nullptr
             : &*row;
}

double mean_of_drawn(const std::vector<double>& values,
                     std::span<const std::size_t> drawn) {
  double sum = 0.0;
  for (const std::size_t index : drawn)
    sum += values[index];
  return sum / static_cast<double>(drawn.size());
}

Estimate rms_deviation(const std::vector<LoadOfAll>& loads,
                       std::size_t realizations, bool is_relative) {
  if (loads.size() < fewest_loads)
    return {.remark = "fewer than 3 loads that theory and method share are in "
                      "the range of the comparison"};
  return bootstrap(realizations, [&](std::span<const std::size_t> drawn) {
    double squares = 0.0;
    for (const LoadOfAll& load : loads) {
      const double found = mean_of_drawn(load.found, drawn);
      const double deviation = mean_of_drawn(load.theory, drawn) - found;
      squares += std::pow(is_relative ? deviation / found : deviation, 2);
    }
    return std::sqrt(squares / static_cast<double>(loads.size()));
  });
}

/// Compares the rows of one theory with those of one method.
class LawComparison {
public:
  LawComparison(const results::Result& result, const cases::Case& contact_case,
                const MethodRecord& theory, const MethodRecord& method)
      : theory_(theory), method_(method), n_(method.realizations.size()) {
    heights_.reserve(n_);
    for (std::size_t r = 0; r < n_; ++r)
      heights_.push_back(scales_of(result, contact_case, method, r).rms_height);
    for (const CurvePoint& row : method.realizations.front().points)
      if (!row.is_unloading)
        add_step(row.step);
  }

  void put_into(std::map<std::string, Estimate>& quantities) const {
    quantities["law_area_error"] = rms_deviation(area_, n_, true);
    quantities["law_energy_error"] = rms_deviation(energy_, n_, true);
    quantities["law_gap_error"] = rms_deviation(gap_, n_, false);
  }

private:
  void add_step(int step) {
    LoadOfAll area, energy, gap;
    for (std::size_t r = 0; r < n_; ++r) {
      const CurvePoint* const law = row_of_step(theory_, r, step);
      const CurvePoint* const row = row_of_step(method_, r, step);
      if (law == nullptr || row == nullptr)
        return;
      area.theory.push_back(law->area_fraction);
      area.found.push_back((*row)[*best_area(method_)]);
      energy.theory.push_back(law->elastic_energy);
      energy.found.push_back(row->elastic_energy);
      gap.theory.push_back(law->mean_gap / heights_[r]);
      gap.found.push_back(row->mean_gap / heights_[r]);
    }
    const double mean_area = mean_of_all(area.found);
    if (mean_area >= least_area && mean_area <= largest_area) {
      area_.push_back(area);
      energy_.push_back(energy);
    }
    const double mean_gap = mean_of_all(gap.found);
    if (mean_gap > 0.0 && mean_gap <= largest_gap_of_laws)
      gap_.push_back(gap);
  }

  double mean_of_all(const std::vector<double>& values) const {
    double sum = 0.0;
    for (const double value : values)
      sum += value;
    return sum / static_cast<double>(n_);
  }

  const MethodRecord& theory_;
  const MethodRecord& method_;
  std::size_t n_;
  std::vector<double> heights_;
  std::vector<LoadOfAll> area_, energy_, gap_;
};

} // namespace

void add_law_errors(const results::Result& result,
                    const cases::Case& contact_case, const MethodRecord& theory,
                    std::map<std::string, Estimate>& quantities) {
  if (theory.realizations.empty()) // of a run that was interrupted
    return;
  for (const MethodRecord& method : result.methods)
    if (method.kind != "theory" && !method.realizations.empty() &&
        !magnification_of(contact_case, method)) {
      LawComparison(result, contact_case, theory, method).put_into(quantities);
      return;
    }
}

} // namespace asperity::reports
