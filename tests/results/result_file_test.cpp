// Tests of results/result_writer.hpp and result_reader.hpp: what is written is
// read back, step by step and from any thread, also if a method has another
// surface or grid than the case.
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "results/storage/hdf5_file.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace asperity::results::result_file_test {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

using ResultFile = ResultFolder;

TEST_F(ResultFile, RecordsTheCaseAndIsRunningUntilFinished) {
  ResultWriter writer(folder_ / "new" / "folder", sample_case());
  EXPECT_EQ(read_result(writer.path()).status, "running");
  writer.finish("complete");

  const Result result = read_result(folder_ / "new" / "folder");

  EXPECT_EQ(result.path, writer.path().string());
  EXPECT_EQ(result.case_name, sample_case().name);
  EXPECT_EQ(result.case_title, sample_case().title);
  EXPECT_EQ(result.case_text, sample_case().text);
  EXPECT_EQ(result.case_hash, sample_case().hash);
  EXPECT_EQ(result.reference, sample_case().reference);
  EXPECT_EQ(result.contact_modulus, sample_case().contact_modulus);
  EXPECT_EQ(result.status, "complete");
  EXPECT_TRUE(result.methods.empty());
}

// An ordinary attribute of the library is limited to 64 KiB; a case may be
// longer.
TEST_F(ResultFile, HoldsALongCaseText) {
  CaseInfo info = sample_case();
  info.text = std::string(300'000, '#') + "end";

  const ResultWriter writer(folder_, info);

  EXPECT_EQ(read_result(folder_).case_text, info.text);
}

TEST_F(ResultFile, ReadsBackEveryRowBitForBit) {
  ResultWriter writer(folder_, sample_case());
  writer.begin_method("fem.hard", "fem", "Q1, hard contact");
  writer.begin_method("a-theory", "theory", "");
  CurvePoint with_gaps = sample_point(3);
  with_gaps.contact_perimeter = none;
  writer.append_step("fem.hard", 1, sample_point(0));
  writer.append_step("fem.hard", 1, sample_point(2));
  writer.append_steps("fem.hard", 1, std::vector{with_gaps, sample_point(1)});
  writer.record_setup_time("fem.hard", 1, 0.75);

  const Result result = read_result(folder_);

  ASSERT_EQ(result.methods.size(), 2U);
  EXPECT_EQ(result.methods[0].name, "fem.hard"); // not by the alphabet
  EXPECT_EQ(result.methods[0].kind, "fem");
  EXPECT_EQ(result.methods[0].description, "Q1, hard contact");
  EXPECT_TRUE(result.methods[1].realizations.empty());
  ASSERT_EQ(result.methods[0].realizations.size(), 2U);
  EXPECT_TRUE(result.methods[0].realizations[0].points.empty());
  const Curve& curve = result.methods[0].realizations[1];
  EXPECT_EQ(curve.setup_cpu_time, 0.75);
  ASSERT_EQ(curve.points.size(), 4U);
  expect_same(curve.points[0], sample_point(0)); // in the order of steps
  expect_same(curve.points[1], sample_point(1));
  expect_same(curve.points[2], sample_point(2));
  expect_same(curve.points[3], with_gaps);
}

TEST_F(ResultFile, ReadsBackSurfacesUnchanged) {
  ResultWriter writer(folder_, sample_case());
  const SurfaceRecord expected = sample_surface(3, 5);
  SurfaceRecord without_map = expected;
  without_map.heights.clear();
  without_map.spectrum.clear();
  writer.record_surface(1, sample_surface(4, 4));
  writer.record_surface(1, expected); // in its place
  writer.record_surface(0, without_map);

  const Result result = read_result(folder_);

  ASSERT_EQ(result.surfaces.size(), 2U);
  expect_same(result.surfaces[0], without_map);
  expect_same(result.surfaces[1], expected);
}

// Maps are read back to the roundoff of the floats in which they are stored,
// 2^-24 relative, including negative gaps.
TEST_F(ResultFile, ReadsBackMapsToSinglePrecision) {
  ResultWriter writer(folder_, sample_case());
  const Grid grid{8, 6, 1e-6, 1e-6};
  Fields fields;
  fields.step = 4;
  fields.nominal_pressure = sample_point(4).nominal_pressure;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    fields.pressure.push_back(i % 3 == 0 ? 0.0 : 1e7 / (1.0 + double(i)));
    fields.gap.push_back(1e-9 * (double(i) - 20.0));
  }
  writer.begin_method("fem", "fem", "");
  writer.append_step_with_fields("fem", 0, sample_point(4), grid, fields);
  fields.step = 2;
  writer.append_fields("fem", 0, grid, fields);
  writer.append_fields("fem", 0, grid, fields); // replaces the earlier attempt

  const Result result = read_result(folder_);

  const Curve& curve = result.methods[0].realizations[0];
  ASSERT_EQ(curve.points.size(), 1U);
  ASSERT_EQ(curve.fields.size(), 2U);
  EXPECT_EQ(curve.fields[0].step, 2);
  EXPECT_EQ(curve.fields[1].step, 4);
  EXPECT_EQ(curve.fields[1].nominal_pressure, sample_point(4).nominal_pressure);
  ASSERT_EQ(curve.fields[1].gap.size(), grid.size());
  const double rounding = std::ldexp(1.0, -24);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    EXPECT_NEAR(curve.fields[1].pressure[i], fields.pressure[i],
                rounding * fields.pressure[i]);
    EXPECT_NEAR(curve.fields[1].gap[i], fields.gap[i],
                rounding * std::abs(fields.gap[i]));
  }
}

