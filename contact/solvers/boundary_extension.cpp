#include "contact/solvers/boundary_extension.hpp"

#include "base/parallel_rows.hpp"
#include "contact/operators/chunked_sum.hpp"
#include "contact/solvers/node_bits.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace asperity::contact {
namespace {

constexpr float diagonal_weight = 0.5F; ///< weight of a diagonal neighbour

constexpr int rows_a_turn = 16;

int turns_of(const SharedRows& rows) {
  return (rows.count() + rows_a_turn - 1) / rows_a_turn;
}

/// Calls do_word(turn, iy, word) for each word of the bit field; one thread
/// processes the rows of one turn.
template <class DoWord>
void each_word(const SharedRows& rows, const NodeBits& bits, int threads,
               const DoWord& do_word) {
  parallel_rows(turns_of(rows), threads, [&](int turn) {
    const int end = std::min(rows.count(), (turn + 1) * rows_a_turn);
    for (int iy = turn * rows_a_turn; iy < end; ++iy)
      for (int word = 0; word < bits.words_a_row(); ++word)
        do_word(static_cast<std::size_t>(turn), iy, word);
  });
}

/// Calls found(bit) for each bit that is set, from the lowest to the highest.
template <class Found>
void each_bit(NodeBits::Word bits, const Found& found) {
  for (; bits != 0; bits &= bits - 1)
    found(std::countr_zero(bits));
}

/// 1 / sum of w over the neighbours of the node of a bit, 0 if there are none.
float share_of(const std::array<NodeBits::Word, 8>& neighbours, int bit) {
  NodeBits::Word beside = 0, diagonal = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    beside += neighbours[k] >> bit & 1U;
    diagonal += neighbours[k + 4] >> bit & 1U;
  }
  const float weight = static_cast<float>(beside) +
                       diagonal_weight * static_cast<float>(diagonal);
  return weight > 0.0F ? 1.0F / weight : 0.0F;
}

} // namespace

BoundaryExtension::BoundaryExtension(const Grid& grid, const Workers& workers)
    : rows_(workers.rows != nullptr ? *workers.rows : SharedRows(grid)),
      threads_(workers.threads),
      rings_(layers + 1) {}

void BoundaryExtension::build(std::span<const std::uint8_t> is_free) {
  const std::size_t width = rows_.width();
  work_.resize(rows_.size() + 2 * width); // all 0 between calls
  NodeBits seen(rows_), before(rows_), ring(rows_);
  parallel_rows(turns_of(rows_), threads_, [&](int turn) {
    const int end = std::min(rows_.count(), (turn + 1) * rows_a_turn);
    for (int iy = turn * rows_a_turn; iy < end; ++iy)
      seen.assign_row(
          iy, is_free.subspan(static_cast<std::size_t>(iy) * width, width));
  });
  seen.fill_ghost_rows();

  // Ring 0: active nodes with an inactive neighbour.
  each_word(rows_, seen, threads_, [&](std::size_t, int iy, int word) {
    const NodeBits::Word own = seen.at(iy, word);
    if (own == 0)
      return;
    NodeBits::Word inner = own;
    for (const NodeBits::Word neighbour : seen.neighbours(iy, word))
      inner &= neighbour;
    ring.at(iy, word) = own & ~inner;
  });
  collect(ring, before, rings_[0]);
  for (std::size_t l = 1; l < rings_.size(); ++l) {
    std::swap(ring, before);
    before.fill_ghost_rows();
    each_word(rows_, seen, threads_, [&](std::size_t, int iy, int word) {
      NodeBits::Word touched = 0;
      for (const NodeBits::Word neighbour : before.neighbours(iy, word))
        touched |= neighbour;
      NodeBits::Word& known = seen.at(iy, word);
      ring.at(iy, word) = touched & ~known & seen.valid(word);
      known |= ring.at(iy, word);
    });
    collect(ring, before, rings_[l]);
  }
  std::size_t longest = 0;
  for (const Ring& kept : rings_)
    longest = std::max(longest, kept.nodes.size());
  values_.resize(longest);
  size_ = total_count(
      Workers(threads_, rows_.ranks() != nullptr ? &rows_ : nullptr),
      rings_[0].nodes.size());
  is_built_ = true;
}

