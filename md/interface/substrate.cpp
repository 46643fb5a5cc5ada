#include "md/interface/substrate.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::md {
namespace {

constexpr int block_width = 4;
constexpr int parts = 4; ///< per side of a cell; each has its own lists of
                         ///< strips

std::size_t as_index(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

} // namespace

Substrate::Substrate(const Grid& grid, std::span<const double> heights,
                     double reach, double unit)
    : reach_(reach / unit),
      spacing_(grid.spacing_x() / unit),
      reach_square_((reach_ / spacing_) * (reach_ / spacing_)),
      margin_(static_cast<int>(std::ceil(reach_ / spacing_)) + 1 + strip_width),
      blocks_((grid.points_x + block_width - 1) / block_width) {
  pad(grid, heights, unit);
  find_highest(grid.points_x);
  list_strips();
}

void Substrate::pad(const Grid& grid, std::span<const double> heights,
                    double unit) {
  stride_ = grid.points_x + 2 * margin_;
  padded_.reserve(as_index(stride_ * stride_));
  for (int iy = -margin_; iy < grid.points_y + margin_; ++iy)
    for (int ix = -margin_; ix < grid.points_x + margin_; ++ix)
      padded_.push_back(heights[grid.periodic_index(ix, iy)] / unit);
}

// Computes the maximum over a square around each block, separably in x and y.
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

// The squared radii are 1, 2, 3 ... spacings^2 up to a value beyond the reach.
void Substrate::list_strips() {
  const int n_radii = static_cast<int>(reach_square_) + 1;
  for (int radius_square = 1; radius_square <= n_radii; ++radius_square)
    for (int row = 0; row < parts; ++row)
      for (int column = 0; column < parts; ++column) {
        list_begins_.push_back(strips_.size());
        list_strips(column / double{parts}, row / double{parts},
                    std::min<double>(radius_square, reach_square_));
      }
  list_begins_.push_back(strips_.size());
}

// Lists, row by row, all columns within the radius of any point of the part,
// with a small margin for roundoff.
void Substrate::list_strips(double column, double row, double radius_square) {
  const double side = 1.0 / parts + 1e-9;
  const int farthest = static_cast<int>(std::sqrt(radius_square)) + 1;
  for (int j = -farthest; j <= farthest + 1; ++j) {
    const double across = std::max({0.0, row - j, j - row - side});
    if (across * across > radius_square)
      continue;
    const double half_chord = std::sqrt(radius_square - across * across) + 1e-9;
    const int last = static_cast<int>(std::floor(column + side + half_chord));
    for (int i = static_cast<int>(std::ceil(column - half_chord)); i <= last;
         i += strip_width)
      strips_.push_back({i * spacing_, j * spacing_, j * stride_ + i});
  }
}

Window Substrate::window(const LatticePoint& point, double z) const {
  const int column = static_cast<int>(point.column);
  const int row = static_cast<int>(point.row);
  const double x = point.column - column;
  const double y = point.row - row;
  Window window{x * spacing_,
                y * spacing_,
                padded_.data() + (row + margin_) * stride_ + column + margin_,
                {}};

  const double highest =
      highest_[as_index(row / block_width) * as_index(blocks_) +
               as_index(column / block_width)];
  const double above = std::max(z - highest, 0.0);
  if (above >= reach_)
    return window;
  const double rise = above / spacing_;
  const int radius = static_cast<int>(reach_square_ - rise * rise);
  const int part =
      static_cast<int>(y * parts) * parts + static_cast<int>(x * parts);
  const std::size_t list = as_index(radius * parts * parts + part);
  window.strips = std::span(strips_).subspan(
      list_begins_[list], list_begins_[list + 1] - list_begins_[list]);
  return window;
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
