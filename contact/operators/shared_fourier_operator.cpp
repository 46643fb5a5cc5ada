#include "contact/operators/shared_fourier_operator.hpp"

#include "base/parallel_rows.hpp"
#include "base/require.hpp"
#include "contact/operators/fourier_operator.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "ranks/rank_sums.hpp"

namespace asperity::contact {
namespace {

std::vector<double> on_half_spectrum(const Grid& grid,
                                     const ComplianceColumn& compliance) {
  const std::size_t columns = grid.half_spectrum_columns();
  const auto rows = static_cast<std::size_t>(grid.points_y);
  std::vector<double> values(grid.half_spectrum_size());
  std::vector<double> column(rows / 2 + 1);
  for (std::size_t jx = 0; jx < columns; ++jx) {
    compliance(static_cast<int>(jx), column);
    for (std::size_t jy = 0; jy < rows; ++jy)
      values[jy * columns + jx] = column[std::min(jy, rows - jy)];
  }
  values[0] = 0.0;
  return values;
}

} // namespace

SharedFourierOperator::SharedFourierOperator(const Grid& grid, RankGroup& ranks,
                                             ComplianceColumn compliance,
                                             int threads)
    : SharedFourierOperator(
          SharedRows(grid, ranks, row_bounds(grid, ranks.size())),
          std::move(compliance), threads) {}

SharedFourierOperator::SharedFourierOperator(SharedRows rows,
                                             ComplianceColumn compliance,
                                             int threads)
    : SharedFourierOperator(std::make_shared<const SharedRows>(std::move(rows)),
                            std::move(compliance), threads) {
  find_symbols();
}

SharedFourierOperator::SharedFourierOperator(
    std::shared_ptr<const SharedRows> rows, ComplianceColumn compliance,
    int threads)
    : rows_(std::move(rows)),
      compliance_(std::move(compliance)),
      threads_(threads),
      exact_(*rows_, threads),
      convolution_(*rows_, threads),
      first_column_(convolution_.columns().first) {}

void SharedFourierOperator::find_symbols() {
  const std::size_t height = static_cast<std::size_t>(grid().points_y) / 2 + 1;
  const SharedConvolution<float>::Columns own = convolution_.columns();
  std::vector<double> columns(own.count * height);
  parallel_rows(static_cast<int>(own.count), threads_, [&](int k) {
    take_column(static_cast<int>(own.first) + k,
                std::span(columns).subspan(static_cast<std::size_t>(k) * height,
                                           height));
  });
  softest_ =
      rank_max(rows_->ranks(),
               columns.empty() ? 0.0 : *std::ranges::max_element(columns));
  columns_ = std::make_shared<const std::vector<double>>(std::move(columns));
  symbol_ = std::make_shared<const SharedConvolution<float>::Symbol>(
      convolution_.arranged(
          [this](int jx, int jy) { return compliance_at(jx, jy); }));
}

void SharedFourierOperator::take_column(int jx, std::span<double> of_jy) const {
  compliance_(jx, of_jy);
  if (jx == 0)
    of_jy[0] = 0.0;
  for (const double value : of_jy.subspan(jx == 0 ? 1 : 0))
    require_positive("compliance", value, "m/Pa");
}

double SharedFourierOperator::compliance_at(int jx, int jy) const {
  const std::size_t height = static_cast<std::size_t>(grid().points_y) / 2 + 1;
  return (*columns_)[(static_cast<std::size_t>(jx) - first_column_) * height +
                     static_cast<std::size_t>(jy)];
}

std::unique_ptr<SurfaceOperator> SharedFourierOperator::clone() const {
  std::unique_ptr<SharedFourierOperator> copy(
      new SharedFourierOperator(rows_, compliance_, threads_));
  copy->columns_ = columns_;
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
  std::vector<double> column(along_x ? 1
                                     : static_cast<std::size_t>(quarter) + 1);
  take_column(along_x ? quarter : 0, column);
  return column.back();
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
  return std::make_unique<SharedFourierOperator>(
      SharedRows(coarse, *rows_->ranks(), bounds), compliance_, threads_);
}

void SharedFourierOperator::displacement(std::span<const double> pressure,
                                         std::span<double> displacement) {
  // A step needs it two or three times, so that nothing is kept for it, and the
  // memory of the other convolution is free meanwhile.
  convolution_.free_scratch();
  exact_.apply(
      pressure, [this](int jx, int jy) { return compliance_at(jx, jy); },
      displacement);
  exact_.free_scratch();
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
          jx == 0 && jy == 0 ? softest_ : compliance_at(jx, jy);
      return 1.0 / (value + local_compliance);
    });
    inverted_compliance_ = local_compliance;
  }
  convolution_.apply(gap, inverse_, pressure);
}

} // namespace asperity::contact
