// Tests of base/convolution.hpp: it equals the transform pair of RealFourier
// for any size, and the number of threads changes no bit.
#include "base/convolution.hpp"
#include "base/fourier.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace asperity {
namespace {

const std::vector<Grid> grids{{16, 16, 1.0, 1.0}, {17, 12, 1.0, 2.0},
                              {2, 9, 1.0, 1.0},   {1, 7, 1.0, 1.0},
                              {40, 3, 1.0, 1.0},  {130, 66, 1.0, 1.0}};

std::vector<double> some_field(const Grid& grid) {
  std::vector<double> field(grid.size());
  for (std::size_t i = 0; i < field.size(); ++i)
    field[i] = std::sin(1.7 * static_cast<double>(i * i % 101));
  return field;
}

std::vector<double> some_symbol(const Grid& grid) {
  std::vector<double> symbol;
  for (int jy = 0; jy < grid.points_y; ++jy)
    for (int jx = 0; jx <= grid.points_x / 2; ++jx)
      symbol.push_back(
          1.0 /
          (1.0 + jx + 2.0 * std::abs(signed_wavenumber(jy, grid.points_y))));
  return symbol;
}

template <class Real>
std::vector<Real> convolved(const Grid& grid, int threads) {
  const Convolution<Real> convolution(grid, threads);
  typename Convolution<Real>::Scratch scratch;
  const std::vector<double> field = some_field(grid);
  std::vector<Real> answer(field.begin(), field.end());
  convolution.apply(answer, convolution.arranged(some_symbol(grid)), scratch,
                    answer);
  return answer;
}

std::vector<double> by_fourier(const Grid& grid) {
  const RealFourier fourier(grid);
  std::vector<std::complex<double>> modes(grid.half_spectrum_size());
  const std::vector<double> symbol = some_symbol(grid);
  std::vector<double> field = some_field(grid);
  fourier.forward(field, modes);
  for (std::size_t j = 0; j < modes.size(); ++j)
    modes[j] *= symbol[j] / static_cast<double>(grid.size());
  fourier.backward(modes, field);
  return field;
}

// Tolerance: log2 of the number of nodes in ulp of the largest value, 1.
TEST(Convolution, IsTheTransformPair) {
  for (const Grid& grid : grids) {
    const std::vector<double> expected = by_fourier(grid);
    const std::vector<double> in_double = convolved<double>(grid, 1);
    const std::vector<float> in_single = convolved<float>(grid, 1);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_NEAR(in_double[i], expected[i], 14 * 2.3e-16);
      ASSERT_NEAR(static_cast<double>(in_single[i]), expected[i], 14 * 1.2e-7);
    }
  }
}

TEST(Convolution, ThreadsChangeNoBit) {
  for (const Grid& grid : grids)
    for (const int threads : {2, 3}) {
      EXPECT_EQ(convolved<double>(grid, threads), convolved<double>(grid, 1));
      EXPECT_EQ(convolved<float>(grid, threads), convolved<float>(grid, 1));
    }
}

} // namespace
} // namespace asperity
