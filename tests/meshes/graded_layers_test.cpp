// Claims about meshes/graded_layers.hpp.
#include "meshes/graded_layers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace asperity::meshes {
namespace {

double sum_of(const std::vector<double>& thickness) {
  return std::accumulate(thickness.begin(), thickness.end(), 0.0);
}

std::string refusal(double surface_thickness, double growth, double depth) {
  try {
    graded_layers(surface_thickness, growth, depth);
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return "";
}

// Claim: the depth is met, the surface layer kept, no ratio exceeds the growth
// asked for. Tolerance: the last layer takes up the rounding of a sum of n
// terms, at most n eps depth, which is largest for the 512 equal layers.
TEST(GradedLayers, ReachTheDepthWithoutBeingCoarserThanAsked) {
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

// Claim: a depth that is a geometric sum needs no fitting: 1 + 2 + 4 + 8 = 15.
TEST(GradedLayers, KeepAGrowthThatFits) {
  const std::vector<double> thickness = graded_layers(1.0, 2.0, 15.0);

  ASSERT_EQ(thickness.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(thickness[i], std::ldexp(1.0, static_cast<int>(i)), 1e-13);
}

// Claim: no layer is wasted: with one fewer the growth would exceed the asked.
TEST(GradedLayers, AreAsFewAsTheGrowthAllows) {
  const std::vector<double> thickness = graded_layers(1.0, 1.2, 512.0);

  const double n_layers = static_cast<double>(thickness.size());
  EXPECT_GE((std::pow(1.2, n_layers) - 1.0) / 0.2, 512.0);
  EXPECT_LT((std::pow(1.2, n_layers - 1.0) - 1.0) / 0.2, 512.0);
}

TEST(GradedLayers, OfOneLayerAreTheDepth) {
  EXPECT_EQ(graded_layers(2.0, 1.2, 2.0), std::vector<double>{2.0});
}

TEST(GradedLayers, RefuseImpossibleBlocksInWords) {
  EXPECT_NE(refusal(1.0, 1.2, 0.5).find("depth"), std::string::npos);
  EXPECT_NE(refusal(1.0, 1.2, 1.2).find("at least 1.5 of them"),
            std::string::npos);
  EXPECT_NE(refusal(1.0, 0.9, 8.0).find("growth"), std::string::npos);
  EXPECT_NE(refusal(-1.0, 1.2, 8.0).find("surface_thickness"),
            std::string::npos);
  EXPECT_NE(refusal(1.0, 1.0, 1e7).find("100000 layers"), std::string::npos);
  EXPECT_NE(refusal(1.0, std::nan(""), 8.0).find("growth"), std::string::npos);
}

} // namespace
} // namespace asperity::meshes
