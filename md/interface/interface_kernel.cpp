#include "md/interface/interface_kernel.hpp"

#include "base/simd_pack.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace asperity::md {

// Processors differ in their SIMD width. The eight atoms of a tile are summed
// in eight lanes. Every operation rounds identically for all widths, and the
// lanes are added in a fixed order.
constexpr std::size_t n_lanes = std::size_t{tile_columns} * tile_rows;

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

/// What a pair contributes by the law of ReducedLaw, in each lane.
template <std::size_t bytes>
struct PairLaw {
  using Vector = typename Lanes<bytes>::Vector;
  Vector y_end, y_begin, square, third, cube, lever;

  [[gnu::always_inline]] explicit PairLaw(const ReducedLaw& law)
      : y_end(Vector{} + law.y_end),
        y_begin(Vector{} + (law.y_end + law.width)),
        square(Vector{} + law.square),
        third(Vector{} + law.square / 3.0),
        cube(Vector{} + law.cube),
        lever(Vector{} + law.lever) {}
};

/// The pairs of an atom with one vector of a tile.
template <std::size_t bytes>
struct Pairs {
  using Lanes = md::Lanes<bytes>;
  using Vector = typename Lanes::Vector;
  Vector dx, dy, dz;
  Vector inverse; ///< 1/r^2
  Vector y, u, v; ///< of ReducedLaw

  [[gnu::always_inline]] Pairs(const PairLaw<bytes>& law, const Window& window,
                               const Corner<bytes>& corner, const Tile& tile,
                               std::size_t part)
      : dx(corner.x[part] - tile.x),
        dy(corner.y[part] - tile.y),
        dz(window.z - *reinterpret_cast<const typename Lanes::Unaligned*>(
                          window.heights + tile.height + part * Lanes::width)),
        inverse(1.0 / (dx * dx + dy * dy + dz * dz)),
        y(inverse * inverse * inverse) {
    const Vector above = y > law.y_end ? y : law.y_end;
    const Vector tapered = above < law.y_begin ? above : law.y_begin;
    u = tapered - law.y_end;
    v = above - tapered;
  }
};

namespace {

template <std::size_t bytes>
[[gnu::always_inline]] inline double
sum_pairs(const ReducedLaw& reduced, std::span<const Window> windows,
          double spacing, std::span<AtomForce> forces) {
  using Lanes = md::Lanes<bytes>;
  using Vector = typename Lanes::Vector;
  const PairLaw<bytes> law(reduced);
  typename Lanes::Numbers tapered{}, full{};
  for (std::size_t atom = 0; atom < windows.size(); ++atom) {
    const Window& window = windows[atom];
    Corner<bytes> corner;
    corner.set(window, spacing);
    // The sum of f (corner - tile) is corner times the sum of f, minus f tile.
    typename Lanes::Numbers sum{}, tile_x{}, tile_y{}, force_z{};
    for (const Tile& tile : window.tiles)
      for (std::size_t part = 0; part < Lanes::parts; ++part) {
        const Pairs<bytes> pairs(law, window, corner, tile, part);
        const Vector &u = pairs.u, &v = pairs.v;
        const Vector u2 = u * u;
        const Vector steepness = u2 * (law.square + law.cube * u);
        tapered[part] += u * (steepness + law.third * u2);
        full[part] += v * (v + law.lever);
        const Vector force = pairs.y * pairs.inverse * (steepness + v);
        sum[part] += force;
        tile_x[part] += force * tile.x;
        tile_y[part] += force * tile.y;
        force_z[part] += force * pairs.dz;
      }
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
  const PairLaw<bytes> law(reduced);
  const double slope_square = 1.5 * reduced.square; // 3/4 of G'
  const double slope_cube = 2.25 * reduced.cube;
  for (std::size_t atom = 0; atom < windows.size(); ++atom) {
    const Window& window = windows[atom];
    Corner<bytes> corner;
    corner.set(window, spacing);
    typename Lanes::Numbers push{}, xx{}, yy{}, zz{}, xy{}, xz{}, yz{};
    for (const Tile& tile : window.tiles)
      for (std::size_t part = 0; part < Lanes::parts; ++part) {
        const Pairs<bytes> pairs(law, window, corner, tile, part);
        const Vector &u = pairs.u, &dx = pairs.dx, &dy = pairs.dy,
                     &dz = pairs.dz;
        const Vector steepness = u * u * (law.square + law.cube * u) + pairs.v;
        const Vector slope = u * (slope_square + slope_cube * u);
        const Vector over_steepness = pairs.y * pairs.inverse;
        const Vector bend = 8.0 * over_steepness * pairs.inverse *
                            (pairs.y * slope + steepness);
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
    const double pushed = Lanes::total(push);
    blocks[atom] = {Lanes::total(xx) - pushed, Lanes::total(yy) - pushed,
                    Lanes::total(zz) - pushed, Lanes::total(xy),
                    Lanes::total(xz),          Lanes::total(yz)};
  }
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
  return on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    return sum_pairs<bytes()>(law, windows, spacing, forces);
  });
}

void sum_second_derivatives(const ReducedLaw& law,
                            std::span<const Window> windows, double spacing,
                            std::span<SymmetricBlock> blocks) {
  on_this_processor([&](auto bytes) __attribute__((always_inline)) {
    sum_pair_blocks<bytes()>(law, windows, spacing, blocks);
  });
}

} // namespace asperity::md
