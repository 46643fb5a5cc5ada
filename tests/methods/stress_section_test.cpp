// Tests of the section of a full 3-D block, run/methods/stress_section.hpp: the
// requested points, and the positions of the values.
#include "run/methods/stress_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::methods::stress_section_test {

/// Returns a function of the position and stores the requested points.
class KnownBlock final : public fem::FullBlock {
public:
  const Grid& grid() const override { return grid_; }

  std::size_t unknowns() const override { return 0; }

  std::span<const double> nodal_weights() const override { return {}; }

  std::vector<double> displacement(std::span<const double>) override {
    return {};
  }

  std::string report() const override { return ""; }

  fem::BlockSolution solve(std::span<const double>,
                           const mechanics::LoadTarget&,
                           const fem::BlockContact&) override {
    return {};
  }

  fem::StressPeak strongest_stress() const override { return {}; }

  std::vector<double> section(const fem::SectionPlane& plane) const override {
    asked = plane;
    std::vector<double> values;
    for (const double depth : plane.depth)
      for (const double x : plane.x)
        values.push_back(x + 10.0 * depth);
    return values;
  }

  void write(const std::string&) override {}

  fem::ContactStiffness stiffness() override { return {}; }

  fem::BlockConduction conduction() const override { return {}; }

  mutable fem::SectionPlane asked;

private:
  Grid grid_{16, 16, 1.6, 1.6};
};

const mechanics::ElasticBlock halfspace{1e9, 0.3,
                                        std::numeric_limits<double>::infinity(),
                                        mechanics::FarBoundary::clamped};

OwnSection at(double x, double depth, bool is_periodic) {
  return {
      "fem", 5e6, {1e6, 5e5, std::abs(depth), {x, 0.7, depth}}, is_periodic};
}

// The plane contains the point of maximum stress, extends to four times its
// depth and six to either side, wrapped into the period; each value has its
// position.
TEST(OwnSection, ContainsTheMaximum) {
  const KnownBlock block;

  const results::Table table =
      stress_section(at(0.32, 0.11, true), block, halfspace);

  EXPECT_EQ(table.name, "stress-section-fem");
  EXPECT_EQ(block.asked.y, 0.7);
  EXPECT_FALSE(block.asked.is_counter);
  const std::vector<double> x = table.values("x");
  const std::vector<double> depth = table.values("depth");
  const std::vector<double> strength = table.values("von_mises");
  EXPECT_NEAR(x.front(), -0.7, 1e-12);
  EXPECT_NEAR(x.back(), 0.7, 1e-12);
  EXPECT_EQ(depth.front(), 0.0);
  EXPECT_NEAR(depth.back(), 0.44, 1e-12);
  ASSERT_EQ(strength.size(), x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double place = 0.32 + x[i] + (0.32 + x[i] < 0.0 ? 1.6 : 0.0);
    EXPECT_NEAR(strength[i], place + 10.0 * depth[i], 1e-12) << i;
  }
}

// Beyond free sides there is no value.
TEST(OwnSection, EndsAtFreeSides) {
  const KnownBlock block;

  const std::vector<double> x =
      stress_section(at(0.32, 0.11, false), block, halfspace).values("x");

  EXPECT_NEAR(*std::min_element(x.begin(), x.end()), -0.3, 1e-12);
  EXPECT_NEAR(*std::max_element(x.begin(), x.end()), 0.7, 1e-12);
}

// A point in the second body has its section there; one next to the contact
// surface is shown from a depth of one spacing, and no deeper than the block.
TEST(OwnSection, IsOfTheBodyOfThePointAndWithinIt) {
  const KnownBlock block;
  mechanics::ElasticBlock slab = halfspace;
  slab.thickness = 0.3;

  const std::vector<double> counter =
      stress_section(at(0.8, -0.01, true), block, halfspace).values("depth");
  const bool is_counter = block.asked.is_counter;
  const std::vector<double> within =
      stress_section(at(0.8, 0.2, true), block, slab).values("depth");

  EXPECT_TRUE(is_counter);
  EXPECT_NEAR(counter.back(), 0.4, 1e-12);
  EXPECT_NEAR(within.back(), 0.3, 1e-12);
}

// With two bodies the section reaches as far into the second one, in equal
// steps through the contact surface, which appears once.
TEST(OwnSection, ExtendsThroughBothBodies) {
  const KnownBlock block;
  OwnSection section = at(0.8, -0.1, true);
  section.has_counter = true;

  const results::Table table = stress_section(section, block, halfspace);

  const std::vector<double> depth = table.values("depth");
  const std::vector<double> x = table.values("x");
  const std::vector<double> strength = table.values("von_mises");
  const auto n_x = static_cast<std::size_t>(
      std::count(depth.begin(), depth.end(), depth.front()));
  ASSERT_EQ(depth.size() % n_x, 0U);
  EXPECT_NEAR(depth.front(), -0.4, 1e-12);
  EXPECT_NEAR(depth.back(), 0.4, 1e-12);
  const std::size_t n_rows = depth.size() / n_x;
  for (std::size_t row = 0; row < n_rows; ++row)
    EXPECT_NEAR(depth[row * n_x],
                -0.4 + 0.8 * static_cast<double>(row) /
                           static_cast<double>(n_rows - 1),
                1e-12);
  for (std::size_t i = 0; i < strength.size(); ++i) {
    const double place = 0.8 + x[i];
    const double wrapped = place - 1.6 * std::floor(place / 1.6);
    EXPECT_NEAR(strength[i], wrapped + 10.0 * std::abs(depth[i]), 1e-12) << i;
  }
}

} // namespace asperity::methods::stress_section_test
