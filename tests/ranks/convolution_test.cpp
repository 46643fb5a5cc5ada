// Tests of base/ranks/convolution.hpp and base/ranks/shared_rows.hpp: the
// convolution equals the transform pair of RealFourier for any size, and any
// number of threads gives the same bits. On ranks,
// tests/program/shared_halfspace_test.py compares it with one process.
#include "base/fourier.hpp"
#include "base/ranks/convolution.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace asperity::convolution_test {

/// @param grid  or the part of a grid that a field occupies
std::vector<double> uneven_field(const Grid& grid) {
  std::vector<double> field(grid.size());
  for (std::size_t i = 0; i < field.size(); ++i)
    field[i] = std::sin(1.7 * static_cast<double>(i * i % 101));
  return field;
}

EvenColumn symbol_of() {
  return [](int jx, std::span<double> of_jy) {
    for (std::size_t jy = 0; jy < of_jy.size(); ++jy)
      of_jy[jy] = 1.0 / (1.0 + jx + 2.0 * static_cast<double>(jy));
  };
}

template <class Real>
std::vector<Real> in_one_process(const Grid& grid, const Grid& held,
                                 int threads = 1) {
  Convolution<Real> convolution(held, grid, threads);
  const std::vector<double> field = uneven_field(held);
  std::vector<Real> answer(field.begin(), field.end());
  convolution.apply(answer, convolution.arranged(symbol_of()), answer);
  return answer;
}

std::vector<double> by_fourier(const Grid& grid) {
  const RealFourier fourier(grid);
  std::vector<std::complex<double>> modes(grid.half_spectrum_size());
  std::vector<double> field = uneven_field(grid);
  std::vector<double> symbol(static_cast<std::size_t>(grid.points_y) / 2 + 1);
  fourier.forward(field, modes);
  const std::size_t columns = grid.half_spectrum_columns();
  for (std::size_t jx = 0; jx < columns; ++jx) {
    symbol_of()(static_cast<int>(jx), symbol);
    for (int jy = 0; jy < grid.points_y; ++jy)
      modes[static_cast<std::size_t>(jy) * columns + jx] *=
          symbol[static_cast<std::size_t>(
              std::abs(signed_wavenumber(jy, grid.points_y)))] /
          static_cast<double>(grid.size());
  }
  fourier.backward(modes, field);
  return field;
}

const std::vector<Grid> grids{{16, 16, 1.0, 1.0}, {17, 12, 1.0, 2.0},
                              {2, 9, 1.0, 1.0},   {1, 7, 1.0, 1.0},
                              {40, 3, 1.0, 1.0},  {130, 66, 1.0, 1.0},
                              {64, 48, 1.0, 1.0}};

// Tolerance: log2 of the number of nodes in ulp of the largest value, 1.
TEST(Convolution, IsTheTransformPair) {
  for (const Grid& grid : grids) {
    const std::vector<double> expected = by_fourier(grid);
    const std::vector<double> in_double = in_one_process<double>(grid, grid);
    const std::vector<float> in_single = in_one_process<float>(grid, grid);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_NEAR(in_double[i], expected[i], 14 * 2.3e-16);
      ASSERT_NEAR(static_cast<double>(in_single[i]), expected[i], 14 * 1.2e-7);
    }
  }
}

TEST(Convolution, ThreadsChangeNoBit) {
  for (const Grid& grid : grids)
    for (const int threads : {2, 3}) {
      EXPECT_EQ(in_one_process<double>(grid, grid, threads),
                in_one_process<double>(grid, grid));
      EXPECT_EQ(in_one_process<float>(grid, grid, threads),
                in_one_process<float>(grid, grid));
    }
}

// A copy has no scratch memory of the original, and one application leaves
// nothing behind; multipliers need not be stored.
TEST(Convolution, CopiesGiveTheSameBits) {
  const Grid grid{130, 66, 1.0, 1.0};
  const std::vector<double> field = uneven_field(grid);
  std::vector<double> by_copy(grid.size()), unstored(grid.size());
  Convolution<double> convolution(grid, 2);
  const auto symbol = convolution.arranged(symbol_of());
  convolution.apply(field, symbol, unstored);

  Convolution<double>(convolution).apply(field, symbol, by_copy);
  convolution.apply(field, symbol_of(), unstored);

  EXPECT_EQ(by_copy, in_one_process<double>(grid, grid));
  EXPECT_EQ(unstored, by_copy);
}

