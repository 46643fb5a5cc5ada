#include "md/interface/interface_kernel.hpp"

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

using SumPairs = double (*)(const ReducedLaw&, std::span<const Window>, double,
                            std::span<AtomForce>);
using SumBlocks = void (*)(const ReducedLaw&, std::span<const Window>, double,
                           std::span<SymmetricBlock>);

struct Kernels {
  SumPairs pairs;
  SumBlocks blocks;
};

#ifdef __x86_64__
[[gnu::target("avx2")]] double pairs_on_avx2(const ReducedLaw& law,
                                             std::span<const Window> windows,
                                             double spacing,
                                             std::span<AtomForce> forces) {
  return sum_pairs<32>(law, windows, spacing, forces);
}

[[gnu::target("avx2")]] void blocks_on_avx2(const ReducedLaw& law,
                                            std::span<const Window> windows,
                                            double spacing,
                                            std::span<SymmetricBlock> blocks) {
  sum_pair_blocks<32>(law, windows, spacing, blocks);
}

[[gnu::target("avx512f,avx512dq,avx512vl")]] double
pairs_on_avx512(const ReducedLaw& law, std::span<const Window> windows,
                double spacing, std::span<AtomForce> forces) {
  return sum_pairs<64>(law, windows, spacing, forces);
}

[[gnu::target("avx512f,avx512dq,avx512vl")]] void
blocks_on_avx512(const ReducedLaw& law, std::span<const Window> windows,
                 double spacing, std::span<SymmetricBlock> blocks) {
  sum_pair_blocks<64>(law, windows, spacing, blocks);
}
#endif

/// The kernels that this processor has, two lanes first.
std::vector<Kernels> kernels_here() {
  std::vector<Kernels> kernels{{sum_pairs<16>, sum_pair_blocks<16>}};
#ifdef __x86_64__
  if (has_avx2())
    kernels.push_back({pairs_on_avx2, blocks_on_avx2});
  if (has_avx512())
    kernels.push_back({pairs_on_avx512, blocks_on_avx512});
#endif
  return kernels;
}

const Kernels kernels = kernels_here().back();

bool have_tiles(std::span<const Window> windows) {
  return std::any_of(windows.begin(), windows.end(), [](const Window& window) {
    return !window.tiles.empty();
  });
}

double sum_with(const SumPairs& sum_pairs, const ReducedLaw& law,
                std::span<const Window> windows, double spacing,
                std::span<AtomForce> forces) {
  if (have_tiles(windows))
    return sum_pairs(law, windows, spacing, forces);
  std::fill(forces.begin(), forces.end(), AtomForce{});
  return 0.0;
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
  return sum_with(kernels.pairs, law, windows, spacing, forces);
}

void sum_second_derivatives(const ReducedLaw& law,
                            std::span<const Window> windows, double spacing,
                            std::span<SymmetricBlock> blocks) {
  if (have_tiles(windows))
    kernels.blocks(law, windows, spacing, blocks);
  else
    std::fill(blocks.begin(), blocks.end(), SymmetricBlock{});
}

std::vector<WindowSums> sums_of_all_widths(const ReducedLaw& law,
                                           std::span<const Window> windows,
                                           double spacing) {
  std::vector<WindowSums> sums;
  for (const Kernels& each : kernels_here()) {
    std::vector<AtomForce> forces(windows.size());
    const double energy = sum_with(each.pairs, law, windows, spacing, forces);
    sums.push_back({energy, forces});
  }
  return sums;
}

} // namespace asperity::md
