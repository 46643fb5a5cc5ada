#include "contact/solvers/node_bits.hpp"

#include <algorithm>
#include <cstring>

namespace asperity::contact {
namespace {

constexpr int word_bits = 64;

/// Bit k of the result tells whether byte k of the eight flags is not 0.
std::uint64_t packed(const std::uint8_t* flags) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, flags, 8);
  bytes |= bytes >> 4 & 0x0f0f0f0f0f0f0f0fU;
  bytes |= bytes >> 2 & 0x0303030303030303U;
  bytes |= bytes >> 1;
  // The product moves bit 8 k to bit 56 + k without a carry.
  return (bytes & 0x0101010101010101U) * 0x0102040810204080U >> 56;
}

} // namespace

NodeBits::NodeBits(const SharedRows& rows)
    : rows_(&rows),
      width_(rows.grid().points_x),
      words_((width_ + word_bits - 1) / word_bits),
      last_valid_(~Word{} >> (words_ * word_bits - width_)),
      bits_(index(rows.count() + 1, 0)) {}

NodeBits::Word NodeBits::border(int iy, int word) const {
  const int row_of_grid = rows_->first() + iy;
  if (row_of_grid == 0 || row_of_grid + 1 == rows_->grid().points_y)
    return valid(word);
  const Word first = word == 0 ? 1U : 0U;
  const Word last =
      word + 1 == words_ ? last_valid_ & ~(last_valid_ >> 1) : Word{};
  return first | last;
}

void NodeBits::assign_row(int iy, std::span<const std::uint8_t> flags) {
  for (int word = 0; word < words_; ++word) {
    const int first = word * word_bits;
    const int n = std::min(word_bits, width_ - first);
    const std::uint8_t* const here = flags.data() + first;
    Word bits = 0;
    int k = 0;
    for (; k + 8 <= n; k += 8)
      bits |= packed(here + k) << k;
    for (; k < n; ++k)
      bits |= Word{here[k] > 0} << k;
    at(iy, word) = bits;
  }
}

NodeBits::Row NodeBits::row(int iy, int word) const {
  const Word* const words = &bits_[index(iy, 0)];
  const int last = words_ - 1;
  const int last_bit = (width_ - 1) % word_bits;
  const Word here = words[word];
  const Word before =
      word > 0 ? words[word - 1] >> (word_bits - 1) : words[last] >> last_bit;
  const Word after = word < last ? words[word + 1] << (word_bits - 1)
                                 : (words[0] & 1U) << last_bit;
  return {here << 1 | before, here, here >> 1 | after};
}

std::array<NodeBits::Word, 8> NodeBits::neighbours(int iy, int word) const {
  const Row below = row(iy - 1, word);
  const Row level = row(iy, word);
  const Row above = row(iy + 1, word);
  return {level.west, level.east, below.here, above.here,
          below.west, below.east, above.west, above.east};
}

} // namespace asperity::contact
