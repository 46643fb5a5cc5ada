#include "md/interface/interface_kernel.hpp"

#include <array>

namespace asperity::md {
namespace {

// Processors differ in their SIMD width. Every operation rounds identically for
// all widths, and the lanes of a strip are summed in a fixed order.
using Four [[gnu::vector_size(4 * sizeof(double))]] = double;
using Two [[gnu::vector_size(2 * sizeof(double))]] = double;

template <class Vector>
struct Lanes {
  static constexpr std::size_t width = sizeof(Vector) / sizeof(double);
  static constexpr std::size_t parts = strip_width / width; ///< vectors per
                                                            ///< strip

  /// Unaligned vector in an array of doubles.
  using Unaligned [[gnu::aligned(alignof(double)), gnu::may_alias]] = Vector;

  using Strip = std::array<Vector, parts>;

  [[gnu::always_inline]] static double total(const Strip& strip) {
    if constexpr (parts == 1)
      return (strip[0][0] + strip[0][1]) + (strip[0][2] + strip[0][3]);
    else
      return (strip[0][0] + strip[0][1]) + (strip[1][0] + strip[1][1]);
  }
};

// The dependency chain from distance to force is long, and a processor keeps
// only few pairs in flight. Strips are therefore processed in bundles, one
// operation at a time for all strips of a bundle.
constexpr std::size_t bundle = 32;

template <class Vector>
[[gnu::always_inline]] inline AtomSum sum_pairs(const ReducedLaw& law,
                                                const Window& window,
                                                double spacing, double z) {
  using Lanes = md::Lanes<Vector>;
  constexpr std::size_t parts = Lanes::parts;
  typename Lanes::Strip x, energy{}, force_x{}, force_y{}, force_z{};
  for (std::size_t lane = 0; lane < strip_width; ++lane)
    x[lane / Lanes::width][lane % Lanes::width] =
        window.x - spacing * static_cast<double>(lane);
  const Vector y_end = Vector{} + law.y_end;
  const Vector width = Vector{} + law.width;
  const double rise = 2.0 / 3.0 * law.square;
  const double bend = 0.5 * law.cube;

  Vector dx[bundle * parts], dz[bundle * parts], inverse[bundle * parts];
  Vector force[bundle * parts];
  for (auto strips = window.strips; !strips.empty();) {
    const std::size_t count = strips.size() < bundle ? strips.size() : bundle;
    for (std::size_t i = 0; i < count; ++i) {
      const double dy = window.y - strips[i].y;
      const double* heights = window.heights + strips[i].height;
      for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t j = i * parts + part;
        dx[j] = x[part] - strips[i].x;
        dz[j] = z - *reinterpret_cast<const typename Lanes::Unaligned*>(
                        heights + part * Lanes::width);
        inverse[j] = 1.0 / (dx[j] * dx[j] + dy * dy + dz[j] * dz[j]);
      }
    }
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t j = i * parts + part;
        const Vector y = inverse[j] * inverse[j] * inverse[j];
        const Vector p = (y > y_end ? y : y_end) - y_end;
        const Vector u = p < width ? p : width;
        const Vector v = p - u;
        const Vector u2 = u * u;
        const Vector bent = bend * u; // half of cube u
        energy[part] += u2 * u * (rise + bent) + v * (v + law.lever);
        force[j] = y * inverse[j] * (u2 * (law.square + bent + bent) + v);
      }
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t j = i * parts + part;
        force_x[part] += force[j] * dx[j];
        force_y[part] += force[j] * (window.y - strips[i].y);
        force_z[part] += force[j] * dz[j];
      }
    strips = strips.subspan(count);
  }
  return {Lanes::total(energy), Lanes::total(force_x), Lanes::total(force_y),
          Lanes::total(force_z)};
}

