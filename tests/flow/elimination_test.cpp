// Tests of mechanics/flow/elimination.hpp: the potentials of the reduced
// network are those of the network.
#include "mechanics/flow/elimination.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity::flow::elimination_test {

/// Solves a network by factors of its dense matrix.
NetworkSolution by_factors(const Network& network) {
  const auto n = static_cast<Eigen::Index>(network.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  std::size_t entry = 0;
  for (Eigen::Index row = 0; row < n; ++row)
    for (int e = 0; e < network.row_sizes[static_cast<std::size_t>(row)];
         ++e, ++entry)
      matrix(row, network.columns[entry]) = network.values[entry];
  const Eigen::VectorXd potential = matrix.llt().solve(
      Eigen::Map<const Eigen::VectorXd>(network.right_side.data(), n));
  return {{potential.begin(), potential.end()}, 1, true};
}

/// A strip of width 3 with holes, between reservoirs at its ends, whose
/// conductances span six decades.
Network strip(int length) {
  std::vector<int> row(static_cast<std::size_t>(3 * length), -1);
  int rows = 0;
  const auto node = [](int x, int y) {
    return static_cast<std::size_t>(3 * x + y);
  };
  for (int x = 0; x < length; ++x)
    for (int y = 0; y < 3; ++y)
      if (y == 1 || (x * 5 + y) % 4 != 0)
        row[node(x, y)] = rows++;
  const auto conductance = [](std::size_t a, std::size_t b) {
    return std::pow(10.0, -static_cast<double>((a + b) * 3 % 7));
  };
  Network network;
  for (int x = 0; x < length; ++x)
    for (int y = 0; y < 3; ++y) {
      const std::size_t own = node(x, y);
      if (row[own] < 0)
        continue;
      const std::size_t first = network.columns.size();
      network.columns.push_back(row[own]);
      network.values.push_back(x == 0 || x == length - 1 ? 2.0 : 0.0);
      const auto join = [&](int other_x, int other_y) {
        if (other_x < 0 || other_x >= length || other_y < 0 || other_y > 2 ||
            row[node(other_x, other_y)] < 0)
          return;
        network.columns.push_back(row[node(other_x, other_y)]);
        network.values.push_back(-conductance(own, node(other_x, other_y)));
        network.values[first] -= network.values.back();
      };
      join(x - 1, y);
      join(x + 1, y);
      join(x, y - 1);
      join(x, y + 1);
      network.row_sizes.push_back(
          static_cast<int>(network.columns.size() - first));
      network.right_side.push_back(x == 0 ? 2.0 : 0.0);
      network.start.push_back(0.5);
    }
  return network;
}

// Tolerance: roundoff times the ratio of the conductances.
TEST(Elimination, HasThePotentialsOfTheWholeNetwork) {
  for (const int length : {1, 2, 3, 40}) {
    const Network network = strip(length);
    std::size_t reduced = 0;

    const NetworkSolution found =
        solved_by_elimination(network, [&](const Network& smaller) {
          reduced = smaller.size();
          return by_factors(smaller);
        });

    const NetworkSolution whole = by_factors(network);
    ASSERT_TRUE(found.converged && whole.converged);
    EXPECT_LT(reduced, network.size());
    ASSERT_EQ(found.potential.size(), network.size());
    for (std::size_t i = 0; i < network.size(); ++i)
      EXPECT_NEAR(found.potential[i], whole.potential[i], 1e-9) << i;
  }
}

TEST(Elimination, LeavesHalfOfAGrid) {
  const Network network = strip(400);
  std::size_t reduced = 0;

  solved_by_elimination(network, [&](const Network& smaller) {
    reduced = smaller.size();
    return NetworkSolution{};
  });

  EXPECT_LT(static_cast<double>(reduced),
            0.55 * static_cast<double>(network.size()));
}

} // namespace asperity::flow::elimination_test
