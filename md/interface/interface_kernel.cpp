#include "md/interface/interface_kernel.hpp"

#include "base/simd_pack.hpp"

#include <algorithm>
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

// A division takes as long as half of the other operations of a tile, and the
// chain of operations from a distance to a force is too long for a processor to
// have enough tiles in flight. Each turn of the loop therefore works on several
// vectors: it computes the distances of one, divides for an earlier one, begins
// the law of a still earlier one and completes that of the first.
constexpr std::size_t divided_ahead = 3; ///< vectors
static_assert(divided_ahead < stored_ahead);

/// The law of ReducedLaw for the lanes of a vector, in two steps.
template <std::size_t bytes>
struct Law {
  using Vector = typename Lanes<bytes>::Vector;
  Vector y_end, y_begin, square, third, cube, lever;

  [[gnu::always_inline]] explicit Law(const ReducedLaw& law)
      : y_end(Vector{} + law.y_end),
        y_begin(Vector{} + (law.y_end + law.width)),
        square(Vector{} + law.square),
        third(Vector{} + law.square / 3.0),
        cube(Vector{} + law.cube),
        lever(Vector{} + law.lever) {}

  /// y, u and v of 1/r^2.
  [[gnu::always_inline]] void begin(const Vector& inverse, Vector& y, Vector& u,
                                    Vector& v) const {
    y = inverse * inverse * inverse;
    const Vector above = y > y_end ? y : y_end;
    const Vector tapered = above < y_begin ? above : y_begin;
    u = tapered - y_end;
    v = above - tapered;
  }
};

/// Goes through all tiles, one vector per turn.
template <std::size_t bytes>
class Turns {
public:
  using Lanes = md::Lanes<bytes>;
  using Vector = typename Lanes::Vector;

  [[gnu::always_inline]] Turns(const Law<bytes>& law,
                               std::span<const Window> windows, double spacing,
                               typename Distances<bytes>::OfTile* stored)
      : law_(law), distances_(windows, spacing, stored) {
    for (std::size_t i = 0; i < divided_ahead; ++i)
      inverse_[i] = 1.0 / distances_.square(i);
    law_.begin(inverse_[0], y_, u_, v_);
  }

  /// Gives 1/r^2, y, u and v of the vector of this turn and begins a later one.
  [[gnu::always_inline]] void next(std::size_t part, Vector& inverse, Vector& y,
                                   Vector& u, Vector& v) {
    const Vector latest = 1.0 / distances_.square(part + divided_ahead);
    inverse = inverse_[0];
    y = y_;
    u = u_;
    v = v_;
    for (std::size_t i = 0; i + 1 < divided_ahead; ++i)
      inverse_[i] = inverse_[i + 1];
    inverse_[divided_ahead - 1] = latest;
    law_.begin(inverse_[0], y_, u_, v_);
  }

  [[gnu::always_inline]] const Vector& dz(std::size_t part) const {
    return distances_.dz(part);
  }

  [[gnu::always_inline]] void next_tile() { distances_.next_tile(); }

private:
  Law<bytes> law_;
  Distances<bytes> distances_;
  Vector inverse_[divided_ahead];
  Vector y_, u_, v_;
};

