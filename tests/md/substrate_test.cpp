// Tests of md/interface/substrate.hpp: a window contains every partner within
// the reach, for any ratio of reach and spacing. The squares of some ratios
// round to the other side of an integer when they are computed in another way.
#include "md/interface/substrate.hpp"
#include "tests/md/small_interface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace asperity::md::substrate_test {

using problems::angstrom;

/// A substrate of points x points atoms under a reach, in lengths of `unit`.
struct Lattice {
  int points;
  double length; ///< [m]
  double reach;  ///< [m]
  double unit;   ///< [m]
};

/// Offsets in columns and rows, from the corner of the cell.
using Offsets = std::set<std::pair<int, int>>;

Offsets offsets_in(const Window& window, double spacing) {
  Offsets offsets;
  for (const Tile& tile : window.tiles)
    for (int row = 0; row < tile_rows; ++row)
      for (int column = 0; column < tile_columns; ++column)
        offsets.emplace(static_cast<int>(std::lround(tile.x / spacing)) +
                            column,
                        static_cast<int>(std::lround(tile.y / spacing)) + row);
  return offsets;
}

void expect_all_partners(const Lattice& lattice) {
  const Grid grid = problems::lattice(lattice.points, lattice.length);
  const std::vector<double> flat(grid.size(), 0.0);
  const Substrate substrate(grid, flat, lattice.reach, lattice.unit);
  const double reach = lattice.reach / grid.spacing_x();
  const int far = static_cast<int>(reach) + 2;
  for (const LatticePoint& point :
       {LatticePoint{1.0, 2.0}, LatticePoint{1.99, 2.99}}) {
    const Window window = substrate.window(point, -1.0);
    ASSERT_LE(window.tiles.size(), grid.size());
    const Offsets found = offsets_in(window, substrate.spacing());
    for (int row = -far; row <= far; ++row)
      for (int column = -far; column <= far; ++column) {
        const double distance =
            std::hypot(column + 1.0 - point.column, row + 2.0 - point.row);
        ASSERT_TRUE(distance >= (1.0 - 1e-9) * reach ||
                    found.contains({column, row}))
            << column << " " << row << " of " << lattice.reach << " over "
            << grid.spacing_x();
      }
  }
}

// Cells of 74 and of 170 atoms, whose reach is 5, 10 and 6 times the spacing of
// the substrate to the last digit and whose squares round to either side.
TEST(Substrate, HoldsAllPartnersWhereTheSquareOfTheRatioRounds) {
  for (const double reach : {7.4e-10, 14.8e-10})
    expect_all_partners({120, 74 * 2.4e-10, reach, 3.4e-10});
  expect_all_partners(
      {276, 170 * (0.1 * 23 * 1e-10), 0.1 * 85 * 1e-10, 3.28e-10});
}

TEST(Substrate, HoldsAllPartnersForManyCutoffs) {
  for (int tenths = 20; tenths <= 30; ++tenths)
    for (int steps = 30; steps <= 150; ++steps) {
      const int points = 2 * (steps / tenths) + 4;
      expect_all_partners({points, points * 0.1 * tenths * angstrom,
                           0.1 * steps * angstrom, 3.28 * angstrom});
    }
}

} // namespace asperity::md::substrate_test
