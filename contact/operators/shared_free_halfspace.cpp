#include "contact/operators/shared_free_halfspace.hpp"

#include "base/require.hpp"
#include "contact/operators/free_halfspace.hpp"

#include <functional>
#include <utility>
#include <vector>

#include "ranks/rank_sums.hpp"

namespace asperity::contact {
namespace {

/// Bounds of the rows of a wide grid: nearly equal shares that begin at
/// multiples of a power of two, so that the ranks also share rows of cells of
/// BoundaryExtension.
std::vector<int> wide_bounds(const Grid& wide, int n_ranks) {
  constexpr int least_steps = 16; // of a rank
  int step = 2;
  while (2 * step * least_steps * n_ranks <= wide.points_y)
    step *= 2;
  const int steps = (wide.points_y + step - 1) / step;
  std::vector<int> bounds(static_cast<std::size_t>(n_ranks) + 1, wide.points_y);
  for (int r = 0; r < n_ranks; ++r)
    bounds[static_cast<std::size_t>(r)] = steps * r / n_ranks * step;
  return bounds;
}

SharedRows wide_rows(const Grid& grid, RankGroup& ranks) {
  const Grid wide = grid_with_margin(grid);
  return {wide, ranks, wide_bounds(wide, ranks.size())};
}

EvenSymbol rectangle_symbol(const SharedConvolution<float>& convolution,
                            RankGroup& ranks, double contact_modulus) {
  const Grid& grid = convolution.grid();
  return {grid, ranks, rectangle_kernel(grid, contact_modulus),
          convolution.columns(), convolution.threads()};
}

} // namespace

SharedFreeHalfspace::SharedFreeHalfspace(const Grid& grid, RankGroup& ranks,
                                         double contact_modulus, int threads)
    : SharedFreeHalfspace(
          std::make_shared<const Rows>(
              Rows{SharedRows(grid, ranks, row_bounds(grid, ranks.size())),
                   wide_rows(grid, ranks)}),
          threads) {
  keep(rectangle_symbol(convolution_, ranks, contact_modulus),
       rectangle_symbol(wide_convolution_, ranks, contact_modulus));
}

SharedFreeHalfspace::SharedFreeHalfspace(std::shared_ptr<const Rows> rows,
                                         int threads)
    : rows_(std::move(rows)),
      exact_(rows_->own, padded_grid(grid()), threads),
      convolution_(rows_->own, padded_grid(grid()), threads),
      wide_convolution_(rows_->wide, threads) {}

void SharedFreeHalfspace::keep(EvenSymbol compliance,
                               EvenSymbol wide_compliance) {
  const SpectrumColumns own = convolution_.columns();
  const int quarter = grid().points_x / 2; // of the points of the padded grid
  const auto column = static_cast<std::size_t>(quarter);
  const bool has_column = column >= own.first && column < own.first + own.count;
  const double short_wave =
      rank_max(&ranks(), has_column ? compliance(quarter, 0) : 0.0);
  SharedConvolution<float>::Symbol symbol =
      convolution_.arranged(std::cref(compliance));
  symbols_ = std::make_shared<const Symbols>(
      Symbols{std::move(compliance), std::move(wide_compliance), short_wave,
              std::move(symbol)});
}

std::unique_ptr<SurfaceOperator> SharedFreeHalfspace::clone() const {
  std::unique_ptr<SharedFreeHalfspace> copy(
      new SharedFreeHalfspace(rows_, threads()));
  copy->symbols_ = symbols_;
  return copy;
}

std::unique_ptr<SurfaceOperator> SharedFreeHalfspace::coarsened() const {
  const std::optional<Grid> every_second = coarse_grid(grid());
  if (!every_second)
    return nullptr;
  const Grid& coarse = *every_second;
  const EvenSymbol& fine = symbols_->compliance;
  const EvenSymbol& wide = symbols_->wide_compliance;
  std::vector<int> bounds = rows_->own.bounds();
  for (int& bound : bounds)
    bound /= 2;
  if (!holds_whole_groups(coarse, bounds)) {
    const auto kept = [&](const EvenSymbol& symbol, const Grid& grid) {
      return symbol.coarsened(grid, ranks(), all_columns(grid));
    };
    EvenSymbol compliance = kept(fine, padded_grid(coarse));
    return std::make_unique<FreeHalfspace>(coarse, std::move(compliance),
                                           kept(wide, grid_with_margin(coarse)),
                                           threads());
  }
  std::unique_ptr<SharedFreeHalfspace> half(new SharedFreeHalfspace(
      std::make_shared<const Rows>(Rows{SharedRows(coarse, ranks(), bounds),
                                        wide_rows(coarse, ranks())}),
      threads()));
  const auto kept = [&](const EvenSymbol& symbol,
                        const SharedConvolution<float>& convolution) {
    return symbol.coarsened(convolution.grid(), ranks(), convolution.columns());
  };
  EvenSymbol compliance = kept(fine, half->convolution_);
  half->keep(std::move(compliance), kept(wide, half->wide_convolution_));
  return half;
}

void SharedFreeHalfspace::displacement(std::span<const double> pressure,
                                       std::span<double> displacement) {
  // A step needs it two or three times, so that nothing is kept for it, and the
  // memory of the other convolutions is free meanwhile.
  convolution_.free_scratch();
  wide_convolution_.free_scratch();
  exact_.apply(pressure, std::cref(symbols_->compliance), displacement);
  exact_.free_scratch();
}

void SharedFreeHalfspace::displacement_change(
    std::span<const float> pressure_change,
    std::span<float> displacement_change) {
  convolution_.apply(pressure_change, symbols_->symbol, displacement_change);
}

void SharedFreeHalfspace::pressure_estimate(std::span<const float> gap,
                                            double local_compliance,
                                            std::span<float> pressure) {
  convolution_.apply(
      gap, inverse_.of(convolution_, symbols_->compliance, local_compliance),
      pressure);
}

void SharedFreeHalfspace::wide_pressure_estimate(std::span<const float> gap,
                                                 double local_compliance,
                                                 std::span<float> pressure) {
  wide_convolution_.apply(gap,
                          wide_inverse_.of(wide_convolution_,
                                           symbols_->wide_compliance,
                                           local_compliance),
                          pressure);
}

} // namespace asperity::contact