template <class Vector>
[[gnu::always_inline]] inline SymmetricBlock
sum_pair_blocks(const ReducedLaw& law, const Window& window, double spacing,
                double z) {
  using Lanes = md::Lanes<Vector>;
  constexpr std::size_t parts = Lanes::parts;
  typename Lanes::Strip x, push{}, xx{}, yy{}, zz{}, xy{}, xz{}, yz{};
  for (std::size_t lane = 0; lane < strip_width; ++lane)
    x[lane / Lanes::width][lane % Lanes::width] =
        window.x - spacing * static_cast<double>(lane);
  const Vector y_end = Vector{} + law.y_end;
  const Vector width = Vector{} + law.width;
  const double slope_square = 1.5 * law.square; // 3/4 of G'
  const double slope_cube = 2.25 * law.cube;

  Vector dx[bundle * parts], dz[bundle * parts], inverse[bundle * parts];
  for (auto strips = window.strips; !strips.empty();) {
    const std::size_t count = strips.size() < bundle ? strips.size() : bundle;
    for (std::size_t i = 0; i < count; ++i) {
      const double dy = window.y - strips[i].y;
      const double* heights = window.heights + strips[i].height;
      for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t j = i * parts + part;
        dx[j] = x[part] - strips[i].x;
        dz[j] = z - *reinterpret_cast<const typename Lanes::Unaligned*>(
                        heights + part * Lanes::width);
        inverse[j] = 1.0 / (dx[j] * dx[j] + dy * dy + dz[j] * dz[j]);
      }
    }
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t j = i * parts + part;
        const double dy = window.y - strips[i].y;
        const Vector y = inverse[j] * inverse[j] * inverse[j];
        const Vector p = (y > y_end ? y : y_end) - y_end;
        const Vector u = p < width ? p : width;
        const Vector steepness = u * u * (law.square + law.cube * u) + (p - u);
        const Vector slope = u * (slope_square + slope_cube * u);
        const Vector over_steepness = y * inverse[j];
        const Vector bend =
            8.0 * over_steepness * inverse[j] * (y * slope + steepness);
        const Vector bend_x = bend * dx[j];
        const Vector bend_y = bend * dy;
        push[part] += over_steepness * steepness;
        xx[part] += bend_x * dx[j];
        yy[part] += bend_y * dy;
        zz[part] += bend * dz[j] * dz[j];
        xy[part] += bend_x * dy;
        xz[part] += bend_x * dz[j];
        yz[part] += bend_y * dz[j];
      }
    strips = strips.subspan(count);
  }
  const double pushed = Lanes::total(push);
  return {Lanes::total(xx) - pushed, Lanes::total(yy) - pushed,
          Lanes::total(zz) - pushed, Lanes::total(xy),
          Lanes::total(xz),          Lanes::total(yz)};
}

#ifdef __x86_64__
[[gnu::target("avx2")]] SymmetricBlock
sum_blocks_four_wide(const ReducedLaw& law, const Window& window,
                     double spacing, double z) {
  return sum_pair_blocks<Four>(law, window, spacing, z);
}

[[gnu::target("avx2")]] AtomSum sum_four_wide(const ReducedLaw& law,
                                              const Window& window,
                                              double spacing, double z) {
  return sum_pairs<Four>(law, window, spacing, z);
}

const bool has_four_wide = __builtin_cpu_supports("avx2") > 0;
#endif

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

AtomSum sum_two_wide(const ReducedLaw& law, const Window& window,
                     double spacing, double z) {
  return sum_pairs<Two>(law, window, spacing, z);
}

AtomSum sum_window(const ReducedLaw& law, const Window& window, double spacing,
                   double z) {
#ifdef __x86_64__
  if (has_four_wide)
    return sum_four_wide(law, window, spacing, z);
#endif
  return sum_two_wide(law, window, spacing, z);
}

SymmetricBlock sum_second_derivatives(const ReducedLaw& law,
                                      const Window& window, double spacing,
                                      double z) {
#ifdef __x86_64__
  if (has_four_wide)
    return sum_blocks_four_wide(law, window, spacing, z);
#endif
  return sum_pair_blocks<Two>(law, window, spacing, z);
}

} // namespace asperity::md
