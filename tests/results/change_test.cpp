// Tests of the record of a change, which is that of the journal and an entry of
// the cache.
#include "input/input_error.hpp"
#include "results/storage/change.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

namespace asperity::results::change_test {

class ChangeRecord : public ResultFolder {
protected:
  void SetUp() override {
    ResultFolder::SetUp();
    std::filesystem::create_directories(folder_);
  }

  FileBytes in_file(const std::string& bytes) const {
    std::ofstream(folder_ / "record", std::ios::binary) << bytes;
    return FileBytes::of(folder_ / "record").value();
  }
};

const Grid grid{3, 2, 1e-6, 5e-7};
const std::vector<double> pressure{1e6, 2e6, 3e6, 0.1, 0.0, 4e6};
const std::vector<double> gap{0.0, 1e-9, 2e-9, 1e-10, 5e-9, 6e-9};
const std::vector<double> heights{1e-9 / 3.0, 2e-9, -1e-9, 4e-9, -3e-9, 0.0};

/// A finished step with all that it may have.
Change finished_step() {
  SurfaceRecord surface;
  surface.grid = grid;
  surface.spectrum = {{1e6, 2e-20}};
  surface.rms_slope = 0.25;
  return {.methods = {{.name = "fem.hard",
                       .realization = 1,
                       .description = "found",
                       .setup_cpu_time = 0.75,
                       .own_surface = {{surface, {rows_of_map(heights)}}},
                       .fields = {{2,
                                   1e5,
                                   grid,
                                   {rows_of_map(pressure)},
                                   {rows_of_map(gap)}}},
                       .points = {sample_point(2)}}},
          .tables = {{"section", "A title", {{"depth", "m", {1.0, 2.5}}}}}};
}

std::string bytes_of(const Change& change) {
  const Record record = record_of(change);
  std::string bytes;
  record.bytes([&](std::string_view piece) { bytes += piece; });
  EXPECT_EQ(bytes.size(), record.size);
  return bytes;
}

std::vector<double> values_of(const ChangeMap& map) {
  std::vector<double> all;
  map.rows([&](std::span<const double> values) {
    all.insert(all.end(), values.begin(), values.end());
  });
  EXPECT_EQ(map.stored.read(0, map.stored.rows), all);
  return all;
}

std::vector<double> in_single_precision(const std::vector<double>& map) {
  const std::vector<float> single(map.begin(), map.end());
  return {single.begin(), single.end()};
}

TEST_F(ChangeRecord, HasBothMapsInTheSamePrecision) {
  Change step = finished_step();
  step.methods.at(0).fields.at(0).has_double_maps = true;
  const Change found = change_in(in_file(bytes_of(step)));

  const FieldsChange& fields = found.methods.at(0).fields.at(0);
  EXPECT_EQ(values_of(fields.pressure), pressure);
  EXPECT_EQ(values_of(fields.gap), gap);
}

TEST_F(ChangeRecord, IsReadBack) {
  const FileBytes record = in_file(bytes_of(finished_step()));

  const Change found = change_in(record);
  std::filesystem::remove(folder_ / "record"); // the maps remain readable

  const MethodChange& method = found.methods.at(0);
  EXPECT_EQ(method.name, "fem.hard");
  EXPECT_EQ(method.realization, 1);
  EXPECT_FALSE(method.kind);
  EXPECT_EQ(method.description, "found");
  EXPECT_EQ(method.setup_cpu_time, 0.75);
  EXPECT_EQ(method.own_surface->record.rms_slope, 0.25);
  EXPECT_EQ(values_of(method.own_surface->heights), heights);
  expect_same(method.points.at(0), sample_point(2));
  const FieldsChange& fields = method.fields.at(0);
  EXPECT_EQ(fields.step, 2);
  EXPECT_EQ(fields.nominal_pressure, 1e5);
  EXPECT_EQ(fields.grid, grid);
  EXPECT_EQ(values_of(fields.pressure), in_single_precision(pressure));
  EXPECT_EQ(values_of(fields.gap), in_single_precision(gap));
  EXPECT_EQ(found.tables.at(0).title, "A title");
  EXPECT_EQ(found.tables[0].values("depth"), (std::vector{1.0, 2.5}));
  EXPECT_EQ(bytes_of(found), bytes_of(finished_step()));
}

// A record that lacks any number of bytes at its end, or has more, is refused.
TEST_F(ChangeRecord, OfAnotherLengthIsRefused) {
  const std::string bytes = bytes_of(finished_step());
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(change_in(in_file(bytes.substr(0, length))), input::InputError)
        << length;
  EXPECT_THROW(change_in(in_file(bytes + '\0')), input::InputError);
}

// The number of bytes is known without a look at the maps.
TEST_F(ChangeRecord, IsCountedWithoutItsMaps) {
  Change change = finished_step();
  const std::size_t size = bytes_of(change).size();
  change.methods[0].fields[0].gap.rows = [](const TakeValues&) {
    throw std::runtime_error("no map was to be read");
  };

  EXPECT_EQ(record_of(change).size, size);
}

} // namespace asperity::results::change_test
