#include "contact/operators/shared_fourier_operator.hpp"

#include "base/require.hpp"
#include "contact/operators/chunked_sum.hpp"
#include "contact/operators/fourier_operator.hpp"

#include <algorithm>
#include <atomic>
#include <utility>
#include <vector>

namespace asperity::contact {
namespace {

std::vector<double> on_half_spectrum(const Grid& grid,
                                     const std::function<double(double)>& of) {
  std::vector<double> values;
  values.reserve(grid.half_spectrum_size());
  values.push_back(0.0);
  for (int jy = 0; jy < grid.points_y; ++jy)
    for (int jx = jy == 0 ? 1 : 0; jx <= grid.points_x / 2; ++jx)
      values.push_back(of(wavevector_size(grid, jx, jy)));
  return values;
}

/// The larger of the numbers of all ranks. Collective.
double largest_of_ranks(RankGroup& ranks, double own) {
  std::vector<double> all(static_cast<std::size_t>(ranks.size()));
  const std::vector<std::size_t> counts(all.size(), sizeof(double));
  ranks.gather_to_all(std::as_bytes(std::span(&own, 1)), counts,
                      std::as_writable_bytes(std::span(all)));
  return *std::ranges::max_element(all);
}

} // namespace

SharedFourierOperator::SharedFourierOperator(
    const Grid& grid, RankGroup& ranks,
    std::function<double(double)> compliance, int threads)
    : SharedFourierOperator(std::make_shared<const SharedRows>(
                                grid, ranks, row_bounds(grid, ranks.size())),
                            std::move(compliance), threads) {
  find_symbols();
}

SharedFourierOperator::SharedFourierOperator(
    std::shared_ptr<const SharedRows> rows,
    std::function<double(double)> compliance, int threads)
    : rows_(std::move(rows)),
      compliance_(std::move(compliance)),
      threads_(threads),
      exact_(*rows_, threads),
      convolution_(*rows_, threads) {}

void SharedFourierOperator::find_symbols() {
  std::atomic<double> largest = 0.0;
  const auto compliance_of = [&](int jx, int jy) {
    if (jx == 0 && jy == 0)
      return 0.0;
    const double value = checked_compliance(jx, jy);
    double before = largest;
    while (value > before && !largest.compare_exchange_weak(before, value))
      continue;
    return value;
  };
  exact_symbol_ = std::make_shared<const SharedConvolution<double>::Symbol>(
      exact_.arranged(compliance_of));
  symbol_ = std::make_shared<const SharedConvolution<float>::Symbol>(
      convolution_.arranged(compliance_of));
  softest_ = largest_of_ranks(*rows_->ranks(), largest);
}

double SharedFourierOperator::checked_compliance(int jx, int jy) const {
  const double value = compliance_(wavevector_size(grid(), jx, jy));
  require_positive("compliance", value, "m/Pa");
  return value;
}

std::unique_ptr<SurfaceOperator> SharedFourierOperator::clone() const {
  std::unique_ptr<SharedFourierOperator> copy(
      new SharedFourierOperator(rows_, compliance_, threads_));
  copy->exact_symbol_ = exact_symbol_;
  copy->symbol_ = symbol_;
  copy->softest_ = softest_;
  return copy;
}

double SharedFourierOperator::short_wave_compliance() const {
  // Half the Nyquist wavevector, as in FourierOperator.
  const bool along_x = grid().points_x >= 4;
  const int quarter = (along_x ? grid().points_x : grid().points_y) / 4;
  if (quarter == 0)
    return softest_;
  return along_x ? checked_compliance(quarter, 0)
                 : checked_compliance(0, quarter);
}

std::unique_ptr<SurfaceOperator> SharedFourierOperator::coarsened() const {
  const std::optional<Grid> every_second = coarse_grid(grid());
  if (!every_second)
    return nullptr;
  const Grid& coarse = *every_second;
  std::vector<int> bounds = rows_->bounds();
  for (int& bound : bounds)
    bound /= 2;
  if (!holds_whole_groups(coarse, bounds))
    return std::make_unique<FourierOperator>(
        coarse, on_half_spectrum(coarse, compliance_), threads_);
  std::unique_ptr<SharedFourierOperator> shared(new SharedFourierOperator(
      std::make_shared<const SharedRows>(coarse, *rows_->ranks(), bounds),
      compliance_, threads_));
  shared->find_symbols();
  return shared;
}

void SharedFourierOperator::displacement(std::span<const double> pressure,
                                         std::span<double> displacement) {
  exact_.apply(pressure, *exact_symbol_, displacement);
  exact_.free_scratch(); // a step needs it two or three times
}

void SharedFourierOperator::displacement_change(
    std::span<const float> pressure_change,
    std::span<float> displacement_change) {
  convolution_.apply(pressure_change, *symbol_, displacement_change);
}

void SharedFourierOperator::pressure_estimate(std::span<const float> gap,
                                              double local_compliance,
                                              std::span<float> pressure) {
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  if (inverted_compliance_ != local_compliance) {
    // The compliance of the uniform mode is undefined here; that of the longest
    // wavelength replaces it.
    inverse_ = convolution_.arranged([&](int jx, int jy) {
      const double value =
          jx == 0 && jy == 0 ? softest_ : checked_compliance(jx, jy);
      return 1.0 / (value + local_compliance);
    });
    inverted_compliance_ = local_compliance;
  }
  convolution_.apply(gap, inverse_, pressure);
}

} // namespace asperity::contact
