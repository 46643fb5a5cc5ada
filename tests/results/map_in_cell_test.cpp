// Tests of results/types/map_in_cell.hpp and of what follows from it: maps,
// extensive numbers and clusters of the user's map in a cell of its mirror
// images, and their way through the file.
#include "input/input_error.hpp"
#include "results/observables/clusters.hpp"
#include "results/result_reader.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/types/curve_columns.hpp"
#include "results/types/map_in_cell.hpp"
#include "tests/message_of.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace asperity::results::map_in_cell_test {

constexpr Grid map_grid{6, 4, 3e-6, 4e-6};
constexpr Grid cell{12, 8, 6e-6, 8e-6};
constexpr MapInCell quarter{6, 4};

/// A map with its mirror images to the right and below.
template <class Value>
std::vector<Value> mirrored(const Grid& grid, const std::vector<Value>& map) {
  std::vector<Value> all;
  for (int iy = 0; iy < 2 * grid.points_y; ++iy)
    for (int ix = 0; ix < 2 * grid.points_x; ++ix)
      all.push_back(map[grid.index(std::min(ix, 2 * grid.points_x - 1 - ix),
                                   std::min(iy, 2 * grid.points_y - 1 - iy))]);
  return all;
}

TEST(MapInCell, IsItsFirstColumnsAndRows) {
  std::vector<double> map(map_grid.size());
  for (std::size_t i = 0; i < map.size(); ++i)
    map[i] = static_cast<double>(i);
  const std::vector<double> all = mirrored(map_grid, map);

  EXPECT_EQ(quarter.grid(cell), map_grid);
  EXPECT_EQ(quarter.share(cell), 0.25);
  EXPECT_EQ(MapView(quarter.of(all, cell)).whole(), map);
  for (std::size_t node = 0; node < all.size(); ++node)
    EXPECT_EQ(map[quarter.node_on_map(node, cell) % 12 +
                  quarter.node_on_map(node, cell) / 12 * 6],
              all[node]);
}

TEST(MapInCell, IsTheCellWithoutImages) {
  const std::vector<double> all(cell.size(), 1.0);

  EXPECT_EQ(MapInCell{}.grid(cell), cell);
  EXPECT_EQ(MapInCell{}.share(cell), 1.0);
  EXPECT_EQ(MapView(MapInCell{}.of(all, cell)).whole(), all);
  EXPECT_EQ(MapInCell{}.node_on_map(77, cell), 77U);
}

// Atoms have a grid of their own on the same cell.
TEST(MapInCell, IsFoundOnAnotherGrid) {
  EXPECT_EQ(quarter.on(cell, {18, 9, 6e-6, 8e-6}), (MapInCell{9, 5}));
  EXPECT_TRUE(MapInCell{}.on(cell, {18, 9, 6e-6, 8e-6}).is_whole(cell));
}

// A number in proportion to the area is that of a quarter of the area, and
// nothing else changes.
TEST(MapInCell, ChangesExtensiveNumbersOnly) {
  const CurvePoint whole = sample_point(3);
  CurvePoint row = whole;

  state_of_map(row, quarter.share(cell));

  for (const CurveColumn& column : curve_columns())
    if (const double number = column.get(whole); !std::isnan(number)) {
      const bool is_stiffness = column.unit == "N/m";
      EXPECT_EQ(column.get(row), is_stiffness ? number / 4.0 : number)
          << column.name;
    }
}

// A new column with an extensive unit must say what it is about.
TEST(MapInCell, IsKnownForEveryColumnWithAnExtensiveUnit) {
  const std::set<std::string_view> on_map{"spot_count", "largest_spot",
                                          "gap_count", "largest_gap"};
  const std::set<std::string_view> of_seal_or_square{
      "flow_conductance_x", "flow_conductance_y", "leak_rate_x", "leak_rate_y",
      "effective_medium"};
  const std::set<std::string_view> units{"N", "N/m", "m^2", "m^3", "m^3/s",
                                         "J", "W",   "W/K", "N m", "kg"};
  for (const CurveColumn& column : curve_columns())
    if (units.contains(column.unit) || column.name.ends_with("_count")) {
      EXPECT_TRUE(column.extent == Extent::extensive ||
                  on_map.contains(column.name) ||
                  of_seal_or_square.contains(column.name))
          << column.name;
    }
}

