// Tests of results/csv.hpp: the exact bytes, and numbers that are read back.
#include "results/csv.hpp"
#include "results/types/method_columns.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>

namespace asperity::results::csv_test {

const std::string header_of_all =
    "method,realization,step,nominal_pressure [Pa],mean_gap [m],"
    "area_fraction [1],area_fraction_corrected [1],contact_perimeter [1/m],"
    "elastic_energy [J/m^2],contact_energy [J/m^2],contact_stiffness [Pa/m],"
    "iterations,residual,is_unloading";

TEST(CurvesCsv, IsThisTable) {
  CurvePoint loaded;
  loaded.step = 3;
  loaded.nominal_pressure = 2.5e6;
  loaded.mean_gap = -1e-9;
  loaded.area_fraction = 0.1;
  loaded.area_fraction_corrected = 0.09;
  loaded[columns::area_fraction_fit] = 0.08;
  loaded[columns::area_fraction_moment] = 0.07;
  loaded.contact_perimeter = 5e5;
  loaded.elastic_energy = 1.5e-3;
  loaded.contact_stiffness = 1e15;
  loaded.iterations = 17;
  loaded.residual = 2e-9;
  loaded[columns::certified_gap_error] = 3e-12;
  loaded[columns::estimated_gap_error] = 4e-12;
  loaded.cpu_time = 0.25;
  loaded.status = StepStatus::not_converged;
  CurvePoint theory;
  theory.nominal_pressure = 1.0;
  theory.contact_perimeter = std::numeric_limits<double>::quiet_NaN();
  Result result;
  result.methods = {
      {"theory", "theory", "", {Curve{{theory}, {}, 0.0}}},
      {"fem, \"thin\"", "fem", "", {Curve{}, Curve{{loaded}, {}, 0.0}}}};

  const std::string expected =
      header_of_all +
      ",certified_gap_error [m],estimated_gap_error [m],area_fraction_fit [1],"
      "area_fraction_moment [1],status\r\n"
      "theory,0,0,1,0,0,0,nan,0,0,0,0,0,0,nan,nan,nan,nan,converged\r\n"
      "\"fem, \"\"thin\"\"\",1,3,2500000,-1e-09,0.1,0.09,500000,0.0015,0,"
      "1000000000000000,17,2e-09,0,3e-12,4e-12,0.08,0.07,not_converged\r\n";

  EXPECT_EQ(curves_csv(result), expected);
}

// The columns of a block that flows come before the status.
TEST(CurvesCsv, HasPlasticFlowWhereThereIsAny) {
  CurvePoint flowing;
  flowing[columns::plastic_work] = 0.5;
  flowing[columns::plastic_strain] = 0.25;
  Result result;
  result.methods = {{"theory", "theory", "", {Curve{{CurvePoint{}}, {}, 0.0}}},
                    {"fem", "fem", "", {Curve{{flowing}, {}, 0.0}}}};

  const std::string text = curves_csv(result);

  EXPECT_TRUE(text.starts_with(
      header_of_all + ",plastic_strain [1],plastic_work [J/m^2],status\r\n"))
      << text;
  EXPECT_NE(text.find(",nan,nan,converged\r\nfem,"), std::string::npos) << text;
  EXPECT_NE(text.find(",0.25,0.5,converged\r\n"), std::string::npos) << text;
}

// Two results that differ in their times only have the same curves.csv, and
// times.csv has the times.
TEST(CurvesCsv, HasNoTimeWhichTimesCsvHas) {
  CurvePoint point;
  point.step = 2;
  point.cpu_time = 0.25;
  point[columns::transform_time] = 0.125;
  Result first;
  first.methods = {{"fem", "fem", "", {Curve{{point}, {}, 1.5}}}};
  Result second = first;
  second.methods[0].realizations[0].setup_cpu_time = 2.5;
  CurvePoint& slower = second.methods[0].realizations[0].points[0];
  slower.cpu_time = 0.5;
  slower[columns::transform_time] = 0.25;
  slower[columns::observation_time] = 0.75;

  EXPECT_EQ(curves_csv(first), curves_csv(second));
  EXPECT_EQ(times_csv(first),
            "method,realization,step,cpu_time [s],transform_time [s],"
            "observation_time [s]\r\n"
            "fem,0,,1.5,nan,nan\r\n"
            "fem,0,2,0.25,0.125,nan\r\n");
}

// Every double of a row is read back unchanged, also where it needs all 17
// digits or lies at the end of its range. The reader is independent: it splits
// at ','.
TEST_F(ResultFolder, CsvReadsBackEveryDouble) {
  CurvePoint point;
  point.nominal_pressure = 1e6 / 3.0;
  point.mean_gap = -std::numbers::pi * 1e-9;
  point.area_fraction = std::nextafter(0.1, 1.0);
  point.area_fraction_corrected = std::numeric_limits<double>::denorm_min();
  point[columns::area_fraction_fit] = 2.0 / 3.0;
  point[columns::area_fraction_moment] = std::nextafter(0.3, 0.0);
  point.contact_perimeter = std::numeric_limits<double>::max();
  point.elastic_energy = 5e-324 * 7;
  point.contact_stiffness = 123456789012345678.0;
  point.residual = 1.0 / 7.0;
  Result result;
  result.methods = {{"fem", "fem", "", {Curve{{point}, {}, 0.0}}}};

  std::istringstream file(curves_csv(result));
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, header_of_all + ",area_fraction_fit [1],"
                                  "area_fraction_moment [1],status\r");
  std::getline(file, line);
  std::istringstream row(line);
  std::vector<double> numbers;
  for (std::string field; std::getline(row, field, ',');)
    numbers.push_back(std::strtod(field.c_str(), nullptr));
  ASSERT_EQ(numbers.size(), 17U);
  EXPECT_EQ(numbers[3], point.nominal_pressure);
  EXPECT_EQ(numbers[4], point.mean_gap);
  EXPECT_EQ(numbers[5], point.area_fraction);
  EXPECT_EQ(numbers[6], point.area_fraction_corrected);
  EXPECT_EQ(numbers[7], point.contact_perimeter);
  EXPECT_EQ(numbers[8], point.elastic_energy);
  EXPECT_EQ(numbers[10], point.contact_stiffness);
  EXPECT_EQ(numbers[12], point.residual);
  EXPECT_EQ(numbers[14], point[columns::area_fraction_fit]);
  EXPECT_EQ(numbers[15], point[columns::area_fraction_moment]);
}

} // namespace asperity::results::csv_test
