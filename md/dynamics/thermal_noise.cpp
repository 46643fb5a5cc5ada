#include "md/dynamics/thermal_noise.hpp"

#include "base/parallel_rows.hpp"
#include "surfaces/maps/random_modes.hpp"

#include <Random123/philox.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace asperity::md {
namespace {

constexpr std::size_t random_words = 4;
constexpr std::size_t chunk = 1024 * random_words; // unknowns per parallel task

/// Returns (k + 1/2) 2^-52 for the upper 52 bits k, which is never 0 and never
/// 1.
double to_unit_interval(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

std::array<double, random_words> draw(std::uint64_t seed, std::int64_t step,
                                      std::uint64_t block) {
  using Generator = r123::Philox4x64;
  const Generator::key_type key{
      {seed,
       static_cast<std::uint64_t>(surfaces::RandomStream::thermal_noise)}};
  const Generator::ctr_type counter{
      {static_cast<std::uint64_t>(step), block, 0, 0}};
  const Generator::ctr_type bits = Generator{}(counter, key);
  std::array<double, random_words> normal{};
  for (std::size_t i = 0; i < random_words; i += 2) {
    const double radius = std::sqrt(-2.0 * std::log(to_unit_interval(bits[i])));
    const double angle = 2.0 * std::numbers::pi * to_unit_interval(bits[i + 1]);
    normal[i] = radius * std::cos(angle);
    normal[i + 1] = radius * std::sin(angle);
  }
  return normal;
}

} // namespace

void draw_normal(std::uint64_t seed, std::int64_t step, int threads,
                 std::span<double> numbers) {
  const auto n_chunks = static_cast<int>((numbers.size() + chunk - 1) / chunk);
  parallel_rows(n_chunks, threads, [&](int row) {
    const std::size_t begin = static_cast<std::size_t>(row) * chunk;
    const std::size_t end = std::min(begin + chunk, numbers.size());
    for (std::size_t i = begin; i < end; i += random_words) {
      const std::array<double, random_words> normal =
          draw(seed, step, i / random_words);
      std::copy_n(normal.begin(), std::min(random_words, end - i),
                  numbers.begin() + static_cast<std::ptrdiff_t>(i));
    }
  });
}

} // namespace asperity::md