// Mirror images join nothing that is not joined on the map.
RC_GTEST_PROP(MapInCell, HasTheClustersOfTheMapAlone, ()) {
  const Grid grid{*rc::gen::inRange(2, 9), *rc::gen::inRange(2, 9), 1.0, 2.0};
  const auto map = *rc::gen::container<std::vector<std::uint8_t>>(
      grid.size(), rc::gen::inRange<std::uint8_t>(0, 2));
  const Grid all{2 * grid.points_x, 2 * grid.points_y, 2.0, 4.0};

  const ClusterNumbers alone =
      cluster_numbers(find_clusters(grid, map, Border::free), 1);
  const ClusterNumbers found =
      cluster_numbers(find_clusters(all, mirrored(grid, map), Border::periodic,
                                    {grid.points_x, grid.points_y}),
                      1);

  RC_ASSERT(found.count == alone.count);
  RC_ASSERT(std::abs(found.largest - alone.largest) <= 1e-12);
  RC_ASSERT(found.percolates_x == alone.percolates_x);
  RC_ASSERT(found.percolates_y == alone.percolates_y);
}

class MapInCellFile : public ResultFolder {
protected:
  void write(ResultWriter& writer) const {
    SurfaceRecord surface = sample_surface(12, 8);
    surface.map = quarter;
    writer.record_surface(0, surface);
    writer.begin_method("fem", "fem", "");
    Fields fields;
    fields.step = 1;
    fields.nominal_pressure = sample_point(1).nominal_pressure;
    fields.pressure.assign(96, fields.nominal_pressure);
    fields.gap.assign(96, 1e-9);
    fields.map = quarter;
    writer.append_step_with_fields("fem", 0, sample_point(1), surface.grid,
                                   fields);
  }

  Result read() const { return read_result(folder_); }
};

void expect_quarter(const Result& result) {
  EXPECT_EQ(result.surfaces.at(0).map, quarter);
  EXPECT_EQ(result.surfaces[0].map_grid().points_x, 6);
  const Fields& fields = result.methods.at(0).realizations.at(0).fields.at(0);
  EXPECT_EQ(fields.map, quarter);
  EXPECT_EQ(fields.on_map().pressure_map().size(), 24U);
}

// In the journal and in the file.
TEST_F(MapInCellFile, IsSaved) {
  {
    ResultWriter writer(folder_, sample_case(), ResultWriter::Mode::create);
    write(writer);
    expect_quarter(read());
    writer.finish("complete");
  }
  expect_quarter(read());

  const std::lock_guard lock(hdf5_mutex());
  const Hdf5File file(folder_ / "result.h5", Hdf5File::Mode::read);
  for (const char* place : {"surfaces/0", "methods/fem/0/fields/1"}) {
    EXPECT_EQ(file.open_path(place).number_attribute("map_points_x"), 6.0);
    EXPECT_EQ(file.open_path(place).number_attribute("map_points_y"), 4.0);
  }
}

TEST_F(MapInCellFile, IsRefusedBeyondItsMaps) {
  {
    ResultWriter writer(folder_, sample_case(), ResultWriter::Mode::create);
    write(writer);
    writer.finish("complete");
  }
  for (const double points : {13.0, 0.0, 5.5}) {
    {
      const std::lock_guard lock(hdf5_mutex());
      Hdf5File file(folder_ / "result.h5", Hdf5File::Mode::read_write);
      file.open("surfaces").open("0").set_attribute("map_points_x", points);
    }
    EXPECT_NE(tests::message_of<input::InputError>([&] {
                (void)read();
              }).find("must be an integer between 1 and 12"),
              std::string::npos)
        << points;
  }
}

} // namespace asperity::results::map_in_cell_test
