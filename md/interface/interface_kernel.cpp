#include "md/interface/interface_kernel.hpp"

#include "base/simd_pack.hpp"

#include <algorithm>
#include <array>

namespace asperity::md {
namespace {

// Processors differ in their SIMD width. Two strips are summed together, in
// eight lanes. Every operation rounds identically for all widths, and the lanes
// are added in a fixed order.
constexpr std::size_t strips_in_pair = 2;
constexpr std::size_t n_lanes = strips_in_pair * strip_width;

/// Beside the last strip of an odd number: no atom reaches it.
constexpr double nowhere = 1e8;

template <std::size_t bytes>
struct Lanes : SimdPack<double, bytes> {
  using Vector = typename SimdPack<double, bytes>::Type;
  static constexpr std::size_t width = SimdPack<double, bytes>::lanes;
  static constexpr std::size_t parts = n_lanes / width; ///< vectors per pair

  /// One number for each lane of a pair of strips.
  using Pair = std::array<Vector, parts>;

  /// Sets the four lanes of either strip to one number.
  [[gnu::always_inline]] static Pair each(double first, double second) {
    Pair pair;
    for (std::size_t part = 0; part < parts; ++part)
      for (std::size_t lane = 0; lane < width; ++lane)
        pair[part][lane] = part * width + lane < strip_width ? first : second;
    return pair;
  }

  /// Four numbers from each of two places.
  [[gnu::always_inline]] static Pair load(const double* first,
                                          const double* second) {
    Pair pair;
    if constexpr (width > strip_width) {
      using Half = SimdPack<double, strip_width * sizeof(double)>;
      pair[0] = __builtin_shufflevector(
          *reinterpret_cast<const typename Half::Unaligned*>(first),
          *reinterpret_cast<const typename Half::Unaligned*>(second), 0, 1, 2,
          3, 4, 5, 6, 7);
    } else {
      for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t lane = part * width;
        pair[part] = *reinterpret_cast<const typename Lanes::Unaligned*>(
            lane < strip_width ? first + lane : second + lane - strip_width);
      }
    }
    return pair;
  }

  [[gnu::always_inline]] static double total(const Pair& pair) {
    const auto lane = [&](std::size_t i) { return pair[i / width][i % width]; };
    return ((lane(0) + lane(1)) + (lane(2) + lane(3))) +
           ((lane(4) + lane(5)) + (lane(6) + lane(7)));
  }
};

// The dependency chain from distance to force is long, and a processor keeps
// only few pairs in flight. Strips are therefore processed in bundles, one
// operation at a time for all strips of a bundle.
constexpr std::size_t bundle = 16; ///< pairs of strips

/// Distances from an atom to the substrate atoms of a bundle of strips.
template <std::size_t bytes>
struct Distances {
  using Lanes = md::Lanes<bytes>;
  typename Lanes::Pair dx[bundle], dy[bundle], dz[bundle];
  typename Lanes::Pair inverse[bundle]; ///< 1/r^2

  /// @param x  of the atom relative to the first atom of a strip at the corner,
  ///           and to the three that follow it
  /// @return   the number of pairs of strips
  [[gnu::always_inline]] std::size_t fill(std::span<const Strip> strips,
                                          const Window& window,
                                          const typename Lanes::Pair& x,
                                          double z) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < strips.size(); i += strips_in_pair, ++count) {
      const Strip& first = strips[i];
      const Strip second = i + 1 < strips.size()
                               ? strips[i + 1]
                               : Strip{nowhere, first.y, first.height};
      const auto strip_x = Lanes::each(first.x, second.x);
      const auto strip_y = Lanes::each(first.y, second.y);
      const auto heights = Lanes::load(window.heights + first.height,
                                       window.heights + second.height);
      for (std::size_t part = 0; part < Lanes::parts; ++part) {
        const auto x_part = x[part] - strip_x[part];
        const auto y_part = window.y - strip_y[part];
        const auto z_part = z - heights[part];
        dx[count][part] = x_part;
        dy[count][part] = y_part;
        dz[count][part] = z_part;
        inverse[count][part] =
            1.0 / (x_part * x_part + y_part * y_part + z_part * z_part);
      }
    }
    return count;
  }
};

/// Returns the coordinate along x of an atom relative to the atoms of a strip
/// that begins at the corner.
template <std::size_t bytes>
[[gnu::always_inline]] inline typename Lanes<bytes>::Pair
along_strips(const Window& window, double spacing) {
  typename Lanes<bytes>::Pair x;
  for (std::size_t lane = 0; lane < n_lanes; ++lane)
    x[lane / Lanes<bytes>::width][lane % Lanes<bytes>::width] =
        window.x - spacing * static_cast<double>(lane % strip_width);
  return x;
}

