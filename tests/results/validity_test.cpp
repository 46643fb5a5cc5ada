// Tests of results/validity.hpp: a number that no solution can have is refused
// by file, method, realisation, step, column, value and range; every other is
// accepted.
#include "base/special_numbers.hpp"
#include "input/input_error.hpp"
#include "results/result_reader.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/types/curve_columns.hpp"
#include "results/types/method_columns.hpp"
#include "tests/results/sample_result.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <mutex>
#include <numbers>
#include <string>
#include <vector>

namespace asperity::results::validity_test {

class Validity : public ResultFolder {
protected:
  using Change = std::function<void(CurvePoint&)>;

  /// The message of the reader about a file whose step 1 (converged) and step 2
  /// (not converged) were changed; "accepted" if it is read.
  std::string complaint(
      const Change& change_converged,
      const Change& change_failed = [](CurvePoint&) {}) {
    CurvePoint converged = sample_point(1);
    CurvePoint failed = sample_point(2);
    change_converged(converged);
    change_failed(failed);
    return complaint_of([&](ResultWriter& writer) {
      writer.append_step("fem", 3, sample_point(0));
      writer.append_step("fem", 3, converged);
      writer.append_step("fem", 3, failed);
    });
  }

  /// The same for a file that is changed after the writer closed it.
  std::string complaint_of_column(const std::string& column,
                                  const std::vector<double>& numbers) {
    return complaint_of(
        [&](ResultWriter& writer) {
          for (int step = 0; step < 3; ++step)
            writer.append_step("fem", 3, sample_point(step));
        },
        [&](Hdf5File& file) {
          file.open("methods/fem/3/curve").overwrite(column, numbers);
        });
  }

