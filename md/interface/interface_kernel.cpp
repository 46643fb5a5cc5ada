#include "md/interface/interface_kernel.hpp"

#include "base/simd_pack.hpp"
#include "md/interface/tile_turns.hpp"

#include <algorithm>

namespace asperity::md {
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
