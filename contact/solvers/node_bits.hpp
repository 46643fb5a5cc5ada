#pragma once

// This file represents sets of nodes of a periodic grid with one bit per node,
// with neighbour queries for 64 nodes at a time. The rows may be shared by
// several ranks.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ranks/shared_rows.hpp"

namespace asperity::contact {

class NodeBits {
public:
  using Word = std::uint64_t;

  /// @param rows  the rows of this process; must outlive this object
  explicit NodeBits(const SharedRows& rows);

  int words_a_row() const { return words_; }

  /// Nodes 64 * word + 0..63 of row iy of this process, the first one in the
  /// lowest bit; bits past the end of the row must remain 0.
  Word& at(int iy, int word) { return bits_[index(iy, word)]; }

  Word at(int iy, int word) const { return bits_[index(iy, word)]; }

  /// Mask of the bits of a word that represent nodes.
  Word valid(int word) const {
    return word + 1 == words_ ? last_valid_ : ~Word{};
  }

  /// Mask of the nodes of a word on the border of the whole grid.
  Word border(int iy, int word) const;

  /// Sets a row from flags, which are 0 or non-zero.
  /// @param flags  grid.points_x values
  void assign_row(int iy, std::span<const std::uint8_t> flags);

  /// Fills the rows beside those of this process, after each change and before
  /// neighbours(). Collective.
  void fill_ghost_rows() { rows_->fill_ghost_rows(std::span(bits_)); }

  /// Membership of the eight neighbours of each node: first the four nearest
  /// ones, then the four diagonal ones. Bits past the end of the row have no
  /// meaning. The rows beside those of this process must have been filled.
  std::array<Word, 8> neighbours(int iy, int word) const;

private:
  struct Row {
    Word west, here, east;
  };

  std::size_t index(int iy, int word) const {
    return static_cast<std::size_t>(iy + 1) * static_cast<std::size_t>(words_) +
           static_cast<std::size_t>(word);
  }

  /// A word of a row and the neighbours of its nodes in the same row.
  Row row(int iy, int word) const;

  const SharedRows* rows_;
  int width_, words_;
  Word last_valid_;
  std::vector<Word> bits_; ///< from row -1 to the row after the last
};

} // namespace asperity::contact
