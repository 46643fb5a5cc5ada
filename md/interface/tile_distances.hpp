#pragma once

// The lanes of the SIMD kernels and the distances of atoms to the atoms of
// their tiles. All functions are inlined into the kernel of an instruction set.

#include "base/simd_pack.hpp"
#include "md/interface/interface_kernel.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace asperity::md {

// Processors differ in their SIMD width. The eight atoms of a tile are summed
// in eight lanes. Every operation rounds identically for all widths, and the
// lanes are added in a fixed order.
constexpr std::size_t n_lanes = std::size_t{tile_columns} * tile_rows;

/// How many tiles further than the present one the distances are stored.
constexpr std::size_t stored_ahead = 5;
constexpr std::size_t n_stored = 8; ///< a power of two
static_assert(stored_ahead < n_stored);

template <std::size_t bytes>
struct Lanes : SimdPack<double, bytes> {
  using Vector = typename SimdPack<double, bytes>::Type;
  using Unaligned = typename SimdPack<double, bytes>::Unaligned;
  static constexpr std::size_t width = SimdPack<double, bytes>::lanes;
  static constexpr std::size_t parts = n_lanes / width; ///< vectors per tile

  /// One number for each lane of a tile.
  using Numbers = std::array<Vector, parts>;

  [[gnu::always_inline]] static double total(const Numbers& numbers) {
    const auto lane = [&](std::size_t i) {
      return numbers[i / width][i % width];
    };
    return ((lane(0) + lane(1)) + (lane(2) + lane(3))) +
           ((lane(4) + lane(5)) + (lane(6) + lane(7)));
  }
};

/// Position of an atom relative to each atom of a tile that begins at the
/// corner.
template <std::size_t bytes>
struct Corner {
  using Lanes = md::Lanes<bytes>;
  using Vector = typename Lanes::Vector;
  typename Lanes::Numbers x{}, y{};

  [[gnu::always_inline]] void set(const Window& window, double spacing) {
    for (std::size_t part = 0; part < Lanes::parts; ++part) {
      Vector columns, rows;
      for (std::size_t i = 0; i < Lanes::width; ++i) {
        const std::size_t lane = part * Lanes::width + i;
        const std::size_t column = lane / tile_rows;
        const std::size_t row = lane % tile_rows;
        columns[i] = static_cast<double>(column);
        rows[i] = static_cast<double>(row);
      }
      x[part] = window.x - spacing * columns;
      y[part] = window.y - spacing * rows;
    }
  }
};

/// The distances of the atoms to all atoms of their tiles, in the order of the
/// windows and of their tiles. Those of the next tiles are stored. After the
/// last window follow some that are not used.
template <std::size_t bytes>
class Distances {
public:
  using Lanes = md::Lanes<bytes>;
  using Vector = typename Lanes::Vector;

  struct OfTile {
    typename Lanes::Numbers square, dz;
  };

  /// @param windows  at least one of them has tiles
  [[gnu::always_inline]] Distances(std::span<const Window> windows,
                                   double spacing, OfTile* stored)
      : windows_(windows), spacing_(spacing), stored_(stored) {
    for (std::size_t i = 0; i < stored_ahead; ++i)
      store_next();
  }

  [[gnu::always_inline]] void next_tile() {
    store_next();
    ++tile_;
  }

  /// r^2 and dz of a vector, counted from the first one of the present tile.
  [[gnu::always_inline]] const Vector& square(std::size_t vector) const {
    return stored(vector).square[vector % Lanes::parts];
  }

  [[gnu::always_inline]] const Vector& dz(std::size_t vector) const {
    return stored(vector).dz[vector % Lanes::parts];
  }

private:
  [[gnu::always_inline]] const OfTile& stored(std::size_t vector) const {
    return stored_[(tile_ + vector / Lanes::parts) % n_stored];
  }

  [[gnu::always_inline]] void store_next() {
    if (source_ == sources_end_) [[unlikely]]
      go_to_next_window();
    OfTile& to = stored_[n_stored_before_++ % n_stored];
    for (std::size_t part = 0; part < Lanes::parts; ++part) {
      using Unaligned = typename Lanes::Unaligned;
      const auto dx = corner_.x[part] - source_->x;
      const auto dy = corner_.y[part] - source_->y;
      const auto dz =
          z_ - *reinterpret_cast<const Unaligned*>(heights_ + source_->height +
                                                   part * Lanes::width);
      to.dz[part] = dz;
      to.square[part] = dx * dx + dy * dy + dz * dz;
    }
    ++source_;
  }

  [[gnu::always_inline]] void go_to_next_window() {
    while (next_ < windows_.size() && windows_[next_].tiles.empty())
      ++next_;
    if (next_ < windows_.size())
      last_ = next_++;
    const Window& window = windows_[last_];
    corner_.set(window, spacing_);
    z_ = window.z;
    heights_ = window.heights;
    source_ = window.tiles.data();
    sources_end_ = source_ + window.tiles.size();
  }

  std::span<const Window> windows_;
  double spacing_;
  std::size_t next_ = 0; ///< index of a window
  std::size_t last_ = 0;

  Corner<bytes> corner_;
  double z_ = 0.0;
  const double* heights_ = nullptr;
  const Tile* source_ = nullptr; ///< whose distances are stored next
  const Tile* sources_end_ = nullptr;

  OfTile* stored_; ///< outside of this object, so that the rest of it stays in
                   ///< registers
  std::size_t n_stored_before_ = 0; ///< tiles
  std::size_t tile_ = 0;
};

} // namespace asperity::md