// Rows of zeros, which are not transformed, beside others: the answers to the
// upper 11 rows and to the rest add up to that of all.
TEST(Convolution, OfRowsOfZerosIsTheRestOfTheOthers) {
  const Grid grid{130, 66, 1.0, 1.0};
  Convolution<double> convolution(grid, 2);
  const auto symbol = convolution.arranged(symbol_of());
  const std::vector<double> field = uneven_field(grid);
  std::vector<double> all(grid.size()), of_upper(grid.size()),
      of_rest(grid.size());
  std::vector<double> upper = field, rest = field;
  for (std::size_t i = 0; i < field.size(); ++i)
    (i < grid.index(0, 11) ? rest : upper)[i] = 0.0;

  convolution.apply(field, symbol, all);
  convolution.apply(upper, symbol, of_upper);
  convolution.apply(rest, symbol, of_rest);

  for (std::size_t i = 0; i < field.size(); ++i)
    ASSERT_NEAR(of_upper[i] + of_rest[i], all[i], 1e-14) << i;
}

/// The part of a field on its first columns and rows.
std::vector<double> part_of(const std::vector<double>& field, const Grid& grid,
                            const Grid& held) {
  std::vector<double> part(held.size());
  for (int iy = 0; iy < held.points_y; ++iy)
    for (int ix = 0; ix < held.points_x; ++ix)
      part[held.index(ix, iy)] = field[grid.index(ix, iy)];
  return part;
}

/// Of the field that is 0 beyond the part.
std::vector<double> on_whole_grid(const Grid& held, const Grid& grid) {
  const std::vector<double> field = uneven_field(held);
  std::vector<double> whole(grid.size());
  for (int iy = 0; iy < held.points_y; ++iy)
    for (int ix = 0; ix < held.points_x; ++ix)
      whole[grid.index(ix, iy)] = field[held.index(ix, iy)];
  Convolution<double>(grid).apply(whole, symbol_of(), whole);
  return part_of(whole, grid, held);
}

// Half of the spectrum is in the answer, and the other half in memory of the
// convolution, in memory that is lent to it, or in that of the field.
TEST(Convolution, OfAPartIsThatOfTheWholeInAnyMemory) {
  for (const Grid& held : {Grid{32, 24, 1.0, 1.0},
                           {8, 24, 1.0, 1.0},
                           {33, 24, 1.0, 1.0},
                           {32, 23, 1.0, 1.0},
                           {20, 6, 1.0, 1.0}}) {
    SCOPED_TRACE(held.points_x * held.points_y);
    const Grid grid{2 * held.points_x, 2 * held.points_y, 2.0, 2.0};
    const std::vector<double> expected = on_whole_grid(held, grid);
    const std::vector<double> own = in_one_process<double>(grid, held);
    for (std::size_t i = 0; i < own.size(); ++i)
      EXPECT_NEAR(own[i], expected[i], 14 * 2.3e-16);
    Convolution<double> convolution(held, grid, 2);
    std::vector<double> field = uneven_field(held);
    std::vector<double> answer(held.size()), memory(held.size(), -7.0);
    convolution.apply(field, symbol_of(), answer,
                      std::as_writable_bytes(std::span(memory)));
    EXPECT_EQ(answer, own);
    convolution.apply(field, symbol_of(), answer,
                      std::as_writable_bytes(std::span(field)));
    EXPECT_EQ(answer, own);
    const bool is_enough = held.points_x % 8 == 0 && held.points_y % 2 == 0;
    EXPECT_EQ(std::ranges::count(memory, -7.0) == 0, is_enough);
  }
}

TEST(Convolution, HasItsSpectrumInTheMemoryOfTheAnswer) {
  const auto beyond = [](const Grid& grid, const Grid& held) {
    return PairTransforms<double>(grid, held.points_y, held.points_x)
        .size_beyond_field();
  };
  const Grid grid{64, 48, 1.0, 1.0};
  EXPECT_EQ(beyond(grid, grid), 0U);
  EXPECT_EQ(beyond({41, 8, 1.0, 1.0}, {41, 8, 1.0, 1.0}), 0U);
  const Grid quarter{32, 24, 1.0, 1.0};
  EXPECT_EQ(beyond(grid, quarter), quarter.size() / 2);
}

/// Analyses a field and synthesises it from its columns.
struct ThereAndBack {
  std::vector<std::complex<double>> spectrum; ///< column by column
  std::vector<double> field;

  friend bool operator==(const ThereAndBack&, const ThereAndBack&) = default;
};

