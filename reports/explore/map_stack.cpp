#include "reports/explore/map_stack.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <utility>

namespace asperity::reports {
namespace {

/// Averages values that arrive in their order. Each block is summed in the
/// order of its nodes, whatever the pieces are.
class BlockMeans {
public:
  BlockMeans(const Grid& grid, int most)
      : grid_(grid),
        block_x_((grid.points_x + most - 1) / most),
        block_y_((grid.points_y + most - 1) / most) {
    small_.columns = grid.points_x / block_x_;
    small_.rows = grid.points_y / block_y_;
    small_.block_x = block_x_;
    small_.block_y = block_y_;
    small_.values.assign(static_cast<std::size_t>(small_.columns) *
                             static_cast<std::size_t>(small_.rows),
                         0.0);
  }

  /// @param value_at  gives value i of the next n
  template <class ValueAt>
  void take(std::size_t n, const ValueAt& value_at) {
    for (std::size_t i = 0; i < n; ++i) {
      const int column = x_ / block_x_;
      const int row = y_ / block_y_;
      if (column < small_.columns && row < small_.rows)
        small_.values[static_cast<std::size_t>(row) *
                          static_cast<std::size_t>(small_.columns) +
                      static_cast<std::size_t>(column)] += value_at(i);
      if (++x_ == grid_.points_x) {
        x_ = 0;
        ++y_;
      }
    }
  }

  ReducedMap means() && {
    for (double& value : small_.values)
      value /= block_x_ * block_y_;
    return std::move(small_);
  }

private:
  Grid grid_;
  int block_x_, block_y_;
  int x_ = 0, y_ = 0; ///< of the next value
  ReducedMap small_;
};

} // namespace

ReducedMap reduced(const Grid& grid, const results::MapView& map, int most) {
  BlockMeans blocks(grid, most);
  results::each_piece(map, [&](std::span<const double> values) {
    blocks.take(values.size(), [&](std::size_t i) { return values[i]; });
  });
  return std::move(blocks).means();
}

ReducedMap reduced_contact(const Grid& grid, const results::MapView& pressure,
                           const results::MapView& gap,
                           const mechanics::ContactCriterion& criterion,
                           int most) {
  BlockMeans blocks(grid, most);
  results::each_piece(std::array{pressure, gap}, [&](std::size_t,
                                                     const auto& values) {
    const mechanics::ContactNodes nodes(criterion, values[0], values[1]);
    blocks.take(nodes.size(),
                [&](std::size_t i) { return nodes.in_contact(i) ? 1.0 : 0.0; });
  });
  return std::move(blocks).means();
}

ReducedMap reduced_difference(const Grid& grid, const results::MapView& map,
                              const results::MapView& other, int most) {
  BlockMeans blocks(grid, most);
  results::each_piece(
      std::array{map, other}, [&](std::size_t, const auto& values) {
        blocks.take(values[0].size(),
                    [&](std::size_t i) { return values[0][i] - values[1][i]; });
      });
  return std::move(blocks).means();
}

int stack_side(std::size_t n_frames) {
  return n_frames <= 4 ? 512 : 256;
}

std::vector<std::size_t> stack_frames(std::size_t count) {
  constexpr std::size_t most = 12;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < most; ++i)
    if (const std::size_t next =
            count <= most ? i : i * (count - 1) / (most - 1);
        next < count)
      chosen.push_back(next);
  return chosen;
}

} // namespace asperity::reports