void BoundaryExtension::collect(const NodeBits& members, const NodeBits& before,
                                Ring& kept) const {
  struct Place {
    std::size_t inside = 0, border = 0;
  };

  const auto turns = static_cast<std::size_t>(turns_of(rows_));
  std::vector<Place> places(turns + 1); // counts, later the start of each turn
  each_word(rows_, members, threads_, [&](std::size_t turn, int iy, int word) {
    const NodeBits::Word bits = members.at(iy, word);
    const NodeBits::Word border = bits & members.border(iy, word);
    Place& count = places[turn + 1];
    count.inside += static_cast<std::size_t>(std::popcount(bits & ~border));
    count.border += static_cast<std::size_t>(std::popcount(border));
  });
  for (std::size_t turn = 1; turn <= turns; ++turn) {
    places[turn].inside += places[turn - 1].inside;
    places[turn].border += places[turn - 1].border;
  }
  kept.n_inside = places[turns].inside;
  kept.nodes.resize(kept.n_inside + places[turns].border);
  kept.share.resize(kept.nodes.size());
  each_word(rows_, members, threads_, [&](std::size_t turn, int iy, int word) {
    const NodeBits::Word bits = members.at(iy, word);
    if (bits == 0)
      return;
    const auto neighbours = before.neighbours(iy, word);
    const std::size_t first = rows_.grid().index(64 * word, iy);
    const auto put = [&](std::size_t& place, NodeBits::Word some) {
      each_bit(some, [&](int bit) {
        kept.nodes[place] =
            static_cast<std::uint32_t>(first + static_cast<std::size_t>(bit));
        kept.share[place++] = share_of(neighbours, bit);
      });
    };
    const NodeBits::Word border = bits & members.border(iy, word);
    std::size_t at_border = kept.n_inside + places[turn].border;
    put(places[turn].inside, bits & ~border);
    put(at_border, border);
    places[turn].border = at_border - kept.n_inside;
  });
}

inline float BoundaryExtension::around(const Ring& ring, std::size_t k,
                                       const float* field) const {
  const std::size_t i = ring.nodes[k];
  if (k >= ring.n_inside)
    return around_border(i, field);
  const std::size_t width = rows_.width();
  const float* const at = field + i;
  return at[1] + *(at - 1) + at[width] + *(at - width) +
         diagonal_weight * (at[width + 1] + at[width - 1] + *(at - width + 1) +
                            *(at - width - 1));
}

float BoundaryExtension::around_border(std::size_t node,
                                       const float* field) const {
  const std::size_t width = rows_.width();
  const std::size_t ix = node % width;
  const std::size_t west = ix > 0 ? ix - 1 : width - 1;
  const std::size_t east = ix + 1 < width ? ix + 1 : 0;
  const float* row = field + (node - ix) - width;
  float sum = 0.0F;
  for (int dy = -1; dy <= 1; ++dy, row += width) {
    const bool is_level = dy == 0;
    sum += (is_level ? 1.0F : diagonal_weight) * row[west];
    if (!is_level)
      sum += row[ix];
    sum += (is_level ? 1.0F : diagonal_weight) * row[east];
  }
  return sum;
}

template <class DoNodes>
void BoundaryExtension::each_chunk(const Ring& ring,
                                   const DoNodes& do_nodes) const {
  chunked(ring.nodes.size(), threads_, do_nodes);
}

void BoundaryExtension::extend(double reach,
                               std::span<const std::uint8_t> is_free,
                               std::span<float> field) {
  const float factor = static_cast<float>(reach);
  float* const work = own_work();
  for (std::size_t l = 0; l < rings_.size(); ++l) {
    const Ring& ring = rings_[l];
    if (l > 0) {
      rows_.fill_ghost_rows(std::span(work_));
      each_chunk(ring, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          values_[k] = factor * ring.share[k] * around(ring, k, work);
      });
    }
    each_chunk(ring, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const std::uint32_t node = ring.nodes[k];
        if (l > 0 && is_free[node] == 0)
          field[node] = values_[k];
        work[node] = field[node];
      }
    });
  }
  clear_work();
}

void BoundaryExtension::clear_work() {
  float* const work = own_work();
  for (const Ring& ring : rings_)
    each_chunk(ring, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        work[ring.nodes[k]] = 0.0F;
    });
  const auto width = static_cast<std::ptrdiff_t>(rows_.width());
  std::fill(work_.begin(), work_.begin() + width, 0.0F);
  std::fill(work_.end() - width, work_.end(), 0.0F);
}

void BoundaryExtension::clear(std::span<const std::uint8_t> is_free,
                              std::span<float> field) const {
  for (std::size_t l = 1; l < rings_.size(); ++l) {
    const Ring& ring = rings_[l];
    each_chunk(ring, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        if (is_free[ring.nodes[k]] == 0)
          field[ring.nodes[k]] = 0.0F;
    });
  }
}

void BoundaryExtension::fold(double reach,
                             std::span<const std::uint8_t> is_free,
                             std::span<float> field) {
  const float factor = static_cast<float>(reach);
  float* const work = own_work();
  for (std::size_t l = rings_.size(); l-- > 0;) {
    const Ring& ring = rings_[l];
    if (l + 1 < rings_.size())
      rows_.fill_ghost_rows(std::span(work_));
    each_chunk(ring, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        float& value = field[ring.nodes[k]];
        value += around(ring, k, work);
        values_[k] = value;
      }
    });
    each_chunk(ring, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        if (l > 0 && is_free[ring.nodes[k]] == 0)
          work[ring.nodes[k]] = factor * ring.share[k] * values_[k];
    });
  }
  clear_work();
}

} // namespace asperity::contact