ThereAndBack there_and_back(const Grid& grid, int threads) {
  ThereAndBack found{
      std::vector<std::complex<double>>(grid.half_spectrum_size()),
      std::vector<double>(grid.size())};
  Convolution<double> transform(grid, threads);
  const auto height = static_cast<std::size_t>(grid.points_y);
  const auto column = [&](int jx) {
    return std::span(found.spectrum)
        .subspan(static_cast<std::size_t>(jx) * height, height);
  };
  transform.analyse(uneven_field(grid),
                    [&](int jx, std::span<const std::complex<double>> own) {
                      std::ranges::copy(own, column(jx).begin());
                    });
  transform.synthesise(
      [&](int jx, std::span<std::complex<double>> own) {
        ASSERT_EQ(own.front(), 0.0);
        std::ranges::copy(column(jx), own.begin());
      },
      found.field);
  return found;
}

// Expected: the transforms of FFTW in two dimensions. Tolerance: roundoff, some
// eps log2 N times the largest value.
TEST(Convolution, TransformsThereAndBackWithTheSameBits) {
  for (const Grid& grid : grids) {
    const ThereAndBack alone = there_and_back(grid, 1);
    const std::vector<double> field = uneven_field(grid);
    std::vector<std::complex<double>> spectrum(grid.half_spectrum_size());
    RealFourier(grid).forward(field, spectrum);
    const std::size_t columns = grid.half_spectrum_columns();
    const auto height = static_cast<std::size_t>(grid.points_y);
    const auto count = static_cast<double>(grid.size());
    for (std::size_t jx = 0; jx < columns; ++jx)
      for (std::size_t jy = 0; jy < height; ++jy)
        EXPECT_LT(std::abs(alone.spectrum[jx * height + jy] -
                           spectrum[jy * columns + jx]),
                  1e-14 * count);
    for (std::size_t i = 0; i < field.size(); ++i)
      EXPECT_NEAR(alone.field[i] / count, field[i], 1e-14);
    EXPECT_TRUE(there_and_back(grid, 3) == alone)
        << grid.points_x << " x " << grid.points_y;
  }
}

TEST(SharedRows, RefusesBoundsThatAreNone) {
  tests::on_thread_ranks(2, [](RankGroup& ranks) {
    const Grid grid{8, 8, 1.0, 1.0};
    for (const std::vector<int>& bounds :
         {std::vector{0, 8}, {0, 4, 7}, {1, 4, 8}, {0, 0, 8}})
      EXPECT_THROW(SharedRows(grid, ranks, bounds), std::domain_error);
  });
}

// The number of a row is the value of its nodes.
TEST(SharedRows, KnowsTheRowsBesideItsOwnAndAllRows) {
  const Grid grid{3, 9, 1.0, 1.0};
  const auto check = [&](const SharedRows& rows) {
    const auto row_of = [&](std::size_t i) {
      return rows.first() + static_cast<int>(i / 3) - 1;
    };
    std::vector<int> padded(rows.size() + 6, -1);
    for (std::size_t i = 3; i < padded.size() - 3; ++i)
      padded[i] = row_of(i);
    rows.fill_ghost_rows(std::span(padded));
    for (std::size_t i = 0; i < padded.size(); ++i)
      EXPECT_EQ(padded[i], (row_of(i) + 9) % 9);
    const std::vector<double> own(padded.begin() + 3, padded.end() - 3);
    const std::vector<double> all = rows.gathered(own);
    ASSERT_EQ(all.size(), grid.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      EXPECT_EQ(all[i], static_cast<double>(i / 3));
    EXPECT_TRUE(std::ranges::equal(rows.own(all), own));
  };
  check(SharedRows(grid));
  tests::on_thread_ranks(1, [&](RankGroup& one) {
    check(SharedRows(grid, one, {0, 9}));
  });
  tests::on_thread_ranks(3, [&](RankGroup& three) {
    check(SharedRows(grid, three, {0, 1, 5, 9}));
  });
}

TEST(SharedRows, AreDividedByWholeCells) {
  const Grid grid{8, 518, 1.0, 1.0};
  EXPECT_EQ(row_bounds(grid, 3), (std::vector{0, 176, 352, 518}));
  EXPECT_TRUE(can_share(grid, 3));
  EXPECT_TRUE(can_share({8, 16, 1.0, 1.0}, 2));
  EXPECT_FALSE(can_share({8, 16, 1.0, 1.0}, 3));
}

} // namespace asperity::convolution_test