TEST_F(ResultFile, KeepsFactsInTheirOrderAndReplacesThem) {
  ResultWriter writer(folder_, sample_case());
  Provenance facts;
  for (int i = 0; i < 20; ++i)
    facts.emplace_back("fact_" + std::to_string(20 - i), std::to_string(i));
  writer.record_provenance(facts);
  writer.record_provenance({{"wall_time", "1 s"}});
  writer.record_provenance({{"wall_time", "2 s"}});
  facts.emplace_back("wall_time", "2 s");

  EXPECT_EQ(read_result(folder_).provenance, facts);
}

/// The column as it is in the file, in the order it was written.
std::vector<double> stored_stiffness(const std::filesystem::path& path) {
  const std::lock_guard lock(hdf5_mutex());
  return Hdf5File(path, Hdf5File::Mode::read)
      .open("methods/fem/0/curve")
      .numbers("contact_stiffness");
}

// p = exp(-2 u): the stiffness that no method stated is 2 p. The reader derives
// it from the curve; the file contains it once the run is complete, not before,
// because the ends of an interrupted curve are not yet ends. The steps arrive
// out of order, and the complete file has them in their order.
TEST_F(ResultFile, TakesAMissingStiffnessFromTheCurve) {
  ResultWriter writer(folder_, sample_case());
  writer.begin_method("fem", "fem", "");
  const std::vector<int> steps{0, 2, 1};
  for (const int step : steps) {
    CurvePoint point = sample_point(step);
    point.is_unloading = false;
    point.mean_gap = 4.0 - step;
    point.nominal_pressure = std::exp(-2.0 * point.mean_gap);
    point.contact_stiffness = none;
    writer.append_step("fem", 0, point);
  }

  writer.finish("interrupted");
  const Result interrupted = read_result(folder_);
  const std::vector<double> stored_before = stored_stiffness(writer.path());
  writer.finish("complete");
  const std::vector<double> stored = stored_stiffness(writer.path());

  EXPECT_EQ(interrupted.status, "interrupted");
  for (const CurvePoint& point : interrupted.methods[0].realizations[0].points)
    EXPECT_NEAR(point.contact_stiffness / point.nominal_pressure, 2.0, 1e-14);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_TRUE(std::isnan(stored_before[i]));
    EXPECT_NEAR(stored[i] / std::exp(-2.0 * (4.0 - static_cast<double>(i))),
                2.0, 1e-14);
  }
}

