// Tests of results/observables/distributions.hpp: densities whose integrals are
// known, and patches that can be counted in a drawing.
#include "results/observables/distributions.hpp"
#include "results/observables/observables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/results/shapes.hpp"

namespace asperity::results {
namespace {

double integral(const Histogram& histogram) {
  double sum = 0.0;
  for (const double density : histogram.density)
    sum += density * histogram.bin_width();
  return sum;
}

double first_moment(const Histogram& histogram) {
  double sum = 0.0;
  for (std::size_t i = 0; i < histogram.density.size(); ++i)
    sum +=
        histogram.density[i] * histogram.bin_width() * histogram.bin_centre(i);
  return sum;
}

// The integral is the area fraction (roundoff of 40 bins), the first moment the
// nominal pressure to half a bin times the area, with and without weights; the
// density of a linear ramp is flat.
TEST(PressureHistogram, IntegratesToAreaAndNominalPressure) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<double> pressure(4000);
  std::vector<double> weights(4000);
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    pressure[i] = std::max(0.0, uniform(random)) * 1e6;
    weights[i] = i % 2 == 0 ? 0.4 : 1.6;
  }
  for (const auto& used : {std::vector<double>{}, weights}) {
    const Histogram histogram = pressure_histogram(pressure, 40, used);

    const double area = counted_area_fraction(pressure, used);
    EXPECT_NEAR(integral(histogram), area, 1e-13);
    EXPECT_NEAR(first_moment(histogram), weighted_mean(pressure, used),
                0.5 * histogram.bin_width() * area);
  }
}

TEST(PressureHistogram, OfARampIsFlat) {
  std::vector<double> pressure(1000);
  for (std::size_t i = 0; i < pressure.size(); ++i)
    pressure[i] = (static_cast<double>(i) + 0.5) * 2.0; // to 2000 Pa

  const Histogram histogram = pressure_histogram(pressure, 10);

  ASSERT_EQ(histogram.density.size(), 10U);
  EXPECT_EQ(histogram.highest, 1999.0);
  for (const double density : histogram.density) // a bin may have one node more
    EXPECT_NEAR(density * 2000.0, 1.0, 0.02);
}

// Only open nodes count: neither contact with penetration (negative gap) nor
// contact at zero gap does; a gap that is below zero by roundoff does.
TEST(GapHistogram, IsOfTheOpenNodes) {
  const std::vector<double> pressure{5.0, 5.0, 0.0, 0.0, 0.0};
  const std::vector<double> gap{-1.0, 0.0, -1e-20, 0.1, 1.0};

  const Histogram histogram = gap_histogram(gap, pressure, 4);

  EXPECT_NEAR(integral(histogram), 3.0 / 5.0, 1e-15);
  EXPECT_NEAR(histogram.density[0] * histogram.bin_width(), 2.0 / 5.0, 1e-15);
  EXPECT_NEAR(histogram.density[3] * histogram.bin_width(), 1.0 / 5.0, 1e-15);
}

TEST(Histograms, HaveNoBinsWhereNothingIsCounted) {
  EXPECT_TRUE(pressure_histogram(std::vector{0.0, 0.0}, 8).density.empty());
  EXPECT_TRUE(gap_histogram(std::vector{0.0, 0.0}, std::vector{1.0, 1.0}, 8)
                  .density.empty());
  EXPECT_THROW(pressure_histogram(std::vector{1.0}, 0), std::domain_error);
  EXPECT_THROW(pressure_histogram(std::vector{1.0 / 0.0}, 3),
               std::domain_error);
}

/// A map drawn with '#' for contact, row iy = 0 first.
std::vector<double> drawn(const std::string& rows) {
  std::vector<double> pressure;
  for (const char cell : rows)
    if (cell != '\n')
      pressure.push_back(cell == '#' ? 1.0 : 0.0);
  return pressure;
}

