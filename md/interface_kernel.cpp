#include "md/interface_kernel.hpp"

#include <cmath>

namespace asperity::md {
namespace {

// Four doubles, whatever the processor has: the compiler makes two of two or
// one of four of them, and every operation rounds alike.
using Vector [[gnu::vector_size(strip_width * sizeof(double))]] = double;
using UnalignedVector [[gnu::vector_size(strip_width * sizeof(double)),
                        gnu::aligned(8), gnu::may_alias]] = double;

#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__)
#define ASPERITY_WIDE gnu::target_clones("avx2", "default")
#else
#define ASPERITY_WIDE gnu::hot
#endif

template <bool has_attraction>
[[gnu::always_inline]] inline void
sum_pairs(const ReducedLaw& law, std::span<const Strip> strips,
          const double* heights, double spacing, double z, AtomSum& sum) {
  const Vector steps = spacing * Vector{0.0, 1.0, 2.0, 3.0};
  const double width = law.y_begin - law.y_end;
  Vector energy{}, force_x{}, force_y{}, force_z{};
  for (const Strip& strip : strips) {
    const Vector h =
        *reinterpret_cast<const UnalignedVector*>(heights + strip.first);
    const Vector dx = strip.x - steps;
    const Vector dz = z - h;
    const Vector inverse = 1.0 / (dx * dx + strip.y * strip.y + dz * dz);
    const Vector y = inverse * inverse * inverse;

    Vector u = y - law.y_end;
    u = u > 0.0 ? u : Vector{};
    u = u < width ? u : Vector{} + width;
    const Vector y_max = y > law.y_begin ? y : Vector{} + law.y_begin;
    const Vector u2 = u * u;
    Vector lever = y_max + law.y_begin;
    Vector slope = y;
    if constexpr (has_attraction) {
      lever -= 2.0 * law.attraction;
      slope -= law.attraction;
    }
    energy +=
        (y_max - law.y_begin) * lever +
        u2 * u * (law.rise + u * (law.rise_slope + u * law.rise_curvature));
    const Vector force =
        (y * inverse) * slope * (u2 * (law.taper_square + law.taper_cube * u));
    force_x += force * dx;
    force_y += force * strip.y;
    force_z += force * dz;
  }
  const auto total = [](const Vector& v) {
    return (v[0] + v[1]) + (v[2] + v[3]);
  };
  sum = {total(energy), total(force_x), total(force_y), total(force_z)};
}

[[ASPERITY_WIDE]] void sum_repulsion(const ReducedLaw& law,
                                     std::span<const Strip> strips,
                                     const double* heights, double spacing,
                                     double z, AtomSum& sum) {
  sum_pairs<false>(law, strips, heights, spacing, z, sum);
}

[[ASPERITY_WIDE]] void sum_attraction(const ReducedLaw& law,
                                      std::span<const Strip> strips,
                                      const double* heights, double spacing,
                                      double z, AtomSum& sum) {
  sum_pairs<true>(law, strips, heights, spacing, z, sum);
}

} // namespace

ReducedLaw reduced(const Interaction& interaction) {
  const double begin =
      std::pow(interaction.distance / interaction.taper_begin, 6);
  const double end = std::pow(interaction.distance / interaction.cutoff, 6);
  const double width = begin - end;
  const double lever = end - interaction.attraction;
  return {begin,
          end,
          interaction.attraction,
          3.0 / (width * width),
          -2.0 / (width * width * width),
          2.0 * lever / (width * width),
          1.5 / (width * width) - lever / (width * width * width),
          -0.8 / (width * width * width)};
}

AtomSum sum_strips(const ReducedLaw& law, std::span<const Strip> strips,
                   const double* heights, double spacing, double z) {
  AtomSum sum;
  if (law.attraction == 0.0)
    sum_repulsion(law, strips, heights, spacing, z, sum);
  else
    sum_attraction(law, strips, heights, spacing, z, sum);
  return sum;
}

} // namespace asperity::md
