#include "reports/explore/map_stack.hpp"

namespace asperity::reports {

ReducedMap reduced(const Grid& grid, const std::vector<double>& map, int most) {
  const int block_x = (grid.points_x + most - 1) / most;
  const int block_y = (grid.points_y + most - 1) / most;
  ReducedMap small{
      grid.points_x / block_x, grid.points_y / block_y, block_x, block_y, {}};
  small.values.reserve(static_cast<std::size_t>(small.columns) *
                       static_cast<std::size_t>(small.rows));
  for (int row = 0; row < small.rows; ++row)
    for (int column = 0; column < small.columns; ++column) {
      double sum = 0.0;
      for (int iy = row * block_y; iy < (row + 1) * block_y; ++iy)
        for (int ix = column * block_x; ix < (column + 1) * block_x; ++ix)
          sum += map[grid.index(ix, iy)];
      small.values.push_back(sum / (block_x * block_y));
    }
  return small;
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
