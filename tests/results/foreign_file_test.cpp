// Tests of results/result_reader.hpp with files of other programs: the minimum
// that docs/reference/results.md requires is sufficient, and mistakes are
// named.
#include "input/input_error.hpp"
#include "results/result_reader.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/types/method_columns.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace asperity::results::foreign_file_test {

const std::vector<double> pressures{1e6, 2e6, 4e6};
const std::vector<double> gaps{3e-9, 2e-9, 1e-9};

class ForeignFile : public ResultFolder {
protected:
  void SetUp() override {
    ResultFolder::SetUp();
    std::filesystem::create_directories(folder_);
  }

  /// Writes the minimal file, then changes it.
  void write(const std::function<void(Hdf5File&)>& change) {
    const std::lock_guard lock(hdf5_mutex());
    Hdf5File file(path_, Hdf5File::Mode::create);
    file.set_attribute("format", "asperity-result");
    file.set_attribute("format_version", 1);
    file.set_attribute("contact_modulus", 2e9);
    Hdf5Group curve = file.open_or_create("methods")
                          .open_or_create("bem.mine")
                          .open_or_create("0")
                          .open_or_create("curve");
    curve.append("nominal_pressure", pressures, Hdf5Number::float64, "Pa");
    curve.append("mean_gap", gaps, Hdf5Number::float64, "m");
    change(file);
    file.close();
  }

  /// The message of the reader without the path.
  std::string complaint() const {
    try {
      read_result(path_);
    } catch (const input::InputError& error) {
      const std::string text = error.what();
      EXPECT_TRUE(text.starts_with(path_.string() + ": ")) << text;
      return text.substr(path_.string().size() + 2);
    }
    return "accepted";
  }

  std::filesystem::path path_ = folder_ / "theirs.h5";
};

TEST_F(ForeignFile, NeedsOnlyPressureAndGap) {
  write([](Hdf5File&) {});

  const Result result = read_result(path_);

  EXPECT_EQ(result.case_name, "theirs");
  EXPECT_EQ(result.status, "complete");
  EXPECT_TRUE(result.surfaces.empty());
  ASSERT_EQ(result.methods.size(), 1U);
  EXPECT_EQ(result.methods[0].kind, "bem");
  const std::vector<CurvePoint>& points =
      result.methods[0].realizations.at(0).points;
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[2].step, 2);
  EXPECT_EQ(points[2].nominal_pressure, 4e6);
  EXPECT_EQ(points[2].mean_gap, 1e-9);
  EXPECT_TRUE(std::isnan(points[2].area_fraction));
  EXPECT_TRUE(std::isnan(points[2][columns::area_fraction_fit]));
  EXPECT_TRUE(std::isnan(points[2][columns::area_fraction_moment]));
  EXPECT_EQ(points[2].iterations, 0);
  EXPECT_EQ(points[2].status, StepStatus::converged);
  // p doubles every nanometre: K = p ln 2 / 1 nm
  EXPECT_NEAR(points[2].contact_stiffness / (4e6 * std::log(2.0) * 1e9), 1.0,
              1e-12);
}

// The rms height is that of the map where no attribute states it.
TEST_F(ForeignFile, GetsItsRmsHeightFromItsMap) {
  write([](Hdf5File& file) {
    Hdf5Group surface = file.open_or_create("surfaces").open_or_create("0");
    surface.set_attribute("length_x", 1e-6);
    surface.write_map("heights",
                      std::vector{5e-9, 7e-9, 5e-9, 7e-9, 5e-9, 7e-9}, {3, 2},
                      Hdf5Number::float64, "m");
  });

  const SurfaceRecord surface = read_result(path_).surfaces.at(0);

  EXPECT_NEAR(surface.rms_height, 1e-9, 1e-22);
  EXPECT_EQ(surface.grid, (Grid{2, 3, 1e-6, 1e-6}));
  EXPECT_TRUE(std::isnan(surface.rms_slope));
}

// A surface may be known by its statistics alone; the number of points is then
// 0, and nothing else that is not a count is accepted.
TEST_F(ForeignFile, MayLeaveItsGridUnknown) {
  const auto write_points = [this](double points) {
    write([points](Hdf5File& file) {
      Hdf5Group surface = file.open_or_create("surfaces").open_or_create("0");
      surface.set_attribute("rms_height", 3e-9);
      surface.set_attribute("points_x", points);
    });
  };

  write_points(0.0);

  const SurfaceRecord surface = read_result(path_).surfaces.at(0);
  EXPECT_EQ(surface.grid, (Grid{0, 0, 0.0, 0.0}));
  EXPECT_EQ(surface.rms_height, 3e-9);
  for (const double points : {-1.0, 2.5, 1e12}) {
    write_points(points);
    EXPECT_NE(complaint().find("points, but must be an integer between 0 and"),
              std::string::npos)
        << complaint();
  }
}

TEST_F(ForeignFile, IsRefusedByTheNameOfTheMistake) {
  const std::string curve = "/methods/bem.mine/0/curve";
  write([](Hdf5File& file) { file.set_attribute("format", "x"); });
  EXPECT_EQ(complaint(), "/format = \"x\", but must be \"asperity-result\"");
  write([](Hdf5File& file) { file.set_attribute("format_version", 2); });
  EXPECT_EQ(complaint(), "/format_version = 2, but must lie between 1 and 1");
  write([](Hdf5File& file) { file.set_attribute("contact_modulus", "soft"); });
  EXPECT_TRUE(complaint().starts_with(
      "/contact_modulus: cannot read this attribute as a number"));
  write([](Hdf5File& file) { file.remove("methods"); });
  EXPECT_EQ(complaint(), "/methods is missing");
  write([&](Hdf5File& file) { file.remove(curve.substr(1) + "/mean_gap"); });
  EXPECT_EQ(complaint(), curve + "/mean_gap is missing");
  write([&](Hdf5File& file) {
    file.open(curve.substr(1))
        .append("mean_gap", gaps, Hdf5Number::float64, "m");
  });
  EXPECT_EQ(complaint(), curve + "/mean_gap has 6 values, but must have 3, as "
                                 "nominal_pressure");
  write([&](Hdf5File& file) {
    file.open(curve.substr(1))
        .append("iterations", std::vector<double>{1.0, 2.0, NAN},
                Hdf5Number::float64, "1");
  });
  EXPECT_EQ(complaint(),
            curve + "/iterations[2] = nan, but must be an integer >= 0");
  write([&](Hdf5File& file) {
    file.open(curve.substr(1))
        .append("residual", std::vector<std::string>{"a", "b", "c"});
  });
  EXPECT_TRUE(complaint().starts_with(
      curve + "/residual: cannot read this dataset as numbers"));
}

TEST_F(ForeignFile, ThatIsMissingOrNoResultIsRefused) {
  EXPECT_EQ(complaint(), "there is no such file");
  std::filesystem::create_directories(folder_ / "empty");
  EXPECT_THROW(read_result(folder_ / "empty"), input::InputError);
}

// A file that is truncated anywhere is refused by an InputError.
TEST_F(ForeignFile, TruncatedAnywhereIsRefused) {
  write([](Hdf5File&) {});
  for (auto size = std::filesystem::file_size(path_); size > 0;
       size = size * 9 / 10) {
    std::filesystem::resize_file(path_, size - 1);
    EXPECT_TRUE(complaint().starts_with("cannot open this HDF5 file")) << size;
  }
}

} // namespace asperity::results::foreign_file_test
