// A column is told once: one defined here is written, read, compared and shown
// without a word about it elsewhere.
#include "results/csv.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "results/types/curve_columns.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace asperity::results::columns_test {

const CurveColumn softness{"test of columns",
                           {.name = "softness",
                            .unit = "m/Pa",
                            .text = "how soft the contact is",
                            .extent = Extent::extensive}};

const CurveColumn visits{
    "test of columns",
    {.name = "visits", .unit = "1", .text = "a count", .is_integer = true}};

const DirectedColumn slide{
    "test of columns",
    {.name = "slide", .unit = "m", .text = "how far it slides along x"}};

TEST(Columns, OfBothDirectionsAreTwo) {
  CurvePoint row;
  row[slide.x] = 1.0;
  row[slide.along(true)] = 2.0;

  EXPECT_EQ(curve_column("slide_x").get(row), 1.0);
  EXPECT_EQ(curve_column("slide_y").get(row), 2.0);
  EXPECT_EQ(&slide.along(false), &slide.x);
  EXPECT_NE(columns_markdown().find(
                "how far it slides along x |\n"
                "| `slide_y` [m] | test of columns | likewise along y |"),
            std::string::npos);
}

TEST(Columns, HaveOneName) {
  EXPECT_THROW(CurveColumn("another", {.name = "softness", .unit = "1"}),
               std::logic_error);
  EXPECT_EQ(&curve_column("softness"), &softness);
  EXPECT_EQ(find_curve_column("hardness of a name"), nullptr);
}

TEST(Columns, AreNaNOrNoneWhereARowHasNoNumber) {
  CurvePoint row;
  const CurvePoint& read = row;

  EXPECT_TRUE(std::isnan(read[softness]));
  EXPECT_EQ(read[visits], 0.0);
  row[softness] = 2.0;
  EXPECT_EQ(read[softness], 2.0);
  state_of_map(row, 0.25);
  EXPECT_EQ(read[softness], 0.5);
  softness.set(row, not_given);
  EXPECT_TRUE(row.others().empty());
  row[columns::mean_gap] = 3.0;
  EXPECT_EQ(row.mean_gap, 3.0);
  EXPECT_THROW(row[columns::iterations], std::domain_error);
}

/// The only column of a result that a test of this file writes.
class ColumnsFile : public ResultFolder {
protected:
  Result written(double number) const {
    CurvePoint row = sample_point(0);
    row[softness] = number;
    row[visits] = 3.0;
    ResultWriter writer(folder_, sample_case());
    writer.begin_method("fem", "fem", "");
    writer.append_step("fem", 0, row);
    writer.finish("complete");
    return read_result(folder_);
  }
};

TEST_F(ColumnsFile, AreWrittenAndReadAndChecked) {
  const Result result = written(4.0);
  const CurvePoint& row = result.methods.at(0).realizations.at(0).points.at(0);

  EXPECT_EQ(row[softness], 4.0);
  EXPECT_EQ(row[visits], 3.0);
  EXPECT_NE(curves_csv(result).find("softness [m/Pa]"), std::string::npos);
  EXPECT_NE(columns_markdown().find(
                "| `softness` [m/Pa] | test of columns | how soft"),
            std::string::npos);
}

TEST_F(ColumnsFile, AreRefusedOutsideTheirRange) {
  try {
    (void)written(-4.0);
    FAIL() << "a negative softness was read";
  } catch (const input::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("curve/softness, step 0 = -4"),
              std::string::npos)
        << error.what();
  }
}

} // namespace asperity::results::columns_test
