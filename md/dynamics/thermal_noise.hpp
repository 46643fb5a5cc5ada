#pragma once

// The random kicks of a thermostat: fixed by seed, step and unknown, not by
// when they are drawn or on which thread. Owns their generator.

#include <cstdint>
#include <span>

namespace asperity::md {

/// Independent standard normal numbers for all unknowns of one step:
/// Philox-4x64-10 with
///
///     key = (seed, RandomStream::thermal_noise),  counter = (step, i / 4, 0,
///     0)
///
/// whose four words make unknowns i..i+3 by Box and Muller's polar angles.
/// @param numbers  overwritten
/// @see  surfaces/maps/random_modes.hpp
void draw_normal(std::uint64_t seed, std::int64_t step, int threads,
                 std::span<double> numbers);

} // namespace asperity::md
