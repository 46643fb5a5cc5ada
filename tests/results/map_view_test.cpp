// Tests of large maps that are left in a result file: what is found of them by
// pieces has the bits of what is found in memory.
#include "input/input_error.hpp"
#include "results/observables/distributions.hpp"
#include "results/observables/pressure_fit.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "results/storage/hdf5_file.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <unistd.h>
#include <vector>

namespace asperity::results::map_view_test {

// Two pieces whose bounds are neither those of chunks of nodes nor those of the
// chunks of the file.
constexpr Grid grid{3000, 1500, 3e-6, 1.5e-6};

/// A result with large maps, written once.
class LargeMaps : public ::testing::Test {
protected:
  static void SetUpTestSuite() {
    ASSERT_GT(grid.size(), large_map);
    SurfaceRecord surface;
    surface.grid = grid;
    Fields fields{4, sample_point(4).nominal_pressure, {}, {}, grid};
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const double height = std::sin(1e-3 * static_cast<double>(i * i % 10007));
      surface.heights.push_back(height);
      fields.pressure.push_back(std::max(0.0, height - 0.2));
      fields.gap.push_back(std::max(0.0, 0.2 - height));
    }
    fill_numbers(surface);
    surface.rms_height = not_given;
    ResultWriter writer(folder_, sample_case());
    writer.record_surface(0, surface);
    writer.begin_method("md", "md", "");
    writer.append_step_with_fields("md", 0, sample_point(4), grid, fields);
    writer.finish("complete");
    in_memory_ = read_result(folder_);
    in_file_ = read_result(folder_, MapsInFile::large);
  }

  static void TearDownTestSuite() {
    std::filesystem::remove_all(folder_);
    in_memory_ = in_file_ = {};
  }

  static const Fields& fields_of(const Result& result) {
    return result.methods.at(0).realizations.at(0).fields.at(0);
  }

  inline static const std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      ("asperity_large_maps_" + std::to_string(::getpid()));
  inline static Result in_memory_, in_file_;
};

TEST_F(LargeMaps, StayInTheFileUntilTheyAreNeeded) {
  const Fields& left = fields_of(in_file_);
  EXPECT_TRUE(left.pressure.empty());
  EXPECT_TRUE(left.gap.empty());
  EXPECT_TRUE(in_file_.surfaces.at(0).heights.empty());
  EXPECT_TRUE(in_file_.surfaces.at(0).has_heights());
  EXPECT_EQ(left.grid, grid);

  const Fields& held = fields_of(in_memory_);
  EXPECT_TRUE(left.pressure_map().whole() == held.pressure);
  EXPECT_TRUE(left.gap_map().whole() == held.gap);
  EXPECT_TRUE(in_file_.surfaces[0].height_map().whole() ==
              in_memory_.surfaces.at(0).heights);
}

TEST_F(LargeMaps, ArriveInTheirOrderInPiecesOfWholePairsOfRows) {
  const Fields& held = fields_of(in_memory_);
  const Fields& left = fields_of(in_file_);
  int pieces = 0;
  std::size_t next = 0;
  each_piece(
      std::array{left.gap_map(), MapView(held.pressure)},
      [&](std::size_t first, const auto& values) {
        ++pieces;
        ASSERT_EQ(first, next);
        ASSERT_EQ(first % (2 * 3000), 0U);
        ASSERT_EQ(values[0].size(), values[1].size());
        ASSERT_LE(values[0].size(), values_at_a_time);
        EXPECT_TRUE(std::ranges::equal(
            values[0], std::span(held.gap).subspan(first, values[0].size())));
        EXPECT_EQ(values[1].data(), held.pressure.data() + first);
        next += values[0].size();
      });
  EXPECT_EQ(next, grid.size());
  EXPECT_EQ(pieces, 2);
}

TEST_F(LargeMaps, HaveTheSameNumbersAndDistributions) {
  const Fields& held = fields_of(in_memory_);
  const Fields& left = fields_of(in_file_);
  EXPECT_EQ(in_file_.surfaces.at(0).rms_height,
            in_memory_.surfaces.at(0).rms_height);
  EXPECT_EQ(extremes_of(left.gap_map()).largest,
            *std::ranges::max_element(held.gap));
  EXPECT_EQ(extremes_of(left.gap_map()).least, 0.0);

  const PressureFit fit = fit_pressure_distribution(held.pressure);
  ASSERT_GT(fit.variance, 0.0);
  EXPECT_EQ(fit_pressure_distribution(left.pressure_map()).variance,
            fit.variance);
  EXPECT_EQ(fit_pressure_distribution(left.pressure_map()).nominal_pressure,
            fit.nominal_pressure);
  EXPECT_EQ(pressure_histogram(left.pressure_map(), 50).density,
            pressure_histogram(held.pressure, 50).density);
  EXPECT_EQ(gap_histogram(left.gap_map(), left.pressure_map(), 50).density,
            gap_histogram(held.gap, held.pressure, 50).density);
}

// A value that is not finite is found where it is, as in a map in memory.
TEST_F(LargeMaps, AreValidatedByPieces) {
  const std::filesystem::path path = folder_ / "changed.h5";
  std::filesystem::copy_file(folder_ / "result.h5", path);
  {
    const std::lock_guard lock(hdf5_mutex());
    Hdf5File file(path, Hdf5File::Mode::read_write);
    Hdf5Group surface = file.open_path("/surfaces/0");
    std::vector<double> heights = surface.numbers("heights");
    heights[1498 * 3000 + 7] = std::numeric_limits<double>::infinity();
    surface.remove("heights");
    surface.write_map("heights", heights, {1500, 3000}, Hdf5Number::float64,
                      "m");
    file.close();
  }
  const auto message_of = [&](MapsInFile left) {
    try {
      (void)read_result(path, left);
    } catch (const input::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message_of(MapsInFile::large).find("heights[1498, 7] = inf"),
            std::string::npos)
      << message_of(MapsInFile::large);
  EXPECT_EQ(message_of(MapsInFile::large), message_of(MapsInFile::none));
}

TEST_F(LargeMaps, CannotBeReadWithoutTheirFile) {
  const std::filesystem::path path = folder_ / "removed.h5";
  std::filesystem::copy_file(folder_ / "result.h5", path);
  const Result result = read_result(path, MapsInFile::large);
  std::filesystem::remove(path);
  EXPECT_THROW((void)extremes_of(fields_of(result).gap_map()),
               input::InputError);
}

} // namespace asperity::results::map_view_test
