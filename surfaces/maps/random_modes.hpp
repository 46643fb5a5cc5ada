#pragma once

// The random numbers of a surface: one independent draw per mode from a
// counter-based generator, determined by the mode and not by the order of the
// draws.

#include <cstdint>

namespace asperity::surfaces {

/// Named, independent streams of random numbers. The numerical values enter the
/// generator, so they must never change.
enum class RandomStream : std::uint64_t {
  surface_modes = 1,
  thermal_noise = 2,        ///< drawn in md/dynamics/thermal_noise.hpp
  robustness_instances = 3, ///< drawn in suite/robustness/instance.hpp
};

/// Two independent numbers, uniform in the open interval (0, 1).
struct UniformPair {
  double first = 0.0;
  double second = 0.0;
};

/// Identifies one realisation.
struct RandomKey {
  std::uint64_t seed = 0;
  int realization = 0; ///< >= 0
  RandomStream stream = RandomStream::surface_modes;
};

/// The draw of mode (wavenumber_x, wavenumber_y): Philox-4x64-10 with
///
///     key = (seed, stream),  counter = (i, j, realization, 0),
///
/// with i and j in two's complement. The pair is made of the upper 52 bits of
/// the first two words, plus one half. The result has the same bits on every
/// platform and in every order of calls.
/// @see  J. K. Salmon et al., Parallel random numbers: as easy as 1, 2, 3,
///       SC11 (2011)
UniformPair draw_mode(const RandomKey& key, int wavenumber_x, int wavenumber_y);

} // namespace asperity::surfaces
