#pragma once

// The random numbers of a surface: one independent draw a mode, fixed by what
// the mode is and not by when it is drawn. Owns the counter-based generator.

#include <cstdint>

namespace asperity::surfaces {

/// Named streams of random numbers: draws of different streams never meet.
/// The numbers are part of what a seed means and never change.
enum class RandomStream : std::uint64_t {
  surface_modes = 1,
  thermal_noise = 2, ///< drawn in md/dynamics/thermal_noise.hpp
  stress_scenes = 3, ///< drawn in robustness/scene.hpp
};

/// Two independent numbers, uniform in the open interval (0, 1).
struct UniformPair {
  double first = 0.0;
  double second = 0.0;
};

/// What makes one realisation different from another.
struct RandomKey {
  std::uint64_t seed = 0;
  int realization = 0; ///< >= 0
  RandomStream stream = RandomStream::surface_modes;
};

/// The draw of mode (wavenumber_x, wavenumber_y): Philox-4x64-10 with
///
///     key = (seed, stream),  counter = (i, j, realization, 0),
///
/// i and j in two's complement; its first two words' upper 52 bits, plus a
/// half, are the pair. Same bits on every platform, in every order of calls.
/// @see  J. K. Salmon et al., Parallel random numbers: as easy as 1, 2, 3,
///       SC11 (2011)
UniformPair draw_mode(const RandomKey& key, int wavenumber_x, int wavenumber_y);

} // namespace asperity::surfaces
