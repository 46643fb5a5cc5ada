#include "ranks/selection.hpp"

#include "base/require.hpp"
#include "ranks/rank_sums.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace asperity {
namespace {

constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63;

/// Bits whose order as an integer is that of the numbers.
std::uint64_t ordered_bits(double number) {
  const auto bits = std::bit_cast<std::uint64_t>(number);
  return (bits & sign_bit) != 0 ? ~bits : bits | sign_bit;
}

double number_of(std::uint64_t ordered) {
  return std::bit_cast<double>((ordered & sign_bit) != 0 ? ordered ^ sign_bit
                                                         : ~ordered);
}

using Counts = std::array<std::size_t, 256>;

/// How many numbers of all ranks continue the known bits by each byte.
/// @param known  the bits above those of the byte
/// @param shift  number of bits below the byte
Counts counts_of(RankGroup* ranks, std::span<const double> own,
                 std::uint64_t known, int shift) {
  Counts counts{};
  for (const double number : own) {
    const std::uint64_t bits = ordered_bits(number);
    if (shift == 56 || (bits >> (shift + 8)) == known)
      ++counts[(bits >> shift) & 0xFFU];
  }
  Counts total{};
  for (const Counts& part :
       values_of_ranks<Counts>(ranks, std::span<const Counts>(&counts, 1)))
    for (std::size_t byte = 0; byte < total.size(); ++byte)
      total[byte] += part[byte];
  return total;
}

} // namespace

double kth_smallest(RankGroup* ranks, std::span<const double> own,
                    std::size_t k) {
  const std::size_t asked = k;
  std::uint64_t known = 0;
  for (int shift = 56; shift >= 0; shift -= 8) {
    const Counts counts = counts_of(ranks, own, known, shift);
    std::size_t byte = 0;
    while (byte < counts.size() && k >= counts[byte])
      k -= counts[byte++];
    if (byte == counts.size())
      refuse_argument("k", static_cast<double>(asked),
                      "below the number of numbers");
    known = (known << 8) | byte;
  }
  return number_of(known);
}

double median(RankGroup* ranks, std::span<const double> own) {
  std::size_t n = 0;
  const std::size_t own_size = own.size();
  for (const std::size_t size : values_of_ranks<std::size_t>(
           ranks, std::span<const std::size_t>(&own_size, 1)))
    n += size;
  if (n == 0)
    return std::numeric_limits<double>::quiet_NaN();
  const double middle = kth_smallest(ranks, own, n / 2);
  return n % 2 == 1 ? middle
                    : 0.5 * (middle + kth_smallest(ranks, own, n / 2 - 1));
}

} // namespace asperity
