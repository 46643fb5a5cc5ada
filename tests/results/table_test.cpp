// Tests of the tables of a result file: what is written is read back, a table
// is replaced as a unit, and an invalid one changes nothing.
#include "base/special_numbers.hpp"
#include "input/input_error.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "results/storage/hdf5_file.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::results::table_test {

using ResultTable = ResultFolder;

/// Columns in neither alphabetical nor numerical order.
Table sample_table() {
  return {"magnification-1",
          "p = 10 MPa, \u00fc",
          {{"magnification", "1", {1.0, 2.0, 0.1 + 0.2}},
           {"a_gap", "m", {infinity, 3e-9, std::nan("")}},
           {"density", "1/m", {-0.0, 1e300, 1e-300}}}};
}

void expect_same(const Table& a, const Table& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.title, b.title);
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t c = 0; c < a.columns.size(); ++c) {
    EXPECT_EQ(a.columns[c].name, b.columns[c].name);
    EXPECT_EQ(a.columns[c].unit, b.columns[c].unit);
    ASSERT_EQ(a.columns[c].values.size(), b.columns[c].values.size());
    for (std::size_t i = 0; i < a.columns[c].values.size(); ++i)
      EXPECT_PRED2(is_same, a.columns[c].values[i], b.columns[c].values[i]);
  }
}

TEST_F(ResultTable, IsReadBackBitForBitInItsOrder) {
  ResultWriter writer(folder_, sample_case());
  Table second = sample_table();
  second.name = "adhesion";
  writer.record_table(sample_table());
  writer.record_table(second);

  const Result result = read_result(folder_);

  ASSERT_EQ(result.tables.size(), 2U);
  expect_same(result.tables[0], sample_table());
  expect_same(result.tables[1], second);
  EXPECT_EQ(result.table("adhesion"), &result.tables[1]);
  EXPECT_EQ(result.table("leak"), nullptr);
  EXPECT_EQ(result.tables[0].values("density"),
            sample_table().columns[2].values);
  EXPECT_TRUE(result.tables[0].values("gap").empty());
}

TEST_F(ResultTable, IsReplacedAsAUnit) {
  ResultWriter writer(folder_, sample_case());
  writer.record_table(sample_table());
  const Table other{"magnification-1", "", {{"gap", "m", {1.0}}}};

  writer.record_table(other);

  const Result result = read_result(folder_);
  ASSERT_EQ(result.tables.size(), 1U);
  expect_same(result.tables[0], other);
}

TEST_F(ResultTable, IsKnownToAResumedRun) {
  { ResultWriter(folder_, sample_case()).record_table(sample_table()); }

  const ResultWriter second(folder_, sample_case(), ResultWriter::Mode::resume);

  EXPECT_TRUE(second.has_table("magnification-1"));
  EXPECT_FALSE(second.has_table("magnification-2"));
}

TEST_F(ResultTable, IsMissingInAFileOfAnEarlierProgram) {
  const ResultWriter writer(folder_, sample_case());
  {
    const std::lock_guard lock(hdf5_mutex());
    EXPECT_FALSE(Hdf5File(writer.path(), Hdf5File::Mode::read).has("tables"));
  }

  EXPECT_TRUE(read_result(folder_).tables.empty());
}

// Columns of another program without a stated order are read in the order of
// the file, and otherwise in the stated one; those of different lengths are
// refused by name.
TEST_F(ResultTable, OfAnotherProgramIsReadOrRefused) {
  const ResultWriter writer(folder_, sample_case());
  const auto append = [&](const std::string& name, std::vector<double> values) {
    const std::lock_guard lock(hdf5_mutex());
    Hdf5File file(writer.path(), Hdf5File::Mode::read_write);
    Hdf5Group table = file.open_or_create("tables").open_or_create("leak");
    table.append(name, values, Hdf5Number::float64, "m");
    file.close();
  };
  append("b", {1.0, 2.0});
  append("a", {3.0, 4.0});
  EXPECT_EQ(read_result(folder_).tables.at(0).columns.at(1).name, "a");
  {
    const std::lock_guard lock(hdf5_mutex());
    Hdf5File file(writer.path(), Hdf5File::Mode::read_write);
    Hdf5Group table = file.open("tables/leak");
    table.open_dataset("b").set_attribute("order", 1);
    table.open_dataset("a").set_attribute("order", 0);
    file.close();
  }
  EXPECT_EQ(read_result(folder_).tables.at(0).columns.at(0).name, "a");
  append("c", {5.0});

  try {
    (void)read_result(folder_);
    FAIL() << "columns of two lengths were read";
  } catch (const input::InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("/tables/leak/c has 1 values, but must have 2, as a"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(ResultTable, IsRefusedWithABadNameOrLength) {
  ResultWriter writer(folder_, sample_case());
  std::vector<Table> bad(4, sample_table());
  bad[0].name = "a/b";
  bad[1].columns[1].name = "";
  bad[2].columns[2].name = "a_gap";
  bad[3].columns[2].values.pop_back();

  for (const Table& table : bad)
    EXPECT_THROW(writer.record_table(table), std::domain_error);

  EXPECT_TRUE(read_result(folder_).tables.empty());
}

} // namespace asperity::results::table_test
