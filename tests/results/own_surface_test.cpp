// Tests of a method with another surface or grid than the case's: both are read
// back from the file, and what a file omits of a map's grid is taken from its
// surface.
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "results/storage/hdf5_file.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "tests/results/sample_result.hpp"

namespace asperity::results::own_surface_test {

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

} // namespace asperity::results::own_surface_test
