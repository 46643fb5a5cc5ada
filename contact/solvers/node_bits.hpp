#pragma once

// This file represents sets of nodes of a periodic grid with one bit per node,
// with neighbour queries for 64 nodes at a time.

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

  /// Nodes 64 * word + 0..63 of a row, the first one in the lowest bit; bits
  /// past the end of the row must remain 0.
  Word& at(int iy, int word) { return bits_[index(iy, word)]; }

  Word at(int iy, int word) const { return bits_[index(iy, word)]; }

  /// Mask of the bits of a word that represent nodes.
  Word valid(int word) const {
    return word + 1 == words_ ? last_valid_ : ~Word{};
  }

  /// Mask of the nodes of a word on the border of the grid's storage, whose
  /// neighbours have other index offsets because of periodicity.
  Word border(int iy, int word) const;

  /// Sets a row from flags, which are 0 or non-zero.
  /// @param flags  grid.points_x values
  void assign_row(int iy, std::span<const std::uint8_t> flags);

  /// Membership of the eight neighbours of each node: first the four nearest
  /// ones, then the four diagonal ones. Bits past the end of the row have no
  /// meaning.
  std::array<Word, 8> neighbours(int iy, int word) const;

private:
  struct Row {
    Word west, here, east;
  };

  std::size_t index(int iy, int word) const {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(words_) +
           static_cast<std::size_t>(word);
  }

  /// A word of a row and the neighbours of its nodes in the same row.
  Row row(int iy, int word) const;

  int width_, height_, words_;
  Word last_valid_;
  std::vector<Word> bits_;
};

} // namespace asperity::contact
