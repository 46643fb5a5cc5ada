#include "contact/rim_extension.hpp"

#include "base/parallel_rows.hpp"
#include "contact/chunked_sum.hpp"

#include <algorithm>
#include <cstring>

namespace asperity::contact {
namespace {

constexpr float across = 0.5F; ///< weight of a diagonal neighbour

/// touches[i] = whether node i or one of its eight neighbours has a flag, 0 or
/// 1 each.
void mark_neighbours(const Grid& grid, int threads,
                     const std::vector<std::uint8_t>& has,
                     std::vector<std::uint8_t>& touches) {
  const auto width = static_cast<std::size_t>(grid.points_x);
  const int height = grid.points_y;
  constexpr int rows_a_turn = 16;
  parallel_turns(
      (height + rows_a_turn - 1) / rows_a_turn, threads, [&](int turn, int) {
        std::vector<std::uint8_t> column(width + 2); // of three rows, wrapped
        const int end = std::min(height, (turn + 1) * rows_a_turn);
        for (int iy = turn * rows_a_turn; iy < end; ++iy) {
          const std::uint8_t* const row = &has[grid.index(0, iy)];
          const std::uint8_t* const below =
              &has[grid.index(0, (iy + height - 1) % height)];
          const std::uint8_t* const above =
              &has[grid.index(0, (iy + 1) % height)];
          std::uint8_t* const out = &touches[grid.index(0, iy)];
          std::uint8_t* const sums = column.data();
          for (std::size_t ix = 0; ix < width; ++ix)
            sums[ix + 1] = row[ix] | below[ix] | above[ix];
          sums[0] = sums[width];
          sums[width + 1] = sums[1];
          for (std::size_t ix = 0; ix < width; ++ix)
            out[ix] = sums[ix] | sums[ix + 1] | sums[ix + 2];
        }
      });
}

/// Calls found(i) for each i with flags[i] != 0, eight at a glance.
template <class Found>
void each_flag(const std::uint8_t* flags, std::size_t size,
               const Found& found) {
  std::size_t i = 0;
  for (; i + 8 <= size; i += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, flags + i, 8);
    if (eight == 0)
      continue;
    for (std::size_t k = i; k < i + 8; ++k)
      if (flags[k] != 0)
        found(k);
  }
  for (; i < size; ++i)
    if (flags[i] != 0)
      found(i);
}

} // namespace

RimExtension::RimExtension(const Grid& grid, int threads)
    : grid_(grid), threads_(threads), rings_(layers + 1) {}

void RimExtension::build(std::span<const std::uint8_t> is_free) {
  const std::size_t nodes = grid_.size();
  work_.resize(nodes);
  std::vector<std::uint8_t> seen(nodes), touches(nodes), ring(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    seen[i] = is_free[i] > 0 ? 1 : 0;
    ring[i] = 1 - seen[i];
  }
  const auto collect = [&](Ring& kept) {
    kept.nodes.clear();
    std::vector<std::uint32_t> border;
    const auto width = static_cast<std::size_t>(grid_.points_x);
    for (int iy = 0; iy < grid_.points_y; ++iy) {
      const bool is_border = iy == 0 || iy + 1 == grid_.points_y;
      const std::size_t first = grid_.index(0, iy);
      each_flag(&ring[first], width, [&](std::size_t ix) {
        const bool is_edge = is_border || ix == 0 || ix + 1 == width;
        (is_edge ? border : kept.nodes)
            .push_back(static_cast<std::uint32_t>(first + ix));
      });
    }
    kept.n_inside = kept.nodes.size();
    kept.nodes.insert(kept.nodes.end(), border.begin(), border.end());
    kept.share.assign(kept.nodes.size(), 0.0F);
  };

  // Ring 0: free nodes beside others.
  mark_neighbours(grid_, threads_, ring, touches);
  for (std::size_t i = 0; i < nodes; ++i)
    ring[i] = touches[i] & seen[i];
  collect(rings_[0]);
  std::vector<float>& present = work_; // all 0 between uses
  for (std::size_t l = 1; l < rings_.size(); ++l) {
    for (const std::uint32_t node : rings_[l - 1].nodes)
      present[node] = 1.0F;
    mark_neighbours(grid_, threads_, ring, touches);
    for (std::size_t i = 0; i < nodes; ++i) {
      ring[i] = touches[i] & (1 - seen[i]);
      seen[i] |= ring[i];
    }
    collect(rings_[l]);
    each_chunk(rings_[l], [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        rings_[l].share[k] = 1.0F / around(rings_[l], k, present.data());
    });
    for (const std::uint32_t node : rings_[l - 1].nodes)
      present[node] = 0.0F;
  }
  std::size_t longest = 0;
  for (const Ring& kept : rings_)
    longest = std::max(longest, kept.nodes.size());
  values_.resize(longest);
  is_built_ = true;
}

float RimExtension::around(const Ring& ring, std::size_t k,
                           const float* field) const {
  const std::size_t i = ring.nodes[k];
  const auto width = static_cast<std::size_t>(grid_.points_x);
  if (k < ring.n_inside) {
    const float* const at = field + i;
    return at[1] + *(at - 1) + at[width] + *(at - width) +
           across * (at[width + 1] + at[width - 1] + *(at - width + 1) +
                     *(at - width - 1));
  }
  const int ix = static_cast<int>(i % width);
  const int iy = static_cast<int>(i / width);
  float sum = 0.0F;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (dx != 0 || dy != 0)
        sum += (dx != 0 && dy != 0 ? across : 1.0F) *
               field[grid_.index((ix + dx + grid_.points_x) % grid_.points_x,
                                 (iy + dy + grid_.points_y) % grid_.points_y)];
  return sum;
}

template <class DoNodes>
void RimExtension::each_chunk(const Ring& ring, const DoNodes& do_nodes) const {
  chunked(ring.nodes.size(), threads_, do_nodes);
}

void RimExtension::extend(double reach, std::span<const std::uint8_t> is_free,
                          std::span<float> field) {
  const float factor = static_cast<float>(reach);
  for (std::size_t l = 0; l < rings_.size(); ++l) {
    const Ring& ring = rings_[l];
    if (l > 0)
      each_chunk(ring, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          values_[k] = factor * ring.share[k] * around(ring, k, work_.data());
      });
    each_chunk(ring, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const std::uint32_t node = ring.nodes[k];
        if (l > 0 && is_free[node] == 0)
          field[node] = values_[k];
        work_[node] = field[node];
      }
    });
  }
  clear_work();
}

void RimExtension::clear_work() {
  for (const Ring& ring : rings_)
    each_chunk(ring, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        work_[ring.nodes[k]] = 0.0F;
    });
}

void RimExtension::clear(std::span<const std::uint8_t> is_free,
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

void RimExtension::fold(double reach, std::span<const std::uint8_t> is_free,
                        std::span<float> field) {
  const float factor = static_cast<float>(reach);
  for (std::size_t l = rings_.size(); l-- > 0;) {
    const Ring& ring = rings_[l];
    each_chunk(ring, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        float& value = field[ring.nodes[k]];
        value += around(ring, k, work_.data());
        values_[k] = value;
      }
    });
    each_chunk(ring, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        if (l > 0 && is_free[ring.nodes[k]] == 0)
          work_[ring.nodes[k]] = factor * ring.share[k] * values_[k];
    });
  }
  clear_work();
}

} // namespace asperity::contact
