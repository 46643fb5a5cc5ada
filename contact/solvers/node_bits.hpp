#pragma once

// Sets of the nodes of a periodic grid, a bit a node: neighbours of 64 nodes at
// a time.

#include "base/grid.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace asperity::contact {

class NodeBits {
public:
  using Word = std::uint64_t;

  explicit NodeBits(const Grid& grid);

  int words_a_row() const { return words_; }

  /// The nodes 64 * word + 0..63 of a row, the first in the lowest bit; bits
  /// past the end of the row are 0 and must stay so.
  Word& at(int iy, int word) { return bits_[index(iy, word)]; }

  Word at(int iy, int word) const { return bits_[index(iy, word)]; }

  /// The bits of a word that are nodes.
  Word valid(int word) const {
    return word + 1 == words_ ? last_valid_ : ~Word{};
  }

  /// The bits of a word whose nodes lie at the border of the grid's storage:
  /// their neighbours are not where those of the others are.
  Word border(int iy, int word) const;

  /// Takes a row from flags, 0 or not.
  /// @param flags  grid.points_x values
  void assign_row(int iy, std::span<const std::uint8_t> flags);

  /// Whether the eight neighbours of each node are in the set: the four beside
  /// it, then the four across. Bits past the end of the row mean nothing.
  std::array<Word, 8> neighbours(int iy, int word) const;

private:
  struct Row {
    Word west, here, east;
  };

  std::size_t index(int iy, int word) const {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(words_) +
           static_cast<std::size_t>(word);
  }

  /// A word of a row, and its nodes' neighbours in that row.
  Row row(int iy, int word) const;

  int width_, height_, words_;
  Word last_valid_;
  std::vector<Word> bits_;
};

} // namespace asperity::contact
