// Tests of base/fourier.hpp: sign, normalisation and storage order.
#include "base/fourier.hpp"
#include "tests/base/fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity::fourier_test {

constexpr Grid grid{8, 6, 2.0, 3.0};

std::vector<double> wave(int wavenumber_x, int wavenumber_y, double phase) {
  std::vector<double> field(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      field[grid.index(ix, iy)] = std::cos(
          wavevector(wavenumber_x, grid.length_x) * ix * grid.spacing_x() +
          wavevector(wavenumber_y, grid.length_y) * iy * grid.spacing_y() +
          phase);
  return field;
}

// cos(q.x + phase) has the one coefficient exp(i phase)/2 at +q, stored in row
// jy = -1 + points_y. Tolerance: 50 sums of order one, 50 eps = 1e-14.
TEST(RealFourier, HasTheDocumentedSignAndOrder) {
  const RealFourier fourier(grid);
  std::vector<std::complex<double>> spectrum(grid.half_spectrum_size());

  fourier.forward(wave(2, -1, 0.3), spectrum);

  const std::size_t columns = 5; // 8/2 + 1
  const std::size_t at = 5 * columns + 2;
  const double count = static_cast<double>(grid.size());
  EXPECT_NEAR(spectrum[at].real() / count, 0.5 * std::cos(0.3), 1e-14);
  EXPECT_NEAR(spectrum[at].imag() / count, 0.5 * std::sin(0.3), 1e-14);
  for (std::size_t j = 0; j < spectrum.size(); ++j) {
    if (j == at)
      continue;
    EXPECT_NEAR(std::abs(spectrum[j]) / count, 0.0, 1e-14) << j;
  }
}

TEST(RealFourier, BackwardInvertsForwardTimesTheSize) {
  const RealFourier fourier(grid);
  const std::vector<double> field = wave(3, 2, 0.7);
  std::vector<std::complex<double>> spectrum(grid.half_spectrum_size());
  std::vector<double> back(grid.size());

  fourier.forward(field, spectrum);
  fourier.backward(spectrum, back);

  for (std::size_t i = 0; i < field.size(); ++i)
    EXPECT_NEAR(back[i] / static_cast<double>(grid.size()), field[i], 1e-14);
}

// Verifies that three threads give the same transform. Tolerance: roundoff of a
// sum over 256 log2(256) values of order one.
TEST(RealFourier, RestoresTheFieldOnThreeThreads) {
  const Grid square{256, 256, 1.0, 1.0};
  const RealFourier fourier(square, 3);
  std::vector<double> field(square.size());
  for (std::size_t i = 0; i < field.size(); ++i)
    field[i] = std::sin(static_cast<double>(i));
  std::vector<std::complex<double>> spectrum(square.half_spectrum_size());
  std::vector<double> back(square.size());

  fourier.forward(field, spectrum);
  fourier.backward(spectrum, back);

  for (double& value : back)
    value /= static_cast<double>(square.size());
  EXPECT_LT(tests::largest_difference(back, field), 1e-14);
}

TEST(SignedWavenumber, CountsTheNyquistRowAsPositive) {
  EXPECT_EQ(signed_wavenumber(3, 8), 3);
  EXPECT_EQ(signed_wavenumber(4, 8), 4);
  EXPECT_EQ(signed_wavenumber(5, 8), -3);
  EXPECT_EQ(signed_wavenumber(2, 5), 2);
  EXPECT_EQ(signed_wavenumber(3, 5), -2);
}

// Lengths that differ by the roundoff of a product are equal; those that differ
// by printed digits are not.
TEST(Grid, TreatsRoundedLengthsAsEqual) {
  EXPECT_NE(10.0 * 1e-6, 1e-5);
  EXPECT_TRUE(is_same_length(10.0 * 1e-6, 1e-5));
  EXPECT_FALSE(is_same_length(1e-5 * (1.0 + 1e-11), 1e-5));
}

} // namespace asperity::fourier_test
