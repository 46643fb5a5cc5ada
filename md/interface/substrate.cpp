#include "md/interface/substrate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace asperity::md {
namespace {

constexpr int block_width = 4;
constexpr int parts = 4; ///< per side of a cell; each has its own lists of
                         ///< tiles

std::size_t as_index(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

/// A tile by the column and the row of its first atom, relative to a corner.
struct TilePlace {
  int column = 0;
  int row = 0;
};

/// A part of a cell, with a small margin for roundoff, and a radius around it.
struct Surroundings {
  double column = 0.0; ///< where the part begins
  double row = 0.0;
  double radius_square = 0.0; ///< in spacings^2
  double side = 1.0 / parts + 1e-9;

  /// Extends a range of columns to those of a row that are within the radius of
  /// any point of the part.
  void extend(int of_row, int& first, int& last) const {
    const double across = std::max({0.0, row - of_row, of_row - row - side});
    if (across * across > radius_square)
      return;
    const double half_chord = std::sqrt(radius_square - across * across) + 1e-9;
    first = std::min(first, static_cast<int>(std::ceil(column - half_chord)));
    last = std::max(last,
                    static_cast<int>(std::floor(column + side + half_chord)));
  }

  /// Covers these columns by tiles of which the lowest begin at a row.
  std::vector<TilePlace> tiles_from(int lowest) const {
    const int farthest = static_cast<int>(std::sqrt(radius_square)) + 2;
    std::vector<TilePlace> tiles;
    for (int j = lowest; j <= farthest; j += tile_rows) {
      int first = std::numeric_limits<int>::max();
      int last = std::numeric_limits<int>::min();
      for (int of_row = j; of_row < j + tile_rows; ++of_row)
        extend(of_row, first, last);
      for (int i = first; i <= last; i += tile_columns)
        tiles.push_back({i, j});
    }
    return tiles;
  }

  /// The shorter of the two lists that begin at an even and at an odd row.
  std::vector<TilePlace> tiles() const {
    const int lowest = -static_cast<int>(std::sqrt(radius_square)) - 2;
    auto even = tiles_from(lowest);
    auto odd = tiles_from(lowest + 1);
    return odd.size() < even.size() ? odd : even;
  }
};

} // namespace

Substrate::Substrate(const Grid& grid, std::span<const double> heights,
                     double reach, double unit)
    : reach_(reach / unit),
      spacing_(grid.spacing_x() / unit),
      per_spacing_(1.0 / spacing_),
      reach_square_((reach_ / spacing_) * (reach_ / spacing_)),
      margin_(static_cast<int>(std::ceil(reach_ / spacing_)) + 1 +
              tile_columns),
      blocks_((grid.points_x + block_width - 1) / block_width) {
  pad(grid, heights, unit);
  find_highest(grid.points_x);
  list_tiles();
}

void Substrate::pad(const Grid& grid, std::span<const double> heights,
                    double unit) {
  stride_ = grid.points_x + 2 * margin_;
  paired_.reserve(2 * as_index(stride_ * stride_));
  for (int iy = -margin_; iy < grid.points_y + margin_; ++iy)
    for (int ix = -margin_; ix < grid.points_x + margin_; ++ix)
      for (const int row : {iy, iy + 1})
        paired_.push_back(heights[grid.periodic_index(ix, row)] / unit);
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
      const double* heights = paired_.data() + 2 * (row * stride_);
      double& highest =
          along_x[as_index(row) * as_index(blocks_) + as_index(block)];
      highest = heights[std::int64_t{2} * begin(block)];
      for (std::int64_t column = begin(block); column < end(block); ++column)
        highest = std::max(highest, heights[2 * column]);
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
void Substrate::list_tiles() {
  const int n_radii = static_cast<int>(reach_square_) + 1;
  for (int radius_square = 1; radius_square <= n_radii; ++radius_square)
    for (int row = 0; row < parts; ++row)
      for (int column = 0; column < parts; ++column) {
        list_begins_.push_back(tiles_.size());
        const Surroundings around{
            column / double{parts}, row / double{parts},
            std::min<double>(radius_square, reach_square_)};
        for (const auto& [i, j] : around.tiles())
          tiles_.push_back({i * spacing_, j * spacing_, 2 * (j * stride_ + i)});
      }
  list_begins_.push_back(tiles_.size());
}

Window Substrate::window(const LatticePoint& point, double z) const {
  const int column = static_cast<int>(point.column);
  const int row = static_cast<int>(point.row);
  const double x = point.column - column;
  const double y = point.row - row;
  Window window{x * spacing_,
                y * spacing_,
                z,
                paired_.data() +
                    2 * ((row + margin_) * stride_ + column + margin_),
                {}};

  const double highest =
      highest_[as_index(row / block_width) * as_index(blocks_) +
               as_index(column / block_width)];
  const double above = std::max(z - highest, 0.0);
  if (above >= reach_)
    return window;
  const double rise = above * per_spacing_;
  const int radius = static_cast<int>(reach_square_ - rise * rise);
  const int part =
      static_cast<int>(y * parts) * parts + static_cast<int>(x * parts);
  const std::size_t list = as_index(radius * parts * parts + part);
  window.tiles = std::span(tiles_).subspan(
      list_begins_[list], list_begins_[list + 1] - list_begins_[list]);
  return window;
}

double Substrate::height_at(const LatticePoint& point) const {
  const auto column = static_cast<std::int64_t>(point.column);
  const auto row = static_cast<std::int64_t>(point.row);
  const double x = point.column - static_cast<double>(column);
  const double y = point.row - static_cast<double>(row);
  const double* corner =
      paired_.data() + 2 * ((row + margin_) * stride_ + column + margin_);
  const double below = corner[0] + x * (corner[2] - corner[0]);
  const double beyond = corner[1] + x * (corner[3] - corner[1]);
  return below + y * (beyond - below);
}

} // namespace asperity::md