template <std::size_t bytes>
[[gnu::always_inline]] inline AtomSum sum_pairs(const ReducedLaw& law,
                                                const Window& window,
                                                double spacing, double z) {
  using Lanes = md::Lanes<bytes>;
  using Vector = typename Lanes::Vector;
  const typename Lanes::Pair x = along_strips<bytes>(window, spacing);
  typename Lanes::Pair energy{}, force_x{}, force_y{}, force_z{};
  const Vector y_end = Vector{} + law.y_end;
  const Vector width = Vector{} + law.width;
  const double rise = 2.0 / 3.0 * law.square;
  const double bend = 0.5 * law.cube;

  Distances<bytes> to;
  typename Lanes::Pair force[bundle];
  for (auto strips = window.strips; !strips.empty();) {
    const auto some =
        strips.first(std::min(strips.size(), strips_in_pair * bundle));
    const std::size_t count = to.fill(some, window, x, z);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t part = 0; part < Lanes::parts; ++part) {
        const Vector inverse = to.inverse[i][part];
        const Vector y = inverse * inverse * inverse;
        const Vector p = (y > y_end ? y : y_end) - y_end;
        const Vector u = p < width ? p : width;
        const Vector v = p - u;
        const Vector u2 = u * u;
        const Vector bent = bend * u; // half of cube u
        energy[part] += u2 * u * (rise + bent) + v * (v + law.lever);
        force[i][part] = y * inverse * (u2 * (law.square + bent + bent) + v);
      }
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t part = 0; part < Lanes::parts; ++part) {
        force_x[part] += force[i][part] * to.dx[i][part];
        force_y[part] += force[i][part] * to.dy[i][part];
        force_z[part] += force[i][part] * to.dz[i][part];
      }
    strips = strips.subspan(some.size());
  }
  return {Lanes::total(energy), Lanes::total(force_x), Lanes::total(force_y),
          Lanes::total(force_z)};
}

template <std::size_t bytes>
[[gnu::always_inline]] inline SymmetricBlock
sum_pair_blocks(const ReducedLaw& law, const Window& window, double spacing,
                double z) {
  using Lanes = md::Lanes<bytes>;
  using Vector = typename Lanes::Vector;
  const typename Lanes::Pair x = along_strips<bytes>(window, spacing);
  typename Lanes::Pair push{}, xx{}, yy{}, zz{}, xy{}, xz{}, yz{};
  const Vector y_end = Vector{} + law.y_end;
  const Vector width = Vector{} + law.width;
  const double slope_square = 1.5 * law.square; // 3/4 of G'
  const double slope_cube = 2.25 * law.cube;

  Distances<bytes> to;
  for (auto strips = window.strips; !strips.empty();) {
    const auto some =
        strips.first(std::min(strips.size(), strips_in_pair * bundle));
    const std::size_t count = to.fill(some, window, x, z);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t part = 0; part < Lanes::parts; ++part) {
        const Vector dx = to.dx[i][part];
        const Vector dy = to.dy[i][part];
        const Vector dz = to.dz[i][part];
        const Vector inverse = to.inverse[i][part];
        const Vector y = inverse * inverse * inverse;
        const Vector p = (y > y_end ? y : y_end) - y_end;
        const Vector u = p < width ? p : width;
        const Vector steepness = u * u * (law.square + law.cube * u) + (p - u);
        const Vector slope = u * (slope_square + slope_cube * u);
        const Vector over_steepness = y * inverse;
        const Vector bend =
            8.0 * over_steepness * inverse * (y * slope + steepness);
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
    strips = strips.subspan(some.size());
  }
  const double pushed = Lanes::total(push);
  return {Lanes::total(xx) - pushed, Lanes::total(yy) - pushed,
          Lanes::total(zz) - pushed, Lanes::total(xy),
          Lanes::total(xz),          Lanes::total(yz)};
}

using SumPairs = AtomSum (*)(const ReducedLaw&, const Window&, double, double);
using SumBlocks = SymmetricBlock (*)(const ReducedLaw&, const Window&, double,
                                     double);

struct Kernels {
  SumPairs pairs;
  SumBlocks blocks;
};

#ifdef __x86_64__
[[gnu::target("avx2")]] AtomSum pairs_on_avx2(const ReducedLaw& law,
                                              const Window& window,
                                              double spacing, double z) {
  return sum_pairs<32>(law, window, spacing, z);
}

[[gnu::target("avx2")]] SymmetricBlock blocks_on_avx2(const ReducedLaw& law,
                                                      const Window& window,
                                                      double spacing,
                                                      double z) {
  return sum_pair_blocks<32>(law, window, spacing, z);
}

[[gnu::target("avx512f,avx512dq,avx512vl")]] AtomSum
pairs_on_avx512(const ReducedLaw& law, const Window& window, double spacing,
                double z) {
  return sum_pairs<64>(law, window, spacing, z);
}

[[gnu::target("avx512f,avx512dq,avx512vl")]] SymmetricBlock
blocks_on_avx512(const ReducedLaw& law, const Window& window, double spacing,
                 double z) {
  return sum_pair_blocks<64>(law, window, spacing, z);
}
#endif

Kernels kernels_here() {
#ifdef __x86_64__
  if (has_avx512())
    return {pairs_on_avx512, blocks_on_avx512};
  if (has_avx2())
    return {pairs_on_avx2, blocks_on_avx2};
#endif
  return {sum_pairs<16>, sum_pair_blocks<16>};
}

const Kernels kernels = kernels_here();

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

AtomSum sum_window(const ReducedLaw& law, const Window& window, double spacing,
                   double z) {
  return kernels.pairs(law, window, spacing, z);
}

SymmetricBlock sum_second_derivatives(const ReducedLaw& law,
                                      const Window& window, double spacing,
                                      double z) {
  return kernels.blocks(law, window, spacing, z);
}

std::vector<AtomSum> sums_of_all_widths(const ReducedLaw& law,
                                        const Window& window, double spacing,
                                        double z) {
  std::vector<AtomSum> sums{sum_pairs<16>(law, window, spacing, z)};
#ifdef __x86_64__
  if (has_avx2())
    sums.push_back(pairs_on_avx2(law, window, spacing, z));
  if (has_avx512())
    sums.push_back(pairs_on_avx512(law, window, spacing, z));
#endif
  return sums;
}

} // namespace asperity::md
