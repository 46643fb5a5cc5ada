// Tests of fem/plugin.hpp: this program does not link deal.II, the loaded
// module does, and its block is that of the case.
#include "base/fourier.hpp"
#include "contact/operators/layered_compliance.hpp"
#include "fem/plugin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <thread>

namespace asperity::fem::plugin_test {

BlockRequest request(mechanics::Element element, int points) {
  BlockRequest request;
  request.grid = {points, points, 1e-6, 1e-6};
  request.settings.element = element;
  request.settings.far_boundary = mechanics::FarBoundary::sliding;
  request.settings.depth = {0.5, mechanics::ReferenceUnit::length};
  request.scales = {2e9, 1e-6, 1e-6 / points, 1e-9};
  request.youngs_modulus = 2e9 * (1 - 0.09);
  request.poisson_ratio = 0.3;
  return request;
}

std::vector<double> longest_wave(const Grid& grid) {
  std::vector<double> wave(grid.size());
  for (std::size_t i = 0; i < wave.size(); ++i)
    wave[i] = std::cos(2.0 * std::numbers::pi * static_cast<double>(i % 16) /
                       grid.points_x);
  return wave;
}

// Verifies that the program and the module plan their transforms under one
// lock. With a lock each, the single planner of FFTW is corrupted and the
// process crashes.
TEST(FemModule, SharesThePlannerWithTheProgram) {
  const auto block =
      load_fem_module().condensed(request(mechanics::Element::q1, 64));
  const Grid other{48, 40, 1.0, 1.0};

  const std::jthread program([&] {
    for (int i = 0; i < 3000; ++i)
      const RealFourier planned(other);
  });
  for (int i = 0; i < 3000; ++i)
    ASSERT_NE(block->coarsened(), nullptr);
}

// Verifies that modulus, depth and far boundary reach the module: a slab half
// as deep as its wave with a sliding far boundary gives 0.9734 of the
// half-space's 2/(E* q); Q2 with 16 nodes per wavelength and grading ratio 1.2
// is within 1 % of that.
TEST(FemModule, BuildsTheBlockOfTheCase) {
  const BlockRequest block = request(mechanics::Element::q2, 16);
  const std::vector<double> wave = longest_wave(block.grid);
  std::vector<double> displacement(wave.size());

  load_fem_module().condensed(block)->displacement(wave, displacement);

  const double half_space = 2.0 / (2e9 * 2.0 * std::numbers::pi / 1e-6);
  EXPECT_NEAR(displacement[0] / half_space, 0.9734, 0.01);
}

// Verifies that the layers of the case reach the module with their depths and
// moduli: a coating a tenth of the wavelength thick and ten times stiffer,
// which is not an integer number of cells. Q2 with 32 nodes per wavelength and
// grading ratio 1.2 is within 0.3 % of the exact layers.
TEST(FemModule, BuildsTheLayersOfTheCase) {
  BlockRequest block = request(mechanics::Element::q2, 32);
  block.layers = {{{0.06, mechanics::ReferenceUnit::length}, {18e9, 0.2}},
                  {{4e-8, mechanics::ReferenceUnit::si}, {18e9, 0.2}}};
  std::vector<double> wave(block.grid.size());
  for (std::size_t i = 0; i < wave.size(); ++i)
    wave[i] = std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / 32);
  std::vector<double> displacement(wave.size());

  load_fem_module().condensed(block)->displacement(wave, displacement);

  const double exact = contact::layered_compliance(
      2.0 * std::numbers::pi / 1e-6,
      {2e9, 0.3, 0.5e-6, mechanics::FarBoundary::sliding, {{1e-7, 18e9, 0.2}}});
  EXPECT_NEAR(displacement[0] / exact, 1.0, 0.003);
}

TEST(FemModule, NamesItsLibrariesAndRefusesBadBlocks) {
  EXPECT_NE(load_fem_module().versions().find("deal.II 9."), std::string::npos);
  BlockRequest block = request(mechanics::Element::q1, 8);
  block.settings.depth = {0.01, mechanics::ReferenceUnit::length};
  try {
    load_fem_module().condensed(block);
    FAIL() << "a block thinner than its first layer was accepted";
  } catch (
      const std::domain_error& error) { // across the boundary of the module
    EXPECT_NE(std::string(error.what()).find("depth"), std::string::npos);
  }
}

} // namespace asperity::fem::plugin_test
