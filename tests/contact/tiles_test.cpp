// Tests of contact/operators/tile_operator.hpp and
// contact/solvers/tile_start.hpp.
#include "contact/operators/tile_operator.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "ranks/node_sums.hpp"
#include "tests/contact/problems.hpp"
#include "tests/contact/solved.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <mutex>

namespace asperity::contact::tiles_test {

using Kind = mechanics::Control;

const mechanics::ElasticBlock halfspace{1.0, 0.3,
                                        std::numeric_limits<double>::infinity(),
                                        mechanics::FarBoundary::clamped};

/// Calls do_node(node of the grid, node of the tiles).
template <class DoNode>
void each_node(const Grid& grid, const Tiles& tiles, const DoNode& do_node) {
  for (std::size_t i = 0; i < tiles.numbers.size() * tile_nodes; ++i) {
    const int tile = tiles.numbers[i / tile_nodes];
    const int x = static_cast<int>(i % tile_side);
    const int y = static_cast<int>(i % tile_nodes / tile_side);
    do_node(grid.index(tile % tiles.per_row * tile_points + x,
                       tile / tiles.per_row * tile_points + y),
            i);
  }
}

/// Largest difference of the two displacements on the tiles, up to a constant,
/// over the largest displacement.
double difference_on_tiles(const Grid& grid, const Tiles& tiles) {
  FourierOperator whole = halfspace_operator(grid, halfspace);
  const std::unique_ptr<SurfaceOperator> part = whole.on_tiles(tiles);
  const std::vector<double> random = problems::random_field(grid.size());
  std::vector<double> pressure(grid.size()), displacement(grid.size());
  std::vector<double> own_pressure(part->grid().size()),
      own_displacement(part->grid().size());
  each_node(grid, tiles, [&](std::size_t node, std::size_t own) {
    own_pressure[own] = pressure[node] = 0.2 + random[node];
  });
  whole.displacement(pressure, displacement);
  part->displacement(own_pressure, own_displacement);
  Largest highest, lowest, largest;
  each_node(grid, tiles, [&](std::size_t node, std::size_t own) {
    const double difference = own_displacement[own] - displacement[node];
    highest += {difference};
    lowest += {-difference};
    largest += {std::abs(displacement[node])};
  });
  return 0.5 * (highest.value + lowest.value) / largest.value;
}

// A corner, of which other tiles are beside it across the border, and tiles
// beside each other in both directions and diagonally. Measured: 2.6e-5
// and 2.2e-5.
TEST(Tiles, HaveTheDisplacementOfTheWholeSurface) {
  EXPECT_LT(difference_on_tiles({512, 512, 1.0, 1.0},
                                {8, 8, {0, 7, 18, 19, 27, 36, 56}}),
            4e-5);
  EXPECT_LT(
      difference_on_tiles({1024, 512, 3.0, 1.5}, {16, 8, {5, 6, 64, 127}}),
      4e-5);
}

} // namespace asperity::contact::tiles_test
