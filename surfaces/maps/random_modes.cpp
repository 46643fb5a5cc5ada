#include "surfaces/maps/random_modes.hpp"

#include <Random123/philox.h>

namespace asperity::surfaces {
namespace {

/// (k + 1/2) 2^-52 for the upper 52 bits k: exact, and never 0 or 1.
double to_unit_interval(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

std::uint64_t counter_word(int number) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
}

} // namespace

UniformPair draw_mode(const RandomKey& key, int wavenumber_x,
                      int wavenumber_y) {
  using Generator = r123::Philox4x64;
  const Generator::key_type generator_key{
      {key.seed, static_cast<std::uint64_t>(key.stream)}};
  const Generator::ctr_type counter{{counter_word(wavenumber_x),
                                     counter_word(wavenumber_y),
                                     counter_word(key.realization), 0}};
  const Generator::ctr_type bits = Generator{}(counter, generator_key);
  return {to_unit_interval(bits[0]), to_unit_interval(bits[1])};
}

} // namespace asperity::surfaces
