// Tests of run/stress_tables.hpp: the tables have Hertz's maximum stress in
// each row from its own map, and a section through it.
#include "run/methods/stress_section.hpp"
#include "run/stress_tables.hpp"
#include "theory/exact/hertz.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::run::stress_tables_test {

constexpr double modulus = 70e9;

mechanics::ElasticBlock halfspace() {
  return {modulus, 0.3, std::numeric_limits<double>::infinity(),
          mechanics::FarBoundary::clamped};
}

/// Hertz's pressure about node (20, 40) of a cell sixteen radii wide.
results::Fields hertz_map(const theory::HertzContact& contact) {
  results::Fields map;
  const double side = 16.0 * contact.contact_radius;
  map.grid = {128, 128, side, side};
  map.pressure.resize(map.grid.size());
  for (int iy = 0; iy < 128; ++iy)
    for (int ix = 0; ix < 128; ++ix)
      map.pressure[map.grid.index(ix, iy)] = theory::hertz_pressure(
          contact, std::hypot((ix - 20) * map.grid.spacing_x(),
                              (iy - 40) * map.grid.spacing_y()));
  map.nominal_pressure = contact.load / map.grid.area();
  return map;
}

// Von Mises 0.620 p_0 and shear 0.310 p_0 at 0.481 a (Johnson, Sec. 4.2; on the
// axis two principal stresses are equal, so that one is half the other).
// Tolerance: eight nodes per radius, and the periodic images, p_0 2 pi/3
// (a/L)^2 = 0.8 % of p_0.
TEST(StressTables, HaveHertzsMaximumInEachRow) {
  const theory::HertzContact light = theory::hertz_contact(2.0, 5e-3, modulus);
  const theory::HertzContact heavy = theory::hertz_contact(9.0, 5e-3, modulus);
  const std::vector<results::Fields> maps{hertz_map(light), hertz_map(heavy)};

  const results::Table table =
      stress_table("fem", methods::StressUnderMaps(halfspace()), maps);

  EXPECT_EQ(table.name, "stress-inside-fem");
  ASSERT_EQ(table.values("von_mises").size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const theory::HertzContact& contact = i == 0 ? light : heavy;
    const double p_0 = contact.peak_pressure;
    EXPECT_EQ(table.values("nominal_pressure")[i], maps[i].nominal_pressure);
    EXPECT_NEAR(table.values("von_mises")[i] / p_0, 0.620, 0.01);
    EXPECT_NEAR(table.values("largest_shear")[i],
                0.5 * table.values("von_mises")[i], 1e-6 * p_0);
    EXPECT_NEAR(table.values("depth")[i] / contact.contact_radius, 0.481,
                0.015);
    EXPECT_EQ(table.values("x")[i], 20 * maps[i].grid.spacing_x());
    EXPECT_EQ(table.values("y")[i], 40 * maps[i].grid.spacing_y());
  }
}

// The section contains that point, and no value in it is larger by more than
// the 0.1 % of the search; it is symmetric about the axis.
TEST(StressTables, HaveASectionThroughThatPoint) {
  const results::Fields map =
      hertz_map(theory::hertz_contact(2.0, 5e-3, modulus));
  const results::Table peak =
      stress_table("fem", methods::StressUnderMaps(halfspace()), {{map}});

  const contact::StressPeak point{peak.values("von_mises").front(),
                                  peak.values("depth").front(),
                                  map.grid.index(20, 40)};
  const results::Table section = methods::stress_section(
      "fem", methods::StressUnderMaps(halfspace()), map, point);

  const std::vector<double> x = section.values("x");
  const std::vector<double> depth = section.values("depth");
  const std::vector<double> strength = section.values("von_mises");
  const auto strongest = std::max_element(strength.begin(), strength.end());
  const auto at = static_cast<std::size_t>(strongest - strength.begin());
  EXPECT_NEAR(*strongest / peak.values("von_mises").front(), 1.0, 1e-3);
  EXPECT_NEAR(x[at], 0.0, 1e-12);
  EXPECT_NEAR(depth.back() / peak.values("depth").front(), 4.0, 1e-12);
  EXPECT_EQ(depth.front(), 0.0);
  const std::size_t columns =
      static_cast<std::size_t>(std::count(depth.begin(), depth.end(), 0.0));
  for (std::size_t row = 0; row < strength.size() / columns; ++row)
    EXPECT_NEAR(strength[row * columns], strength[(row + 1) * columns - 1],
                1e-9 * *strongest);
}

// The section of a coated block shows its coating and half as much below it,
// even if the maximum is at a small depth.
TEST(StressTables, HaveASectionThroughTheCoating) {
  const results::Fields map =
      hertz_map(theory::hertz_contact(2.0, 5e-3, modulus));
  mechanics::ElasticBlock block = halfspace();
  const double coating = 20.0 * map.grid.spacing_x();
  block.layers = {{coating, 10.0 * modulus, 0.3}};

  const results::Table section = methods::stress_section(
      "fem", methods::StressUnderMaps(block), map, {0.0, 1e-3 * coating, 0});

  const std::vector<double> depth = section.values("depth");
  EXPECT_NEAR(depth.back() / coating, 1.5, 1e-12);
}

} // namespace asperity::run::stress_tables_test
