#include "contact/operators/mirrored_operator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::contact {
namespace {

/// Of heights that were filtered by transforms, relative to the largest.
constexpr double roundoff_of_heights = 1e-12;

} // namespace

MirroredOperator::MirroredOperator(Symbol symbol, int threads)
    : SurfaceOperator(
          {.rows = SharedRows(quarter_of(symbol.compliance->grid())),
           .short_wave_compliance = symbol.short_wave,
           .threads = threads,
           .is_mirrored = true,
           .has_inverse = true}),
      symbol_(std::move(symbol)),
      exact_(symbol_.compliance->grid(), threads),
      convolution_(symbol_.compliance->grid(), threads) {}

std::unique_ptr<SurfaceOperator> MirroredOperator::do_clone() const {
  return std::make_unique<MirroredOperator>(symbol_, threads());
}

std::unique_ptr<SurfaceOperator> MirroredOperator::do_coarsened() const {
  if (!coarse_grid(grid()))
    return nullptr;
  const std::unique_ptr<SurfaceOperator> coarse = symbol_.whole->coarsened();
  return coarse ? coarse->mirrored() : nullptr;
}

void MirroredOperator::do_displacement(std::span<const double> pressure,
                                       std::span<double> displacement) {
  exact_.apply(pressure, columns_of(*symbol_.compliance), displacement);
}

void MirroredOperator::do_pressure_of(std::span<const double> displacement,
                                      std::span<double> pressure) {
  exact_.apply(displacement, inverse_columns_of(*symbol_.compliance), pressure);
}

void MirroredOperator::do_displacement_change(
    std::span<const float> pressure_change,
    std::span<float> displacement_change) {
  convolution_.apply(pressure_change, columns_of(*symbol_.compliance),
                     displacement_change);
}

void MirroredOperator::do_pressure_estimate(std::span<const float> gap,
                                            double local_compliance,
                                            std::span<float> pressure) {
  const EvenColumn known = columns_of(*symbol_.compliance);
  const EvenColumn compliance = [&](int jx, std::span<double> of_jy) {
    known(jx, of_jy);
    if (jx == 0) // the uniform mode has none: FourierOperator
      of_jy[0] = symbol_.softest;
  };
  convolution_.apply(gap, inverse_columns_of(compliance, local_compliance),
                     pressure);
}

bool equals_mirror_images(std::span<const double> heights, const Grid& grid) {
  const double accepted =
      roundoff_of_heights *
      std::abs(*std::ranges::max_element(
          heights, {}, [](double height) { return std::abs(height); }));
  for (int y = 0; y < grid.points_y; ++y)
    for (int x = 0; x < grid.points_x; ++x) {
      const double own = heights[grid.index(x, y)];
      const int over_x = grid.points_x - 1 - x;
      const int over_y = grid.points_y - 1 - y;
      if (!(std::abs(heights[grid.index(over_x, y)] - own) <= accepted &&
            std::abs(heights[grid.index(x, over_y)] - own) <= accepted))
        return false;
    }
  return true;
}

std::vector<double> first_quarter(std::span<const double> whole,
                                  const Grid& cell) {
  const Grid grid = quarter_of(cell);
  const auto width = static_cast<std::size_t>(grid.points_x);
  std::vector<double> quarter(grid.size());
  for (std::size_t at = 0; at < quarter.size(); at += width)
    std::ranges::copy(whole.subspan(2 * at, width), &quarter[at]);
  return quarter;
}

std::vector<double> unfolded(std::span<const double> quarter,
                             const Grid& cell) {
  const auto width = static_cast<std::size_t>(cell.points_x) / 2;
  const auto height = static_cast<std::size_t>(cell.points_y);
  std::vector<double> whole;
  whole.reserve(cell.size());
  for (std::size_t y = 0; y < height; ++y) {
    const auto row =
        quarter.subspan(std::min(y, height - 1 - y) * width, width);
    whole.insert(whole.end(), row.begin(), row.end());
    whole.insert(whole.end(), row.rbegin(), row.rend());
  }
  return whole;
}

} // namespace asperity::contact
