// Tests of theory/exact/wave_2d.hpp: each limit against a numerical solution by
// the simplest solver, within the range that its header states; the members
// that hold at every load against a different method and against the closed
// forms.
#include "tests/theory/plain_contact.hpp"
#include "tests/theory/wave_2d_elements.hpp"
#include "tests/theory/wave_2d_solution.hpp"
#include "theory/exact/wave_2d.hpp"
#include "theory/exact/wave_2d_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace asperity::theory::wave_2d_test {

using std::numbers::pi;

constexpr double amplitude = 0.5, modulus = 3.0; // lambda = 1
const Wave2dContact wave(amplitude, 1.0, modulus);

// The crests lie between nodes so that the symmetry of the grid does not reduce
// the error.
PlainContact numerical(double ratio, int points) {
  const Grid grid{points, points, 1.0, 1.0};
  std::vector<double> heights(grid.size());
  for (int iy = 0; iy < points; ++iy)
    for (int ix = 0; ix < points; ++ix)
      heights[grid.index(ix, iy)] = amplitude *
                                    std::cos(2.0 * pi * (ix + 0.3) / points) *
                                    std::cos(2.0 * pi * (iy + 0.17) / points);
  return press(grid, heights, modulus, ratio * wave.full_contact_pressure(),
               120);
}

// The error of a counted area is about 0.1 contact perimeter times spacing;
// this is for n round spots or holes of radius r in the unit cell, doubled.
double counting_error(int n_spots, double area, int points) {
  const double radius = std::sqrt(area / (n_spots * pi));
  return 2.0 * 0.1 * n_spots * 2.0 * pi * radius / points;
}

// The error of light_mean_gap is 0.6 to 0.7 D P^{4/3}, the fourth order of the
// crest. (Without the contribution of the neighbours it would be D P.)
TEST(Wave2dLight, MeanGapHasTheStatedError) {
  for (const double ratio : {0.003, 0.01, 0.03}) {
    const double pressure = ratio * wave.full_contact_pressure();

    const double error =
        numerical(ratio, 64).mean_gap - wave.light_mean_gap(pressure);

    const double scaled = error / (amplitude * std::pow(ratio, 4.0 / 3.0));
    EXPECT_GT(scaled, 0.55) << "P = " << ratio;
    EXPECT_LT(scaled, 0.72) << "P = " << ratio;
  }
}

// light_area_fraction is too small by at most a relative 0.8 P^{2/3}.
TEST(Wave2dLight, AreaHasTheStatedError) {
  const int points = 128;
  for (const double ratio : {0.01, 0.03, 0.1}) {
    const double limit =
        wave.light_area_fraction(ratio * wave.full_contact_pressure());
    const double area = numerical(ratio, points).area_fraction;

    const double counting = counting_error(2, limit, points);
    EXPECT_GT(area, limit - counting) << "P = " << ratio;
    EXPECT_LT(area, limit * (1.0 + 0.8 * std::pow(ratio, 2.0 / 3.0)) + counting)
        << "P = " << ratio;
  }
}

// heavy_mean_gap is too small by a relative 0.3 to 0.5 times (1 - P). At 128
// points the numerical gap has a relative error of 0.002.
TEST(Wave2dHeavy, MeanGapHasTheStatedError) {
  for (const double ratio : {0.7, 0.8, 0.9, 0.95}) {
    const double limit =
        wave.heavy_mean_gap(ratio * wave.full_contact_pressure());
    const double gap = numerical(ratio, 128).mean_gap;

    const double resolution = 0.002;
    EXPECT_GT(gap / limit, 1.0 + 0.3 * (1.0 - ratio) - resolution)
        << "P = " << ratio;
    EXPECT_LT(gap / limit, 1.0 + 0.5 * (1.0 - ratio) + resolution)
        << "P = " << ratio;
  }
}

// 1 - heavy_area_fraction is too small by at most a relative 0.5 (1 - P).
TEST(Wave2dHeavy, AreaHasTheStatedError) {
  const int points = 128;
  for (const double ratio : {0.7, 0.9}) {
    const double limit =
        1.0 - wave.heavy_area_fraction(ratio * wave.full_contact_pressure());
    const double open = 1.0 - numerical(ratio, points).area_fraction;

    const double counting = counting_error(2, limit, points);
    EXPECT_GT(open, limit - counting) << "P = " << ratio;
    EXPECT_LT(open, limit * (1.0 + 0.5 * (1.0 - ratio)) + counting)
        << "P = " << ratio;
  }
}