// As a run whose steps with maps come from the cache before the others.
TEST_F(ResultFile, HasItsRowsInTheOrderOfTheStepsWhenComplete) {
  ResultWriter writer(folder_, sample_case());
  writer.begin_method("fem", "fem", "");
  for (const int step : {0, 2, 3, 1})
    writer.append_step("fem", 0, sample_point(step));

  writer.finish("complete");

  {
    const std::lock_guard lock(hdf5_mutex());
    const Hdf5File file(writer.path(), Hdf5File::Mode::read);
    EXPECT_EQ(file.open_path("methods/fem/0/curve").numbers("step"),
              (std::vector{0.0, 1.0, 2.0, 3.0}));
  }
  const Result result = read_result(folder_);
  for (const CurvePoint& point : result.methods[0].realizations[0].points)
    expect_same(point, sample_point(point.step));
}

TEST_F(ResultFile, RefusesWhatWouldNotReadBack) {
  ResultWriter writer(folder_, sample_case());
  writer.begin_method("fem", "fem", "");
  writer.append_step("fem", 0, sample_point(0));
  const Grid grid{4, 4, 1.0, 1.0};

  EXPECT_THROW(writer.append_step("fem", 0, sample_point(0)),
               std::domain_error); // there already
  EXPECT_THROW(writer.append_steps(
                   "fem", 0, std::vector{sample_point(1), sample_point(1)}),
               std::domain_error); // twice
  EXPECT_THROW(writer.append_step("md", 0, sample_point(1)),
               std::domain_error); // not begun
  EXPECT_THROW(writer.append_step("fem", -1, sample_point(1)),
               std::domain_error);
  EXPECT_THROW(writer.begin_method("a/b", "fem", ""), std::domain_error);
  EXPECT_THROW(writer.append_fields("fem", 0, grid, Fields{}),
               std::domain_error);
  EXPECT_THROW(writer.finish("running"), std::domain_error);
  EXPECT_EQ(steps_done(read_result(folder_)), (StepsDone{{{"fem", 0}, {0}}}));
}

// Four threads, each with its own curve, lose no row.
TEST_F(ResultFile, TakesStepsFromManyThreads) {
  const int n_threads = 4;
  const int n_steps = 25;
  ResultWriter writer(folder_, sample_case());
  writer.begin_method("fem", "fem", "");

  std::vector<std::thread> threads;
  for (int thread = 0; thread < n_threads; ++thread)
    threads.emplace_back([&writer, thread] {
      for (int step = 0; step < n_steps; ++step) {
        writer.append_step("fem", thread, sample_point(step));
        if (step % 10 == 0)
          read_result(writer.path());
      }
    });
  for (std::thread& thread : threads)
    thread.join();

  const Result result = read_result(folder_);
  ASSERT_EQ(result.methods[0].realizations.size(), 4U);
  for (const Curve& curve : result.methods[0].realizations) {
    ASSERT_EQ(curve.points.size(), 25U);
    for (int step = 0; step < n_steps; ++step)
      expect_same(curve.points[static_cast<std::size_t>(step)],
                  sample_point(step));
  }
}

using OwnSurface = ResultFolder;

Fields flat_fields(int step, const Grid& grid) {
  Fields fields;
  fields.step = step;
  fields.nominal_pressure = sample_point(step).nominal_pressure;
  fields.pressure.assign(grid.size(), 1.0);
  fields.gap.assign(grid.size(), -1.0);
  return fields;
}

