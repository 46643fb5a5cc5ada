// Tests of fem/refined/node_interpolation.hpp: contact on nodes that another
// rank owns.
#include "fem/refined/box_levels.hpp"
#include "fem/refined/node_interpolation.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <map>

namespace asperity::fem::node_interpolation_test {

/// Two cubes side by side along x, free sides.
BoxGrid two_cubes() {
  BoxGrid box_grid;
  box_grid.cells_x = 2;
  box_grid.length_x = 2.0;
  box_grid.length_y = 1.0;
  box_grid.thickness = {1.0};
  box_grid.is_periodic = false;
  return box_grid;
}

/// The number of a node of the halved cubes, z fastest.
std::uint32_t node_at(int x, int y, int z) {
  return static_cast<std::uint32_t>((x * 3 + y) * 3 + z);
}

constexpr std::uint32_t nodes = 45;
constexpr std::uint32_t on_border = 18; ///< first node between the cubes
constexpr std::uint32_t right = 27;     ///< first node beside them

/// The cells halved from the cubes first..end-1, and the cube of each.
struct HalvedCubes {
  std::vector<BoxCell> cells;
  std::vector<std::uint32_t> corners; ///< first unknowns
  std::vector<std::uint32_t> cube;

  HalvedCubes(int first, int end) {
    for (int x = 2 * first; x < 2 * end; ++x)
      for (int i = 0; i < 4; ++i) {
        cells.push_back({1, {x, i % 2, i / 2}});
        cube.push_back(static_cast<std::uint32_t>(x / 2));
        for (int v = 0; v < 8; ++v)
          corners.push_back(
              3 * node_at(x + v % 2, i % 2 + v / 2 % 2, i / 2 + v / 4));
      }
  }
};

/// Springs between all nodes of the surface of the right cube, in the numbers
/// of all nodes.
MeshContact springs_on_the_right() {
  MeshContact contact;
  contact.has_springs = true;
  for (std::uint32_t node = on_border; node < nodes; node += 3)
    contact.unknowns.push_back(3 * std::size_t{node} + 2);
  const std::size_t size = contact.unknowns.size();
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      contact.springs.column.push_back(j);
      contact.springs.weight.push_back(1.0 / static_cast<double>(1 + i + j));
    }
    contact.springs.start.push_back(contact.springs.column.size());
  }
  return contact;
}

std::map<std::pair<std::size_t, std::size_t>, double>
entries_of(const MeshContact& contact) {
  std::map<std::pair<std::size_t, std::size_t>, double> entries;
  for (std::size_t row = 0; row < contact.springs.rows(); ++row)
    for (std::size_t k = contact.springs.start[row];
         k < contact.springs.start[row + 1]; ++k)
      entries[{contact.unknowns[row],
               contact.unknowns[contact.springs.column[k]]}] +=
          contact.springs.weight[k];
  return entries;
}

BoxLevel coarse_level() {
  const BoxGrid box_grid = two_cubes();
  return {box_grid,
          {{{0, {0, 0, 0}}, {0, {1, 0, 0}}}, {{1.0, 1.0}, {1.0, 1.0}}}};
}

NodesOfCells cells_of(const BoxLevel& level) {
  return {*level.mesh.nodes, 2, level.boxes.cells};
}

// Verifies that a rank whose springs act on nodes of another one transfers them
// as one rank with all nodes does, and that each rank receives them. Tolerance:
// roundoff.
TEST(NodeInterpolation, TransfersSpringsOnNodesOfAnotherRank) {
  const BoxLevel coarse = coarse_level();
  const HalvedCubes all(0, 2);
  const NodeInterpolation alone(
      {{all.corners, 2, all.cells}, all.cube, std::vector<bool>(nodes, true)},
      cells_of(coarse), coarse.mesh.unknowns);
  const auto expected = entries_of(alone.coarse(springs_on_the_right()));
  ASSERT_EQ(expected.size(), 16U); // of four corners

  tests::on_thread_ranks(2, [&](RankGroup& ranks) {
    const bool is_left = ranks.rank() == 0;
    // The left rank owns the nodes between the cubes, which the right one has
    // after its own.
    const std::size_t owned = is_left ? right : nodes - right;
    std::vector<std::size_t> of_other;
    for (std::size_t node = on_border; !is_left && node < right; ++node)
      of_other.push_back(node);
    const GhostValues ghosts(ranks, owned, of_other, 3);
    const auto own = [&](std::size_t unknown) {
      const std::size_t first = 3 * std::size_t{right};
      if (is_left)
        return unknown;
      return unknown < first ? unknown + 3 * owned - 3 * std::size_t{on_border}
                             : unknown - first;
    };
    HalvedCubes cubes(is_left ? 0 : 1, is_left ? 1 : 2);
    for (std::uint32_t& corner : cubes.corners)
      corner = static_cast<std::uint32_t>(own(corner));
    std::vector<bool> is_wanted(owned + of_other.size(), false);
    std::fill_n(is_wanted.begin(), owned, true);
    const NodeInterpolation shared(
        {{cubes.corners, 2, cubes.cells}, cubes.cube, is_wanted, &ghosts},
        cells_of(coarse), coarse.mesh.unknowns);
    MeshContact contact = springs_on_the_right();
    for (std::size_t& unknown : contact.unknowns)
      unknown = own(unknown);
    if (is_left)
      contact = {};

    const auto found = entries_of(shared.coarse(contact));

    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [place, value] : found)
      EXPECT_NEAR(value, expected.at(place), 1e-12);
  });
}

} // namespace asperity::fem::node_interpolation_test
