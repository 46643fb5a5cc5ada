// Tests of maps that are written by rows: equal bytes, whatever the pieces.
#include "base/read_file.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "results/storage/hdf5_file.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity::results::map_rows_test {

class MapRowsTest : public ResultFolder {
protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
};

std::vector<double> uneven_map(Hdf5Shape shape) {
  std::vector<double> map(shape.rows * shape.columns);
  for (std::size_t i = 0; i < map.size(); ++i)
    map[i] = std::sin(1e-3 * static_cast<double>(i * i % 10007));
  return map;
}

/// Passes a map on in pieces of `size` values.
MapRows in_pieces(const std::vector<double>& map, std::size_t size) {
  return [&map, size](const TakeValues& take) {
    for (std::size_t at = 0; at < map.size(); at += size)
      take(std::span(map).subspan(at, std::min(size, map.size() - at)));
  };
}

// The map is stored in five chunks of whole rows.
/// The change of a step of the method "md".
Change finished_step(const FieldsChange& fields) {
  return {.methods = {{.name = "md",
                       .realization = 0,
                       .fields = {fields},
                       .points = {sample_point(fields.step)}}}};
}

TEST_F(MapRowsTest, HaveTheBytesOfAWholeMap) {
  const Hdf5Shape shape{1500, 3000};
  const std::vector<double> map = uneven_map(shape);
  const auto bytes_of = [&](const auto& rows) {
    const std::filesystem::path path = folder_ / "map.h5";
    const std::lock_guard lock(hdf5_mutex());
    Hdf5File file(path, Hdf5File::Mode::create);
    file.write_map("packed", rows, shape, Hdf5Number::float32_packed, "Pa");
    file.write_map("plain", rows, shape, Hdf5Number::float64, "m");
    EXPECT_EQ(file.numbers("plain"), map);
    file.close();
    return read_file(path, std::size_t{1} << 30);
  };
  const std::string whole = bytes_of(std::span<const double>(map));
  for (const std::size_t size :
       std::vector<std::size_t>{3000, 21000, 1001, map.size()})
    EXPECT_TRUE(bytes_of(in_pieces(map, size)) == whole)
        << "pieces of " << size;
}

TEST_F(MapRowsTest, RefusesAnotherNumberOfValues) {
  const std::vector<double> map = uneven_map({4, 6});
  const std::lock_guard lock(hdf5_mutex());
  Hdf5File file(folder_ / "map.h5", Hdf5File::Mode::create);
  int number = 0;
  for (const Hdf5Shape shape :
       {Hdf5Shape{5, 6}, Hdf5Shape{3, 6}, Hdf5Shape{4, 5}})
    EXPECT_THROW(file.write_map(std::to_string(number++), in_pieces(map, 6),
                                shape, Hdf5Number::float64, "m"),
                 Hdf5Error);
}

// The fields and the row are those of a record with whole maps.
TEST_F(MapRowsTest, AreReadBackAsWholeMaps) {
  const Grid grid{8, 6, 1e-6, 1e-6};
  const std::vector<double> pressure = uneven_map({6, 8});
  std::vector<double> gap = pressure;
  std::ranges::reverse(gap);
  const double load = sample_point(4).nominal_pressure;
  for (const bool by_rows : {false, true}) {
    ResultWriter writer(folder_ / (by_rows ? "rows" : "whole"), sample_case());
    writer.begin_method("md", "md", "");
    if (by_rows) {
      const Change step = finished_step(
          {4, load, grid, {in_pieces(pressure, 8)}, {in_pieces(gap, 8)}});
      writer.append(step);
      EXPECT_THROW(writer.append(step), std::domain_error); // it exists
    } else {
      writer.append_step_with_fields("md", 0, sample_point(4), grid,
                                     Fields{4, load, pressure, gap});
    }
  }
  const Result whole = read_result(folder_ / "whole");
  const Result rows = read_result(folder_ / "rows");
  const Curve& found = rows.methods.at(0).realizations.at(0);
  const Curve& expected = whole.methods.at(0).realizations.at(0);
  ASSERT_EQ(found.fields.size(), 1U);
  EXPECT_EQ(found.fields[0].pressure, expected.fields.at(0).pressure);
  EXPECT_EQ(found.fields[0].gap, expected.fields[0].gap);
  EXPECT_EQ(found.fields[0].nominal_pressure, load);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_EQ(found.points[0].step, 4);
}

// An interruption while rows are passed on leaves the earlier result.
TEST_F(MapRowsTest, AreWrittenCompletelyOrNotAtAll) {
  const Grid grid{8, 6, 1e-6, 1e-6};
  const std::vector<double> map = uneven_map({6, 8});
  ResultWriter writer(folder_, sample_case());
  writer.begin_method("md", "md", "");
  const MapRows broken = [&](const TakeValues& take) {
    take(std::span(map).first(8));
    throw std::runtime_error("no more rows");
  };
  EXPECT_THROW(writer.append(finished_step(
                   {1, 2.0, grid, {in_pieces(map, 8)}, {broken}})),
               std::runtime_error);
  const std::vector<double> fewer(map.begin(), map.end() - 8);
  const MapRows too_few = in_pieces(fewer, 8);
  EXPECT_THROW(writer.append(finished_step(
                   {1, 2.0, grid, {in_pieces(map, 8)}, {too_few}})),
               std::domain_error);
  EXPECT_TRUE(read_result(folder_).methods.at(0).realizations.empty());
  EXPECT_FALSE(writer.has_step("md", 0, 1));
}

} // namespace asperity::results::map_rows_test