  std::string complaint_of(
      const std::function<void(ResultWriter&)>& write,
      const std::function<void(Hdf5File&)>& change = [](Hdf5File&) {}) {
    std::filesystem::remove_all(folder_);
    std::filesystem::path path;
    {
      ResultWriter writer(folder_, sample_case(), ResultWriter::Mode::create);
      writer.begin_method("fem", "fem", "a block");
      write(writer);
      writer.finish("complete");
      path = writer.path();
    }
    {
      const std::lock_guard lock(hdf5_mutex());
      Hdf5File file(path, Hdf5File::Mode::read_write);
      change(file);
      file.close();
    }
    try {
      read_result(path);
    } catch (const input::InputError& error) {
      const std::string text = error.what();
      EXPECT_TRUE(text.starts_with(path.string() + ": ")) << text;
      return text.substr(path.string().size() + 2);
    }
    return "accepted";
  }
};

TEST_F(Validity, NamesMethodRealizationStepColumnValueAndRange) {
  EXPECT_EQ(complaint([](CurvePoint& row) { row.mean_gap = not_a_number; }),
            "/methods/fem/3/curve/mean_gap, step 1 = nan, but must be finite "
            "[m]");
  EXPECT_EQ(
      complaint([](CurvePoint& row) { row.nominal_pressure = not_a_number; }),
      "/methods/fem/3/curve/nominal_pressure, step 1 = nan, but must be "
      "finite [Pa]");
  EXPECT_EQ(complaint([](CurvePoint& row) { row.area_fraction = -1e308; }),
            "/methods/fem/3/curve/area_fraction, step 1 = -1e+308, but must "
            "lie between 0 and 1 [1]");
  EXPECT_EQ(complaint_of_column("iterations", {3.0, -5.0, 4.0}),
            "/methods/fem/3/curve/iterations[1] = -5, but must be an integer "
            ">= 0");
  EXPECT_EQ(complaint_of_column("status", {0.0, 0.0, 7.0}),
            "/methods/fem/3/curve/status[2] = 7, but must be an integer "
            "between 0 and 1");
}

// No column accepts an infinity or, except for those that can be negative, a
// negative number; every column except the two required ones may be NaN.
TEST_F(Validity, HoldsForEveryColumn) {
  for (const CurveColumn& column : curve_columns()) {
    if (column.is_integer || column.name == "contact_stiffness")
      continue; // an integer has no infinity; a stiffness follows from the
                // curve
    const auto with = [&](double number) {
      return complaint([&](CurvePoint& row) { column.set(row, number); });
    };
    EXPECT_NE(with(infinity), "accepted") << column.name;
    EXPECT_NE(with(-infinity), "accepted") << column.name;
    EXPECT_EQ(with(not_a_number) == "accepted", !column.range.is_needed)
        << column.name;
    EXPECT_EQ(with(-1e-3) == "accepted", column.range.lowest < 0.0)
        << column.name;
    EXPECT_EQ(with(1.5) == "accepted", column.range.highest > 1.0)
        << column.name;
  }
}

// A step that did not converge may lack a number, but may have none outside its
// range; fractions may exceed it by roundoff.
TEST_F(Validity, AcceptsAFailedStepWithoutNumbers) {
  const auto nothing = [](CurvePoint&) {};
  EXPECT_EQ(complaint(nothing,
                      [](CurvePoint& row) {
                        row.mean_gap = row.nominal_pressure = not_a_number;
                        row.residual = infinity;
                      }),
            "accepted");
  EXPECT_NE(
      complaint(nothing, [](CurvePoint& row) { row.area_fraction = 1.2; }),
      "accepted");
  EXPECT_EQ(complaint([](CurvePoint& row) { row.area_fraction = 1.0 + 1e-15; }),
            "accepted");
}

TEST_F(Validity, ListsWhatIsWrong) {
  const std::string text = complaint([](CurvePoint& row) {
    row.residual = -1.0;
    row[columns::memory] = infinity;
  });
  EXPECT_NE(text.find("/curve/residual, step 1 = -1, but must be finite and >= "
                      "0 [1]\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("/curve/memory, step 1 = inf, but must be finite and >= "
                      "0 [bytes]"),
            std::string::npos);
}

TEST_F(Validity, RefusesAStepTwice) {
  EXPECT_EQ(complaint_of_column("step", {0.0, 2.0, 2.0}),
            "/methods/fem/3/curve/step: step 2 occurs twice");
}

TEST_F(Validity, OfMapsAndSurfaces) {
  const Grid grid{2, 3, 1e-6, 2e-6};
  const std::vector<double> good(6, 1.0);
  const auto with_maps = [&](const std::vector<double>& pressure,
                             const std::vector<double>& gap) {
    return complaint_of([&](ResultWriter& writer) {
      writer.append_step_with_fields(
          "fem", 0, sample_point(0), grid,
          {0, sample_point(0).nominal_pressure, pressure, gap});
    });
  };
  EXPECT_EQ(with_maps(good, good), "accepted");
  EXPECT_EQ(with_maps(good, {1.0, 1.0, 1.0, not_a_number, 1.0, infinity}),
            "/methods/fem/0/fields/0/gap[1, 1] = nan, but must be "
            "finite [m]; "
            "2 of 6 values are not");
  EXPECT_EQ(with_maps(std::vector<double>(6, not_a_number), good),
            "/methods/fem/0/fields/0/pressure[0, 0] = nan, but must "
            "be finite "
            "[Pa]; 6 of 6 values are not");

  const auto with_surface =
      [&](const std::function<void(SurfaceRecord&)>& change) {
        SurfaceRecord surface = sample_surface(4, 2);
        change(surface);
        return complaint_of(
            [&](ResultWriter& writer) { writer.record_surface(0, surface); });
      };
  EXPECT_EQ(with_surface([](SurfaceRecord&) {}), "accepted");
  EXPECT_EQ(with_surface([](SurfaceRecord& s) { s.heights[5] = not_a_number; }),
            "/surfaces/0/heights[1, 1] = nan, but must be finite [m]; "
            "1 of 8 "
            "values are not");
  EXPECT_EQ(with_surface([](SurfaceRecord& s) { s.rms_height = -1e-9; }),
            "/surfaces/0/rms_height = -1e-09, but must be finite and >= 0 [m]");
  EXPECT_EQ(
      with_surface([](SurfaceRecord& s) { s.spectrum[1].spectrum = infinity; }),
      "/surfaces/0/spectrum/height_spectrum = inf, but must be finite "
      "and >= 0 [m^4]");
}

// Whatever follows from the maps of a result is verified by them. Expected: the
// numbers of h = cos(2 pi x/L) + cos(4 pi y/L_y), in nm, whose mean is 0.
TEST_F(Validity, OfWhatFollowsFromTheHeights) {
  constexpr int n = 16;
  const double pi = std::numbers::pi;
  SurfaceRecord good;
  good.grid = {n, n, 1e-6, 2e-6};
  for (std::size_t i = 0; i < good.grid.size(); ++i)
    good.heights.push_back(
        1e-9 * (std::cos(2.0 * pi * static_cast<double>(i % n) / n) +
                std::cos(4.0 * pi * static_cast<double>(i / n) / n)));
  good.rms_height = 1e-9;
  good.rms_slope = 2e-3 * pi; // both wavevectors are 2 pi/um
  good.rms_curvature = 0.5 * std::pow(2e6 * pi, 2) * 1e-9;
  good.skewness = 0.0;
  good.kurtosis = 2.25; // 3/8 + 3/8 + 6/4
  good.highest = 2e-9;
  const auto with = [&](double SurfaceRecord::*number, double value) {
    SurfaceRecord surface = good;
    surface.*number = value;
    return complaint_of([&](ResultWriter& writer) {
      writer.record_surface(0, surface);
      writer.begin_method("md", "md", "");
      writer.record_own_surface("md", 0, surface);
    });
  };
  EXPECT_EQ(with(&SurfaceRecord::highest, 2e-9), "accepted");
  EXPECT_EQ(with(&SurfaceRecord::rms_slope, not_a_number), "accepted");
  EXPECT_EQ(with(&SurfaceRecord::rms_height, 1.0)
                .substr(0, std::string("/surfaces/0/rms_height = 1, but the "
                                       "heights have 1e-09 [m]")
                               .size()),
            "/surfaces/0/rms_height = 1, but the heights have 1e-09 [m]");
  EXPECT_NE(with(&SurfaceRecord::rms_slope, 6e-3).find("rms_slope = 0.006"),
            std::string::npos);
  EXPECT_NE(with(&SurfaceRecord::rms_slope, 6e-3)
                .find("/methods/md/0/surface/rms_slope"),
            std::string::npos);
  for (double SurfaceRecord::*number :
       {&SurfaceRecord::rms_curvature, &SurfaceRecord::skewness,
        &SurfaceRecord::kurtosis, &SurfaceRecord::highest}) {
    EXPECT_NE(with(number, good.*number * 1.01 + 1e-3), "accepted");
  }
  good.heights.assign(good.grid.size(), 3e-9);
  EXPECT_NE(with(&SurfaceRecord::rms_height, 1e-9), "accepted");
}

// A row, the attributes of its fields and their maps say the same.
TEST_F(Validity, OfWhatFollowsFromTheFields) {
  const Grid grid{2, 3, 1e-6, 2e-6};
  const auto with = [&](const char* kind, double row_pressure, double row_gap,
                        double field_pressure, double length = 2e-6) {
    return complaint_of(
        [&](ResultWriter& writer) {
          CurvePoint row = sample_point(0);
          row.nominal_pressure = row_pressure;
          row.mean_gap = row_gap;
          row[columns::plastic_area] = not_a_number; // no imprint
          writer.begin_method("other", kind, "");
          writer.append_step_with_fields("other", 0, row, grid,
                                         {0,
                                          field_pressure,
                                          {1e6, 2e6, 0, 0, 0, 3e6},
                                          {0, 0, 1.0, 2.0, 3.0, 0}});
        },
        [&](Hdf5File& file) {
          file.open_path("/methods/other/0/fields/0")
              .set_attribute("length_y", length);
        });
  };
  EXPECT_EQ(with("halfspace", 1e6, 1.0, 1e6), "accepted");
  EXPECT_EQ(with("md", 1.1e6, 2.0, 1.1e6), "accepted"); // unequal weights
  EXPECT_EQ(with("md", 1e6, 1.0, 2e6),
            "/methods/other/0/fields/0/nominal_pressure = 2000000, but the row "
            "of this step has 1000000 [Pa]");
  EXPECT_EQ(with("halfspace", 2e6, 1.0, 2e6),
            "/methods/other/0/curve/nominal_pressure, step 0 = 2000000, but "
            "its pressure map has 1000000 [Pa]");
  EXPECT_EQ(with("submission", 1e6, 2.0, 1e6),
            "/methods/other/0/curve/mean_gap, step 0 = 2, but its gap map "
            "has 1 [m]");
  for (const double pressure : {0.0, -1e6})
    EXPECT_NE(with("md", 1e6, 1.0, pressure), "accepted");
  for (const double length : {0.0, -1e-6, infinity, not_a_number})
    EXPECT_EQ(with("md", 1e6, 1.0, 1e6, length),
              fmt::format("/methods/other/0/fields/0/length_y = {}, but must "
                          "be finite and > 0 [m]",
                          length));
}

// With adhesion, the pressures of an unloaded step cancel up to the roundoff of
// their map.
TEST_F(Validity, OfAnUnloadedStepWithTension) {
  const auto with_mean = [&](double mean) {
    return complaint_of([&](ResultWriter& writer) {
      CurvePoint row = sample_point(0);
      row.nominal_pressure = 0.0;
      row.mean_gap = 1.0;
      row[columns::plastic_area] = not_a_number;
      writer.begin_method("other", "halfspace", "");
      writer.append_step_with_fields(
          "other", 0, row, {2, 2, 1e-6, 1e-6},
          {0, 0.0, {1e6 + 4.0 * mean, -1e6, 1e6, -1e6}, {0, 1.0, 1.0, 2.0}});
    });
  };
  EXPECT_EQ(with_mean(1.0), "accepted");
  EXPECT_EQ(
      with_mean(1e4).substr(0, 66),
      "/methods/other/0/fields/0/nominal_pressure = 0, but its pressure m");
}

// The tension of faces far apart is 0 in single precision.
TEST_F(Validity, OfATensionThatNoMapHolds) {
  const auto with_pressure = [&](double pressure) {
    return complaint_of([&](ResultWriter& writer) {
      CurvePoint row = sample_point(0);
      row.nominal_pressure = pressure;
      row.mean_gap = 1.0;
      row[columns::plastic_area] = not_a_number;
      writer.begin_method("other", "halfspace", "");
      writer.append_step_with_fields(
          "other", 0, row, {2, 2, 1e-6, 1e-6},
          {0, pressure, {0.0, 0.0, 0.0, 0.0}, {1.0, 1.0, 1.0, 1.0}});
    });
  };
  EXPECT_EQ(with_pressure(-2.2618133010724967e-47), "accepted");
  EXPECT_NE(with_pressure(-1e-30), "accepted");
}

// Where the whole surface yields its gap is 0, and the mean gap is that of the
// imprint alone, which follows from the work to rounding.
TEST_F(Validity, OfASurfaceAllOfWhichYields) {
  const auto with_gap = [&](double mean_gap) {
    return complaint_of([&](ResultWriter& writer) {
      CurvePoint row = sample_point(0);
      row.nominal_pressure = 3e6;
      row.mean_gap = mean_gap;
      row[columns::plastic_area] = 1.0;
      row[columns::plastic_work] = 3e6 * 2.2380388288374566e-07;
      writer.begin_method("other", "halfspace", "");
      writer.append_step_with_fields(
          "other", 0, row, {2, 2, 1e-6, 1e-6},
          {0, 3e6, {3e6, 3e6, 3e6, 3e6}, {0.0, 0.0, 0.0, 0.0}});
    });
  };
  EXPECT_EQ(with_gap(-2.2380388288374566e-07), "accepted");
  EXPECT_EQ(with_gap(-2.2380388288375e-07), "accepted");
  EXPECT_NE(with_gap(-2.3e-07), "accepted");
}

TEST_F(Validity, OfTablesByTheNameOfTheirColumns) {
  const auto with_area = [&](double area) {
    return complaint_of([&](ResultWriter& writer) {
      writer.record_table({"magnification-1",
                           "seen",
                           {{"area_fraction", "1", {0.5, area}},
                            {"opening_gap", "m", {infinity, -1.0}}}});
    });
  };
  EXPECT_EQ(with_area(1.0), "accepted");
  EXPECT_EQ(with_area(not_a_number), "accepted");
  EXPECT_EQ(with_area(1.5), "/tables/magnification-1/area_fraction[1] = 1.5, "
                            "but must lie between 0 and 1 [1]");
}

} // namespace asperity::results::validity_test
