// Tests of meshes/layers/halvable_layers.hpp: every interface is a plane of
// cells, and the cells are nearly cubes where that is possible.
#include "meshes/layers/halvable_layers.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::meshes::halvable_layers_test {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The number of halvings after which the depth is a plane of cells; -1 if it
/// is none after `halvings`. Roundoff of a depth of 1: 1e-12.
int halvings_at(double depth, const std::vector<double>& layers, int halvings) {
  double top = 0.0;
  for (const double thickness : layers) {
    if (depth < top + thickness + 1e-12)
      for (int level = 0; level <= halvings; ++level) {
        const double planes = (depth - top) / std::ldexp(thickness, -level);
        if (std::abs(planes - std::round(planes)) < 1e-9)
          return level;
      }
    top += thickness;
  }
  return -1;
}

// Without interfaces, equal cubes; thick layers, equal boxes in each.
TEST(HalvableLayers, FillThickLayersEvenly) {
  EXPECT_EQ(halvable_layers(0.25, 3, {}, 1.0).size(), 4U);

  const std::vector<double> layers =
      halvable_layers(0.25, 3, std::vector<double>{0.3, 0.8}, 2.0);

  ASSERT_EQ(layers.size(), 8U); // 0.3, 2 * 0.25, 5 * 0.24
  EXPECT_NEAR(layers[0], 0.3, 1e-15);
  EXPECT_NEAR(layers[1], 0.25, 1e-15);
  EXPECT_NEAR(layers[7], 0.24, 1e-15);
}

// A coating of a fifth of the edge is a quarter of a layer, so that cells in it
// are cubes within a factor of sqrt(2).
TEST(HalvableLayers, MakeAThinLayerAFractionOfANearCube) {
  const std::vector<double> layers =
      halvable_layers(0.25, 4, std::vector<double>{0.05}, 1.0);

  EXPECT_NEAR(layers[0], 0.2, 1e-15);
  EXPECT_EQ(halvings_at(0.05, layers, 4), 2);
}

// With fewer halvings than that the cells are flat; so is a layer whose
// neighbour is no plane of the same cells.
TEST(HalvableLayers, MakeFlatCellsWhereNothingElseIsExact) {
  EXPECT_NEAR(halvable_layers(0.25, 1, std::vector<double>{0.01}, 1.0).front(),
              0.02, 1e-15);
  const std::vector<double> layers =
      halvable_layers(0.25, 4, std::vector<double>{0.05, 0.083}, 1.0);
  EXPECT_NEAR(layers.front(), 0.05, 1e-15);
}

// For coatings of any number and thickness, the layers fill the block and all
// interfaces are planes of cells.
TEST(HalvableLayers, KeepEveryInterface) {
  unsigned int state = 1;
  const auto draw = [&state] {
    state = state * 1664525U + 1013904223U;
    return (state >> 8) / 16777216.0;
  };
  for (int trial = 0; trial < 2000; ++trial) {
    const int halvings = static_cast<int>(6.0 * draw());
    const double edge = 0.03 + 0.3 * draw();
    std::vector<double> interfaces;
    double depth = 0.0;
    for (int i = static_cast<int>(4.0 * draw()); i > 0; --i)
      interfaces.push_back(depth += std::pow(10.0, -3.0 * draw()) / 4.0);
    const std::vector<double> layers =
        halvable_layers(edge, halvings, interfaces, 1.0);

    EXPECT_NEAR(sum(layers), 1.0, 1e-12);
    for (const double thickness : layers) {
      EXPECT_GT(thickness, 0.0);
      EXPECT_LE(thickness, 1.5 * edge);
    }
    for (const double interface : interfaces)
      EXPECT_GE(halvings_at(interface, layers, halvings), 0)
          << trial << ": " << interface;
  }
}

TEST(HalvableLayers, RefuseWhatIsOutOfRange) {
  const auto refusal = [](double edge, int halvings,
                          const std::vector<double>& interfaces) {
    return tests::message_of<std::domain_error>([&] {
      static_cast<void>(halvable_layers(edge, halvings, interfaces, 1.0));
    });
  };

  EXPECT_EQ(refusal(0.25, 3, {0.1, 0.2}), "accepted");
  EXPECT_NE(refusal(0.0, 3, {}).find("edge = 0"), std::string::npos);
  EXPECT_NE(refusal(0.25, 13, {}).find("halvings = 13"), std::string::npos);
  EXPECT_NE(refusal(0.25, 3, {0.2, 0.1}).find("increasing"), std::string::npos);
  EXPECT_NE(refusal(0.25, 3, {1.5}).find("increasing"), std::string::npos);
}

} // namespace asperity::meshes::halvable_layers_test