// Full contact begins at p* and its energy is (1/2) mean of p u over the cell.
// Reference: the mean of products of the fields on a grid, which is exact for
// them.
TEST(Wave2dFull, HasTheEnergyOfItsFields) {
  const double full = wave.full_contact_pressure();
  const int points = 16;
  double mean = 0.0;
  for (int iy = 0; iy < points; ++iy)
    for (int ix = 0; ix < points; ++ix) {
      const double shape =
          std::cos(2.0 * pi * ix / points) * std::cos(2.0 * pi * iy / points);
      mean += 0.5 * full * shape * amplitude * shape / (points * points);
    }

  EXPECT_NEAR(wave.full_contact_energy() / mean, 1.0, 1e-14);
  EXPECT_EQ(wave.heavy_area_fraction(full), 1.0);
  EXPECT_EQ(wave.heavy_mean_gap(full), 0.0);
}

TEST(Wave2dInput, RefusesBadArguments) {
  EXPECT_THROW(wave.light_mean_gap(-1.0), std::domain_error);
  EXPECT_THROW(wave.heavy_mean_gap(-1.0), std::domain_error);
  EXPECT_THROW(Wave2dContact(0.0, 1.0, 1.0), std::domain_error);
  EXPECT_THROW(Wave2dContact(1.0, 0.0, 1.0), std::domain_error);
  EXPECT_THROW(Wave2dContact(1.0, 1.0, 0.0), std::domain_error);
}

// D = 1, p* = 1
const Wave2dContact unit_wave(1.0, 1.0,
                              1.0 / (std::numbers::sqrt2 * std::numbers::pi));

// Verifies the table against boundary elements in real space with a direct
// solution of each active set, which share nothing with the solver of the
// table. Tolerance: the gap is of second order, h^2 as measured between 32 and
// 64 elements per side; counting the elements in contact errs by at most a
// quarter of those along the contact boundary, here of round spots or holes.
TEST(Wave2dBetween, AgreesWithBoundaryElements) {
  const int points = 64;
  const double spacing = 1.0 / points;
  for (const double crest_offset : {0.0, 0.5}) {
    const Wave2dElements elements(points, crest_offset);
    for (const double ratio : {0.01, 0.06, 0.15, 0.3, 0.5, 0.75, 0.93}) {
      const Wave2dElements::Answer found = elements.press(ratio);
      const double area = unit_wave.area_fraction(ratio);
      const double boundary =
          2.0 * std::sqrt(std::numbers::pi * std::min(area, 1.0 - area));

      ASSERT_TRUE(found.is_solved) << ratio;
      EXPECT_NEAR(unit_wave.mean_gap(ratio), found.mean_gap, spacing * spacing)
          << ratio;
      EXPECT_NEAR(area, found.area_fraction, 0.25 * boundary * spacing)
          << ratio;
    }
  }
}

// Between the rows of the table it agrees with a new solution on coarser grids:
// the interpolation adds nothing. Tolerance: the error of such grids. Counting
// n nodes errs at random by some sqrt(nodes on the contact boundary)/points^2,
// here 5e-4, and more by the extrapolation; gap and energy are smooth and of
// second order, 2e-6.
TEST(Wave2dBetween, InterpolatesTheSolution) {
  const std::vector<double> pressures{0.01, 0.06, 0.15, 0.3, 0.5, 0.75, 0.93};
  const auto coarse = solve_wave_2d(pressures, 96, 4);
  const auto fine = solve_wave_2d(pressures, 192, 4);
  ASSERT_EQ(fine.size(), pressures.size());
  for (std::size_t k = 0; k < pressures.size(); ++k) {
    const Wave2dSolution found = extrapolated(coarse[k], fine[k]);
    EXPECT_NEAR(unit_wave.area_fraction(pressures[k]), found.area_fraction,
                1e-3);
    EXPECT_NEAR(unit_wave.mean_gap(pressures[k]), found.mean_gap, 2e-6);
    EXPECT_NEAR(unit_wave.elastic_energy(pressures[k]), found.energy, 2e-6);
  }
}

// The work of the load is the elastic energy, which in full contact is D p*/8
// in closed form: the integral of the gap over the entire table, to 3e-7.
TEST(Wave2dBetween, HasTheEnergyOfFullContact) {
  EXPECT_NEAR(unit_wave.elastic_energy(1.0), unit_wave.full_contact_energy(),
              3e-7);
  EXPECT_EQ(unit_wave.elastic_energy(0.0), 0.0);
}