TEST_F(OwnSurface, IsReadBackBesideTheCurveOfItsMethod) {
  ResultWriter writer(folder_, sample_case());
  const SurfaceRecord expected = sample_surface(3, 5);
  SurfaceRecord without_map = expected;
  without_map.heights.clear();
  writer.record_surface(0, sample_surface(4, 4));
  writer.begin_method("fem", "fem", "");
  writer.append_step("fem", 0, sample_point(0));
  writer.begin_method("md", "md", "");
  writer.record_own_surface("md", 0, sample_surface(8, 8));
  writer.record_own_surface("md", 0, expected); // in its place
  writer.record_own_surface("md", 1, without_map);
  writer.append_step("md", 0, sample_point(0));

  const Result result = read_result(folder_);

  EXPECT_FALSE(result.methods[0].realizations[0].own_surface.has_value());
  ASSERT_EQ(result.methods[1].realizations.size(), 2U);
  const Curve& curve = result.methods[1].realizations[0];
  ASSERT_TRUE(curve.own_surface.has_value());
  expect_same(*curve.own_surface, expected);
  EXPECT_EQ(curve.points.size(), 1U);
  expect_same(*result.methods[1].realizations[1].own_surface, without_map);
  EXPECT_EQ(result.surfaces[0].grid.points_x, 4);
}

TEST_F(OwnSurface, IsRefusedWithoutAMethodOrOfAnotherSize) {
  ResultWriter writer(folder_, sample_case());
  SurfaceRecord torn = sample_surface(4, 4);
  torn.heights.pop_back();

  EXPECT_THROW(writer.record_own_surface("md", 0, sample_surface(4, 4)),
               std::domain_error);
  writer.begin_method("md", "md", "");
  EXPECT_THROW(writer.record_own_surface("md", 0, torn), std::domain_error);
  EXPECT_THROW(writer.record_own_surface("md", -1, sample_surface(4, 4)),
               std::domain_error);
}

// A map has the grid on which it was written.
TEST_F(OwnSurface, HasMapsOfItsOwnGrid) {
  const Grid grid{6, 10, 3e-6, 4e-6};
  ResultWriter writer(folder_, sample_case());
  writer.record_surface(0, sample_surface(4, 4));
  writer.begin_method("md", "md", "");
  writer.append_step_with_fields("md", 0, sample_point(0), grid,
                                 flat_fields(0, grid));

  const Result result = read_result(folder_);

  EXPECT_EQ(result.methods[0].realizations[0].fields[0].grid, grid);
}

// A map without sides, as in files of earlier versions, has those of the
// method's own surface, or else of the case's.
TEST_F(OwnSurface, GivesItsSidesToAMapWithoutThem) {
  const Grid grid{2, 2, 1.0, 1.0};
  ResultWriter writer(folder_, sample_case());
  SurfaceRecord own = sample_surface(2, 2);
  own.grid.length_x = 7e-6;
  fill_numbers(own);
  writer.record_surface(0, sample_surface(4, 4));
  for (const char* method : {"fem", "md"}) {
    writer.begin_method(method, method, "");
    writer.append_step_with_fields(method, 0, sample_point(0), grid,
                                   flat_fields(0, grid));
  }
  writer.record_own_surface("md", 0, own);
  writer.finish("complete"); // all is in the file
  {
    const std::lock_guard lock(hdf5_mutex());
    Hdf5File file(writer.path(), Hdf5File::Mode::read_write);
    for (const std::string method : {"fem", "md"}) {
      Hdf5Group fields = file.open("methods/" + method + "/0/fields");
      fields.remove("0");
      Hdf5Group maps = fields.open_or_create("0");
      for (const char* map : {"pressure", "gap"})
        maps.write_map(map, std::vector(4, 1.0), {2, 2},
                       Hdf5Number::float32_packed, "1");
    }
    file.close();
  }

  const Result result = read_result(folder_);

  EXPECT_EQ(result.methods[0].realizations[0].fields[0].grid,
            (Grid{2, 2, 1e-6, 2e-6}));
  EXPECT_EQ(result.methods[1].realizations[0].fields[0].grid,
            (Grid{2, 2, 7e-6, 2e-6}));
}

} // namespace asperity::results::result_file_test
