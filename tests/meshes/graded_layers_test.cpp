// Tests of meshes/layers/graded_layers.hpp.
#include "meshes/layers/graded_layers.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace asperity::meshes::graded_layers_test {

double sum_of(const std::vector<double>& thickness) {
  return std::accumulate(thickness.begin(), thickness.end(), 0.0);
}

std::string refusal(double surface_thickness, double growth, double depth) {
  return tests::message_of<std::domain_error>(
      [&] { graded_layers(surface_thickness, growth, depth); });
}

// The layers end at the depth, the surface layer has its thickness, and no
// ratio exceeds the requested one. Tolerance: the last layer contains the
// roundoff of a sum of n terms, at most n eps depth, which is largest for the
// 512 equal layers.
TEST(GradedLayers, ReachTheDepthWithinTheGradingRatio) {
  for (const double growth : {1.0, 1.05, 1.2, 1.5, 2.0})
    for (const double ratio : {1.5, 2.0, 3.7, 16.0, 341.33, 512.0}) {
      const double surface = 0.3e-9;

      const std::vector<double> thickness =
          graded_layers(surface, growth, ratio * surface);

      const double rounding =
          static_cast<double>(thickness.size()) * ratio * 2.2e-16;
      EXPECT_NEAR(sum_of(thickness) / (ratio * surface), 1.0, 1e-14);
      EXPECT_EQ(thickness.front(), surface);
      for (std::size_t i = 1; i < thickness.size(); ++i) {
        EXPECT_LE(thickness[i] / thickness[i - 1], growth * (1.0 + rounding));
        EXPECT_GT(thickness[i] / thickness[i - 1], 0.49);
      }
    }
}

// A depth that is a geometric sum needs no fitting: 1 + 2 + 4 + 8 = 15.
TEST(GradedLayers, KeepARatioThatFits) {
  const std::vector<double> thickness = graded_layers(1.0, 2.0, 15.0);

  ASSERT_EQ(thickness.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(thickness[i], std::ldexp(1.0, static_cast<int>(i)), 1e-13);
}

// The number of layers is the smallest possible: with one fewer the grading
// ratio would exceed the requested one.
TEST(GradedLayers, AreAsFewAsTheGrowthAllows) {
  const std::vector<double> thickness = graded_layers(1.0, 1.2, 512.0);

  const double n_layers = static_cast<double>(thickness.size());
  EXPECT_GE((std::pow(1.2, n_layers) - 1.0) / 0.2, 512.0);
  EXPECT_LT((std::pow(1.2, n_layers - 1.0) - 1.0) / 0.2, 512.0);
}

TEST(GradedLayers, OfOneLayerAreTheDepth) {
  EXPECT_EQ(graded_layers(2.0, 1.2, 2.0), std::vector<double>{2.0});
}

TEST(GradedLayers, RefuseImpossibleBlocks) {
  EXPECT_NE(refusal(1.0, 1.2, 0.5).find("depth"), std::string::npos);
  EXPECT_NE(refusal(1.0, 1.2, 1.2).find("at least 1.5 thicknesses"),
            std::string::npos);
  EXPECT_NE(refusal(1.0, 0.9, 8.0).find("growth"), std::string::npos);
  EXPECT_NE(refusal(-1.0, 1.2, 8.0).find("surface_thickness"),
            std::string::npos);
  EXPECT_NE(refusal(1.0, 1.0, 1e7).find("100000 layers"), std::string::npos);
  EXPECT_NE(refusal(1.0, std::nan(""), 8.0).find("growth"), std::string::npos);
}

/// The layers, and the depths of all their faces.
struct Stack {
  std::vector<double> thickness;
  std::vector<double> faces;
};

Stack stack(double surface, double growth,
            const std::vector<double>& interfaces, double depth) {
  Stack result{
      graded_layers_with_interfaces(surface, growth, interfaces, depth), {}};
  double sum = 0.0;
  for (const double layer : result.thickness)
    result.faces.push_back(sum += layer);
  return result;
}

bool is_one_of(const std::vector<double>& depths, double depth) {
  return std::any_of(depths.begin(), depths.end(), [&](double one) {
    return std::abs(one / depth - 1.0) < 1e-13;
  });
}

// Each interface is a face of layers, the layers end at the depth, and no layer
// is thicker than the ratio allows or thinner than half the one above, except
// in a material that is itself so thin. Tolerance: roundoff of sums of some 100
// terms, and of the last layer before an interface, which contains it.
TEST(GradedLayersWithInterfaces, MeetEachInterfaceWithoutSlivers) {
  for (const double growth : {1.0, 1.2, 2.0})
    for (const std::vector<double>& interfaces :
         {std::vector{20.0}, std::vector{1.5}, std::vector{1.5, 40.0},
          std::vector{7.3, 7.9, 31.0}, std::vector{3.0, 3.001}}) {
      const double depth = 100.0;

      const Stack layers = stack(1.0, growth, interfaces, depth);

      EXPECT_EQ(layers.thickness.front(), 1.0);
      EXPECT_NEAR(layers.faces.back(), depth, 1e-12);
      for (const double interface : interfaces)
        EXPECT_TRUE(is_one_of(layers.faces, interface)) << interface;
      for (std::size_t i = 1; i < layers.thickness.size(); ++i) {
        const double allowed = growth * layers.thickness[i - 1];
        const bool is_material = is_one_of(interfaces, layers.faces[i - 1]) &&
                                 is_one_of(interfaces, layers.faces[i]);
        EXPECT_LE(layers.thickness[i], allowed * (1.0 + 1e-11));
        EXPECT_GT(layers.thickness[i],
                  is_material ? 0.0
                              : layers.thickness[i - 1] / 2.0 * (1.0 - 1e-11));
      }
    }
}

// A coating that is thinner than the surface layer is divided evenly, and no
// layer is coarser than requested.
TEST(GradedLayersWithInterfaces, CutAThinCoatingEvenly) {
  EXPECT_EQ(stack(1.0, 1.2, {0.25}, 10.0).thickness.front(), 0.25);
  EXPECT_EQ(stack(1.0, 1.2, {1.0}, 10.0).thickness.front(), 1.0);
  const Stack halves = stack(1.0, 2.0, {1.3}, 10.0);
  EXPECT_NEAR(halves.thickness[0], 0.65, 1e-15);
  EXPECT_NEAR(halves.thickness[1], 0.65, 1e-15);
}

TEST(GradedLayersWithInterfaces, WithoutOneAreTheGradedLayers) {
  EXPECT_EQ(graded_layers_with_interfaces(0.3, 1.2, {}, 17.0),
            graded_layers(0.3, 1.2, 17.0));
}

TEST(GradedLayersWithInterfaces, RefuseInterfacesThatDoNotRise) {
  for (const std::vector<double>& interfaces :
       {std::vector{0.0}, std::vector{4.0, 4.0}, std::vector{5.0, 4.0},
        std::vector{10.0}, std::vector{12.0}, std::vector{std::nan("")}})
    EXPECT_THROW(graded_layers_with_interfaces(1.0, 1.2, interfaces, 10.0),
                 std::domain_error);
  EXPECT_THROW(graded_layers_with_interfaces(1.0, 0.5, std::vector{4.0}, 10.0),
               std::domain_error);
}

} // namespace asperity::meshes::graded_layers_test