// The four neighbours connect, also across the periodic boundary; a corner does
// not. The four corners of the drawing are one patch (4 + the 2 beside them),
// the block of 2 x 2 one, the node at its corner one.
TEST(ContactPatches, ConnectAcrossBordersButNotAcrossCorners) {
  const Grid grid{6, 5, 6.0, 10.0}; // cells of 1 x 2 m
  const auto pressure = drawn("##...#\n"
                              "......\n"
                              "..##..\n"
                              "..##..\n"
                              "#...##\n");

  const ContactPatches patches = contact_patches(grid, pressure);

  EXPECT_EQ(patches.areas, (std::vector{12.0, 8.0}));
  EXPECT_EQ(patches.patch_of_node[grid.index(0, 0)], 0);
  EXPECT_EQ(patches.patch_of_node[grid.index(5, 4)], 0);
  EXPECT_EQ(patches.patch_of_node[grid.index(3, 3)], 1);
  EXPECT_EQ(patches.patch_of_node[grid.index(2, 0)], -1);
}

TEST(ContactPatches, CornersOnlyDoNotConnect) {
  const Grid grid{4, 4, 4.0, 4.0};
  const auto pressure = drawn("#...\n.#..\n..##\n....\n");

  const ContactPatches patches = contact_patches(grid, pressure);

  EXPECT_EQ(patches.areas, (std::vector{2.0, 1.0, 1.0}));
  EXPECT_EQ(patches.patch_of_node[grid.index(2, 2)], 0); // the largest
  EXPECT_EQ(patches.patch_of_node[grid.index(0, 0)], 1);
}

// A ring is one patch and a spiral is one, however the labels have to be
// merged; a checkerboard has one patch per node.
TEST(ContactPatches, ConnectWindingShapes) {
  const Grid grid{8, 8, 8.0, 8.0};
  const auto spiral = drawn("........\n"
                            ".######.\n"
                            "......#.\n"
                            ".####.#.\n"
                            ".#..#.#.\n"
                            ".#....#.\n"
                            ".######.\n"
                            "........\n");
  EXPECT_EQ(contact_patches(grid, spiral).areas,
            std::vector{weighted_mean(spiral) * 64.0});

  std::vector<double> checkerboard(64);
  for (int iy = 0; iy < 8; ++iy)
    for (int ix = 0; ix < 8; ++ix)
      checkerboard[grid.index(ix, iy)] = (ix + iy) % 2;
  EXPECT_EQ(contact_patches(grid, checkerboard).areas.size(), 32U);
}

// The areas of the patches sum to the counted area, weighted or not (roundoff
// of 4096 terms), and neighbours have the same label.
TEST(ContactPatches, PartitionTheContact) {
  const Grid grid{64, 64, 1.0, 1.0};
  std::mt19937 random(5);
  std::bernoulli_distribution in_contact(0.45);
  std::vector<double> pressure(grid.size());
  std::vector<double> weights(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    pressure[i] = in_contact(random) ? 1.0 : 0.0;
    weights[i] = i % 2 == 0 ? 0.5 : 1.5;
  }

  const ContactPatches patches = contact_patches(grid, pressure, weights);

  double sum = 0.0;
  for (const double area : patches.areas)
    sum += area;
  EXPECT_NEAR(sum, counted_area_fraction(pressure, weights), 1e-12);
  EXPECT_TRUE(std::is_sorted(patches.areas.rbegin(), patches.areas.rend()));
  for (int iy = 0; iy < 64; ++iy)
    for (int ix = 0; ix < 64; ++ix) {
      const int here = patches.patch_of_node[grid.index(ix, iy)];
      const int right = patches.patch_of_node[grid.index((ix + 1) % 64, iy)];
      EXPECT_TRUE(here < 0 || right < 0 || here == right);
      EXPECT_EQ(here >= 0, pressure[grid.index(ix, iy)] > 0.0);
    }
}

} // namespace
} // namespace asperity::results
