#include "md/substrate.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::md {
namespace {

constexpr int block_width = 4;
constexpr int chord_steps = 8;

std::size_t as_index(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

int wrapped(int i, int points) {
  return ((i % points) + points) % points;
}

} // namespace

Substrate::Substrate(const Grid& grid, std::span<const double> heights,
                     double reach, double unit)
    : reach_(reach / unit),
      spacing_(grid.spacing_x() / unit),
      margin_(static_cast<int>(std::ceil(reach_ / spacing_)) + 1 + strip_width),
      blocks_((grid.points_x + block_width - 1) / block_width) {
  pad(grid, heights, unit);
  find_highest(grid.points_x);
  const int n_chords =
      static_cast<int>(chord_steps * reach_ * reach_ / (spacing_ * spacing_)) +
      2;
  for (int i = 1; i <= n_chords; ++i)
    half_chords_.push_back(std::sqrt(i / double{chord_steps}));
}

void Substrate::pad(const Grid& grid, std::span<const double> heights,
                    double unit) {
  stride_ = grid.points_x + 2 * margin_;
  padded_.reserve(as_index(stride_ * stride_));
  for (int iy = -margin_; iy < grid.points_y + margin_; ++iy)
    for (int ix = -margin_; ix < grid.points_x + margin_; ++ix)
      padded_.push_back(heights[grid.index(wrapped(ix, grid.points_x),
                                           wrapped(iy, grid.points_y))] /
                        unit);
}

// The maximum over a square about each block, one direction after the other.
void Substrate::find_highest(int points) {
  const int window = static_cast<int>(std::ceil(reach_ / spacing_));
  const int n_rows = points + 2 * margin_;
  const auto begin = [&](int block) {
    return margin_ + block_width * block - window;
  };
  const auto end = [&](int block) {
    return std::min(begin(block) + block_width + 1 + 2 * window, n_rows);
  };
  std::vector<double> along_x(as_index(n_rows) * as_index(blocks_));
  for (int row = 0; row < n_rows; ++row)
    for (int block = 0; block < blocks_; ++block) {
      const double* heights = padded_.data() + row * stride_;
      along_x[as_index(row) * as_index(blocks_) + as_index(block)] =
          *std::max_element(heights + begin(block), heights + end(block));
    }

  highest_.resize(as_index(blocks_) * as_index(blocks_));
  for (int block_y = 0; block_y < blocks_; ++block_y)
    for (int block = 0; block < blocks_; ++block) {
      double highest = along_x[as_index(begin(block_y)) * as_index(blocks_) +
                               as_index(block)];
      for (int row = begin(block_y); row < end(block_y); ++row)
        highest = std::max(
            highest,
            along_x[as_index(row) * as_index(blocks_) + as_index(block)]);
      highest_[as_index(block_y) * as_index(blocks_) + as_index(block)] =
          highest;
    }
}

void Substrate::find_strips(const LatticePoint& point, double z,
                            std::vector<Strip>& strips) const {
  strips.clear();
  const int block_x = static_cast<int>(point.column) / block_width;
  const int block_y = static_cast<int>(point.row) / block_width;
  const double above = std::max(
      z - highest_[as_index(block_y) * as_index(blocks_) + as_index(block_x)],
      0.0);
  const double radius_square =
      (reach_ * reach_ - above * above) / (spacing_ * spacing_);
  if (!(radius_square > 0.0))
    return;

  const double radius = std::sqrt(radius_square);
  const double column = point.column + margin_;
  const double centre = point.row + margin_;
  const int last_row = static_cast<int>(centre + radius);
  for (int row = static_cast<int>(centre - radius) + 1; row <= last_row;
       ++row) {
    const double across = centre - row;
    const double left = std::max(radius_square - across * across, 0.0);
    const double half =
        half_chords_[as_index(static_cast<int>(chord_steps * left))];
    const int last = static_cast<int>(column + half);
    for (int i = static_cast<int>(column - half) + 1; i <= last;
         i += strip_width)
      strips.push_back(
          {(column - i) * spacing_, across * spacing_, row * stride_ + i});
  }
}

double Substrate::height_at(const LatticePoint& point) const {
  const auto column = static_cast<std::int64_t>(point.column);
  const auto row = static_cast<std::int64_t>(point.row);
  const double x = point.column - static_cast<double>(column);
  const double y = point.row - static_cast<double>(row);
  const double* corner =
      padded_.data() + (row + margin_) * stride_ + column + margin_;
  const double below = corner[0] + x * (corner[1] - corner[0]);
  const double beyond =
      corner[stride_] + x * (corner[stride_ + 1] - corner[stride_]);
  return below + y * (beyond - below);
}

} // namespace asperity::md
