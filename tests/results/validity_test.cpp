// Tests of results/validity.hpp: a number that no solution can have is refused
// by file, method, realisation, step, column, value and range; every other is
// accepted.
#include "base/special_numbers.hpp"
#include "input/input_error.hpp"
#include "results/result_reader.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/types/curve_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "tests/results/sample_result.hpp"

namespace asperity::results {
namespace {

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
    row.memory = infinity;
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
      writer.append_step_with_fields("fem", 0, sample_point(0), grid,
                                     {0, 1e6, pressure, gap});
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

} // namespace
} // namespace asperity::results
