#pragma once

// The random numbers of the thermostat. They are determined by seed, step and
// unknown, independently of the order and the thread in which they are drawn.

#include <cstdint>
#include <span>

namespace asperity::md {

/// Draws independent standard normal numbers for all unknowns of one step from
/// the generator Philox-4x64-10 with
///
///     key = (seed, RandomStream::thermal_noise)
///     counter = (step, i / 4, 0, 0)
///
/// The four words of each counter yield the numbers of unknowns i..i+3 by the
/// Box-Muller transform.
/// @param numbers  overwritten
/// @see  surfaces/maps/random_modes.hpp
void draw_normal(std::uint64_t seed, std::int64_t step, int threads,
                 std::span<double> numbers);

} // namespace asperity::md
