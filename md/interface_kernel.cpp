#include "md/interface_kernel.hpp"

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

// The processor keeps few pairs in flight, and from the distance to the force
// is a long way: so strips go through in bundles, each step for all of them.
constexpr std::size_t bundle = 32;

[[ASPERITY_WIDE]] void sum_pairs(const ReducedLaw& law, const Window& window,
                                 double spacing, double z, AtomSum& sum) {
  const Vector x = window.x - spacing * Vector{0.0, 1.0, 2.0, 3.0};
  const Vector width = Vector{} + law.width;
  const double rise = 2.0 / 3.0 * law.square;
  const double bend = 0.5 * law.cube;
  Vector energy{}, force_x{}, force_y{}, force_z{};
  Vector dx[bundle], dz[bundle], inverse[bundle], force[bundle];
  for (auto strips = window.strips; !strips.empty();) {
    const std::size_t count = strips.size() < bundle ? strips.size() : bundle;
    for (std::size_t i = 0; i < count; ++i) {
      const Strip& strip = strips[i];
      const double dy = window.y - strip.y;
      dx[i] = x - strip.x;
      dz[i] = z - *reinterpret_cast<const UnalignedVector*>(window.heights +
                                                            strip.height);
      inverse[i] = 1.0 / (dx[i] * dx[i] + dy * dy + dz[i] * dz[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Vector y = inverse[i] * inverse[i] * inverse[i];
      Vector p = y - law.y_end;
      p = p > 0.0 ? p : Vector{};
      const Vector u = p < width ? p : width;
      const Vector v = p - u;
      const Vector u2 = u * u;
      energy += u2 * u * (rise + bend * u) + v * (v + law.lever);
      force[i] = y * inverse[i] * (u2 * (law.square + law.cube * u) + v);
    }
    for (std::size_t i = 0; i < count; ++i) {
      force_x += force[i] * dx[i];
      force_y += force[i] * (window.y - strips[i].y);
      force_z += force[i] * dz[i];
    }
    strips = strips.subspan(count);
  }
  const auto total = [](const Vector& v) {
    return (v[0] + v[1]) + (v[2] + v[3]);
  };
  sum = {total(energy), total(force_x), total(force_y), total(force_z)};
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

AtomSum sum_window(const ReducedLaw& law, const Window& window, double spacing,
                   double z) {
  AtomSum sum;
  sum_pairs(law, window, spacing, z, sum);
  return sum;
}

} // namespace asperity::md