// Both ends tend to the closed forms at the rates that their documentation
// states.
TEST(Wave2dBetween, TendsToTheClosedForms) {
  for (const double ratio : {1e-6, 1e-4, 1e-3}) {
    const double order = std::pow(ratio, 2.0 / 3.0);
    EXPECT_NEAR(unit_wave.area_fraction(ratio) /
                    unit_wave.light_area_fraction(ratio),
                1.0 + 0.75 * order, 0.1 * order);
    EXPECT_NEAR(unit_wave.mean_gap(ratio), unit_wave.light_mean_gap(ratio),
                order * order);
  }
  for (const double deficit : {1e-6, 1e-3}) {
    const double ratio = 1.0 - deficit;
    EXPECT_NEAR((1.0 - unit_wave.area_fraction(ratio)) /
                    (1.0 - unit_wave.heavy_area_fraction(ratio)),
                1.0, deficit + 1e-9);
    EXPECT_NEAR(unit_wave.mean_gap(ratio) / unit_wave.heavy_mean_gap(ratio),
                1.0, deficit + 1e-9);
  }
  EXPECT_EQ(unit_wave.area_fraction(0.0), 0.0);
  EXPECT_EQ(unit_wave.area_fraction(2.0), 1.0);
  EXPECT_EQ(unit_wave.mean_gap(0.0), 1.0);
  EXPECT_EQ(unit_wave.mean_gap(1.0), 0.0);
  EXPECT_THROW(unit_wave.area_fraction(-1.0), std::domain_error);
}

// Except where the spots merge each row follows from the cubic through its four
// neighbours. Tolerance: for the area twice the table's own 1e-4; for the gap
// the remainder of the terms t^{3/2} of the light end after a cubic, 1e-4 at
// first.
TEST(Wave2dBetween, RowsFollowFromTheirNeighbours) {
  const auto rest_of_gap = [](const Wave2dRow& row) {
    return row.reduced_mean_gap -
           unit_wave.light_mean_gap(std::pow(row.load, 1.5));
  };
  for (std::size_t k = 2; k + 2 < wave_2d_table.size(); ++k) {
    const double load = wave_2d_table[k].load;
    if (std::abs(load - 0.375) < 0.03)
      continue;
    double area = 0.0, gap = 0.0;
    for (const std::size_t i : {k - 2, k - 1, k + 1, k + 2}) {
      double weight = 1.0;
      for (const std::size_t j : {k - 2, k - 1, k + 1, k + 2})
        if (j != i)
          weight *= (load - wave_2d_table[j].load) /
                    (wave_2d_table[i].load - wave_2d_table[j].load);
      area += weight * wave_2d_table[i].area_fraction;
      gap += weight * rest_of_gap(wave_2d_table[i]);
    }

    EXPECT_NEAR(area, wave_2d_table[k].area_fraction, 5e-4) << load;
    EXPECT_NEAR(gap, rest_of_gap(wave_2d_table[k]), 2e-5) << load;
  }
}

// The area increases and the gap decreases with the load, also where the two
// interpolants meet.
TEST(Wave2dBetween, IsMonotone) {
  double last_area = 0.0, last_gap = 1.0;
  for (int k = 1; k <= 2000; ++k) {
    const double ratio = std::pow(k / 2000.0, 1.5);
    EXPECT_GT(unit_wave.area_fraction(ratio), last_area) << ratio;
    EXPECT_LT(unit_wave.mean_gap(ratio), last_gap) << ratio;
    last_area = unit_wave.area_fraction(ratio);
    last_gap = unit_wave.mean_gap(ratio);
  }
}

// Verifies the dimensions: gap scales with D, energy with D p*, the load with
// p*.
TEST(Wave2dBetween, ScalesWithTheWave) {
  const Wave2dContact other(2e-6, 3e-5, 7e9);
  const double full = other.full_contact_pressure();

  EXPECT_NEAR(other.area_fraction(0.3 * full) / unit_wave.area_fraction(0.3),
              1.0, 1e-13);
  EXPECT_NEAR(other.mean_gap(0.3 * full) / unit_wave.mean_gap(0.3) / 2e-6, 1.0,
              1e-13);
  EXPECT_NEAR(other.elastic_energy(0.3 * full) / unit_wave.elastic_energy(0.3) /
                  (2e-6 * full),
              1.0, 1e-12);
}

} // namespace asperity::theory::wave_2d_test
