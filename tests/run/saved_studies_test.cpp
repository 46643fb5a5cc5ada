// The studies of a saved result have the numbers that a run with them has.
#include "input/input_error.hpp"
#include "input/reader/read_case.hpp"
#include "results/result_reader.hpp"
#include "results/types/curve_columns.hpp"
#include "run/run_case.hpp"
#include "run/saved_studies.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace asperity::run::saved_studies_test {

constexpr const char* plain = R"(schema = 1
[surface]
kind = "self-affine"
length = "1 um"
points = 32
seed = 5
rms_slope = 0.1
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.5 length"
wavelength_short = "4 h"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = ["4 MPa", "10 MPa", "30 MPa"]
[theory]
gamma = 0.4
[halfspace]
[report]
fields = "all"
precision = "double"
)";

/// A map that continues by its mirror images: the cell is four times the map.
constexpr const char* mirrored = R"(schema = 1
[surface]
kind = "measured"
file = "map.txt"
level = "plane"
length = "1 um"
height_unit = "1 nm"
edges = "mirror"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = ["4 MPa", "30 MPa"]
[halfspace]
[report]
fields = "all"
precision = "double"
)";

const std::vector<std::string> asked{
    "flow={ viscosity = 1e-3, pressure_drop = 1e5 }", "spots.smallest=5",
    "conductance.thermal_conductivity=50",
    "conductance.counter_thermal_conductivity=16"};

void expect_same_answers(const results::Result& result,
                         const results::Result& expected) {
  for (std::size_t m = 0; m < expected.methods.size(); ++m) {
    const auto& rows = expected.methods[m].realizations.front().points;
    const auto& found = result.methods[m].realizations.front().points;
    ASSERT_EQ(found.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const results::CurveColumn& column : results::curve_columns()) {
        if (column.use != results::ColumnUse::answer)
          continue;
        const double own = column.get(rows[i]);
        EXPECT_TRUE(column.get(found[i]) == own ||
                    (std::isnan(own) && std::isnan(column.get(found[i]))))
            << column.name << " of " << expected.methods[m].name << ": "
            << column.get(found[i]) << " instead of " << own;
      }
  }
}

class SavedStudies : public tests::FolderTest {
protected:
  results::Result run(const std::vector<std::string>& keys, const char* out,
                      const char* text = plain) {
    const cases::Case read =
        cases::read_case_text(text, (folder / "case.toml").string(), keys);
    run_case(read, {folder / out, {}, false, 1});
    return results::read_result(folder / out);
  }

  static std::string refusal(results::Result& result,
                             const std::vector<std::string>& keys) {
    try {
      (void)ask_of_saved(result, keys);
      return "";
    } catch (const input::InputError& error) {
      return error.what();
    }
  }
};

TEST_F(SavedStudies, AreThoseOfARunWithThem) {
  const results::Result expected = run(asked, "with");
  results::Result result = run({}, "without");

  EXPECT_EQ(ask_of_saved(result, asked), 3);

  expect_same_answers(result, expected);
  ASSERT_NE(expected.table("flow-halfspace"), nullptr);
  ASSERT_NE(result.table("flow-halfspace"), nullptr);
  EXPECT_EQ(result.table("flow-halfspace")->values("flux"),
            expected.table("flow-halfspace")->values("flux"));
}

// Extensive numbers, as the stiffness, are those of the map and not of the
// cell.
TEST_F(SavedStudies, OfAMirroredMapAreThoseOfTheMap) {
  std::ofstream map(folder / "map.txt");
  for (int iy = 0; iy < 16; ++iy)
    for (int ix = 0; ix < 16; ++ix)
      map << 20.0 * std::sin(1.7 * ix + 0.3 * iy * iy)
          << (ix < 15 ? ' ' : '\n');
  map.close();
  const results::Result expected = run(asked, "with", mirrored);
  results::Result result = run({}, "without", mirrored);

  EXPECT_EQ(ask_of_saved(result, asked), 2);

  expect_same_answers(result, expected);
  EXPECT_GT(results::curve_column("normal_stiffness")
                .get(result.methods[0].realizations.front().points[0]),
            0.0);
}

TEST_F(SavedStudies, AreRefusedWhereTheResultCannotAnswer) {
  results::Result result = run({}, "without");

  EXPECT_NE(refusal(result, {"surface.seed=3"}).find("is no key of a study"),
            std::string::npos);
  EXPECT_NE(refusal(result, {"flow.viscosity=-3"}).find("flow.viscosity"),
            std::string::npos);
  results::Result has = run({"spots.smallest=5"}, "with");
  EXPECT_NE(refusal(has, {"spots.smallest=9"}).find("has the study [spots]"),
            std::string::npos);
  const std::string loads = refusal(
      result, {"friction.coefficient=0.3", "friction.tangential_load=[0.5]"});
  EXPECT_NE(loads.find("needs load steps"), std::string::npos) << loads;
  EXPECT_EQ(result.case_text.find("--set"), std::string::npos);
}

} // namespace asperity::run::saved_studies_test