namespace {

template <std::size_t bytes>
[[gnu::always_inline]] inline double
sum_pairs(const ReducedLaw& reduced, std::span<const Window> windows,
          double spacing, std::span<AtomForce> forces) {
  using Lanes = md::Lanes<bytes>;
  using Vector = typename Lanes::Vector;
  const Law<bytes> law(reduced);
  typename Distances<bytes>::OfTile stored[n_stored];
  Turns<bytes> turns(law, windows, spacing, stored);
  typename Lanes::Numbers tapered{}, full{};
  for (std::size_t atom = 0; atom < windows.size(); ++atom) {
    // The sum of f (corner - tile) is corner times the sum of f, minus f tile.
    typename Lanes::Numbers sum{}, tile_x{}, tile_y{}, force_z{};
    for (const Tile& tile : windows[atom].tiles) {
      for (std::size_t part = 0; part < Lanes::parts; ++part) {
        Vector inverse, y, u, v;
        turns.next(part, inverse, y, u, v);
        const Vector u2 = u * u;
        const Vector steepness = u2 * (law.square + law.cube * u);
        tapered[part] += u * (steepness + law.third * u2);
        full[part] += v * (v + law.lever);
        const Vector force = y * inverse * (steepness + v);
        sum[part] += force;
        tile_x[part] += force * tile.x;
        tile_y[part] += force * tile.y;
        force_z[part] += force * turns.dz(part);
      }
      turns.next_tile();
    }
    Corner<bytes> corner;
    corner.set(windows[atom], spacing);
    for (std::size_t part = 0; part < Lanes::parts; ++part) {
      tile_x[part] = sum[part] * corner.x[part] - tile_x[part];
      tile_y[part] = sum[part] * corner.y[part] - tile_y[part];
    }
    forces[atom] = {Lanes::total(tile_x), Lanes::total(tile_y),
                    Lanes::total(force_z)};
  }
  return 0.5 * Lanes::total(tapered) + Lanes::total(full);
}

template <std::size_t bytes>
[[gnu::always_inline]] inline void
sum_pair_blocks(const ReducedLaw& reduced, std::span<const Window> windows,
                double spacing, std::span<SymmetricBlock> blocks) {
  using Lanes = md::Lanes<bytes>;
  using Vector = typename Lanes::Vector;
  const Law<bytes> law(reduced);
  typename Distances<bytes>::OfTile stored[n_stored];
  Turns<bytes> turns(law, windows, spacing, stored);
  const double slope_square = 1.5 * reduced.square; // 3/4 of G'
  const double slope_cube = 2.25 * reduced.cube;
  for (std::size_t atom = 0; atom < windows.size(); ++atom) {
    Corner<bytes> corner;
    corner.set(windows[atom], spacing);
    typename Lanes::Numbers push{}, xx{}, yy{}, zz{}, xy{}, xz{}, yz{};
    for (const Tile& tile : windows[atom].tiles) {
      for (std::size_t part = 0; part < Lanes::parts; ++part) {
        Vector inverse, y, u, v;
        turns.next(part, inverse, y, u, v);
        const Vector steepness = u * u * (law.square + law.cube * u) + v;
        const Vector slope = u * (slope_square + slope_cube * u);
        const Vector over_steepness = y * inverse;
        const Vector bend =
            8.0 * over_steepness * inverse * (y * slope + steepness);
        const Vector dx = corner.x[part] - tile.x;
        const Vector dy = corner.y[part] - tile.y;
        const Vector dz = turns.dz(part);
        const Vector bend_x = bend * dx;
        const Vector bend_y = bend * dy;
        push[part] += over_steepness * steepness;
        xx[part] += bend_x * dx;
        yy[part] += bend_y * dy;
        zz[part] += bend * dz * dz;
        xy[part] += bend_x * dy;
        xz[part] += bend_x * dz;
        yz[part] += bend_y * dz;
      }
      turns.next_tile();
    }
    const double pushed = Lanes::total(push);
    blocks[atom] = {Lanes::total(xx) - pushed, Lanes::total(yy) - pushed,
                    Lanes::total(zz) - pushed, Lanes::total(xy),
                    Lanes::total(xz),          Lanes::total(yz)};
  }
}

bool have_tiles(std::span<const Window> windows) {
  return std::any_of(windows.begin(), windows.end(), [](const Window& window) {
    return !window.tiles.empty();
  });
}

} // namespace

ReducedLaw reduced(const Interaction& interaction) {
  const auto sixth_power = [&](double r) { // not pow: its last bits vary
    const double ratio = interaction.distance / r;
    const double cube = ratio * ratio * ratio;
    return cube * cube;
  };
  const double begin = sixth_power(interaction.taper_begin);
  const double end = sixth_power(interaction.cutoff);
  const double width = begin - end;
  const double full = begin - interaction.attraction;
  return {end, width, (3.0 * full - width) / (width * width),
          (width - 2.0 * full) / (width * width * width), 2.0 * full};
}

double sum_windows(const ReducedLaw& law, std::span<const Window> windows,
                   double spacing, std::span<AtomForce> forces) {
  if (!have_tiles(windows)) {
    std::fill(forces.begin(), forces.end(), AtomForce{});
    return 0.0;
  }
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    return sum_pairs<bytes()>(law, windows, spacing, forces);
  });
}

void sum_second_derivatives(const ReducedLaw& law,
                            std::span<const Window> windows, double spacing,
                            std::span<SymmetricBlock> blocks) {
  if (!have_tiles(windows)) {
    std::fill(blocks.begin(), blocks.end(), SymmetricBlock{});
    return;
  }
  on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    sum_pair_blocks<bytes()>(law, windows, spacing, blocks);
  });
}

} // namespace asperity::md
