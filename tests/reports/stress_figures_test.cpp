// Tests of the figures of the stress below the surface: a full 3-D block shows
// its own numbers beside those from its pressure, other methods the latter.
#include "reports/pages/report.hpp"
#include "tests/reports/drawn.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "synthetic.hpp"

namespace asperity::reports::stress_figures_test {

class StressFigures : public ::testing::Test {
protected:
  StressFigures() {
    const double modulus = synthetic::contact_modulus;
    result.methods = {{"fem", "fem", "a full block", {}},
                      {"halfspace", "halfspace", "a half-space", {}}};
    result.tables = {table("stress-inside-fem",
                           {{"nominal_pressure", {0.01 * modulus}},
                            {"von_mises", {0.5 * modulus}},
                            {"depth", {2e-6}},
                            {"von_mises_from_pressure", {0.4 * modulus}},
                            {"depth_from_pressure", {3e-6}}}),
                     table("stress-inside-halfspace",
                           {{"nominal_pressure", {0.01 * modulus}},
                            {"von_mises", {0.375 * modulus}},
                            {"largest_shear", {0.1875 * modulus}},
                            {"depth", {4e-6}}}),
                     table("stress-section-fem",
                           {{"depth", {0.0, 0.0, 1e-6, 1e-6}},
                            {"x", {-1e-6, 1e-6, -1e-6, 1e-6}},
                            {"von_mises",
                             {std::numeric_limits<double>::quiet_NaN(),
                              0.25 * modulus, 0.125 * modulus, 0.0}}})};
  }

  static results::Table
  table(const std::string& name,
        const std::vector<std::pair<std::string, std::vector<double>>>& of) {
    results::Table made{name, "A section of fem, from its cells", {}};
    for (const auto& [column, values] : of)
      made.columns.push_back({column, "1", values});
    return made;
  }

  std::vector<Figure> shown() const {
    return drawn(figures::stress, entry_of(result, rough));
  }

  cases::Case rough = synthetic::contact_case();
  results::Result result = synthetic::rough_result(rough, 1);
};

TEST_F(StressFigures, ShowTheBlocksOwnAndWhatItsPressureGives) {
  const Figure strength = shown().front();

  EXPECT_NE(strength.data.find("\"fem\",0,0.01,0.5,2,"), std::string::npos)
      << strength.data;
  EXPECT_NE(strength.data.find("\"fem, from its pressure\",1,0.01,0.4,3,"),
            std::string::npos)
      << strength.data;
  EXPECT_NE(strength.data.find("\"halfspace\",2,0.01,0.375,4,0.5\n"),
            std::string::npos)
      << strength.data;
  EXPECT_NE(strength.caption.find("full 3-D model"), std::string::npos);
}

TEST_F(StressFigures, DoNotMentionAbsentFullBlocks) {
  result.tables[0].columns.resize(3);

  const Figure strength = shown().front();

  EXPECT_EQ(strength.data.find("from its pressure"), std::string::npos);
  EXPECT_EQ(strength.caption.find("full 3-D model"), std::string::npos);
}

// In the browser the section has a map per load, its lowest row first; without
// a table of loads, it has that of the section.
TEST_F(StressFigures, HaveASectionPerLoad) {
  const double modulus = synthetic::contact_modulus;
  ASSERT_TRUE(shown()[1].stack);
  EXPECT_EQ(shown()[1].stack->frames.size(), 1U);
  result.tables.push_back(
      table("stress-sections-fem",
            {{"nominal_pressure", std::vector<double>(4, 0.01 * modulus)},
             {"depth", {0.0, 0.0, 1e-6, 1e-6}},
             {"x", {-1e-6, 1e-6, -1e-6, 1e-6}},
             {"von_mises", {0.0, 0.0, modulus, 0.0}}}));
  for (results::Column& column : result.tables.back().columns)
    for (int i = 0; i < 4; ++i)
      column.values.push_back(column.name == "nominal_pressure"
                                  ? 2.0 * column.values[0]
                              : column.name == "von_mises"
                                  ? 2.0 * modulus
                                  : column.values[static_cast<std::size_t>(i)]);

  const MapStack stack = shown()[1].stack.value();

  ASSERT_EQ(stack.frames.size(), 2U);
  EXPECT_EQ(stack.frames[0].title, "p / E* = 0.01");
  EXPECT_EQ(stack.frames[1].title, "p / E* = 0.02");
  EXPECT_EQ(stack.columns, 2);
  EXPECT_EQ(stack.rows, 2);
  EXPECT_DOUBLE_EQ(stack.lower, 1.5); // the edge of the lowest cells
  EXPECT_DOUBLE_EQ(stack.upper, -0.5);
  EXPECT_EQ(stack.frames[0].maps[0].data,
            packed_map({1.0, 0.0, 0.0, 0.0}, 2).data);
  EXPECT_EQ(stack.frames[1].maps[0].low, 2.0);
}

// A point without stress is not the maximum, and the section states the origin
// of its numbers.
TEST_F(StressFigures, LeaveOutPlacesWithoutStress) {
  const std::vector<Figure> all = shown();

  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].name, "stress-section-fem");
  EXPECT_NE(all[1].caption.find("at most 0.25 E*, at a depth of 0 "),
            std::string::npos)
      << all[1].caption;
  EXPECT_NE(all[1].caption.find("from its cells"), std::string::npos);
  EXPECT_EQ(all[1].panels[0].image.value().high, 0.25);
}

// A section with negative depths is one of two bodies, and is shown as a whole.
TEST_F(StressFigures, ShowBothBodies) {
  for (results::Table& made : result.tables)
    if (made.name == "stress-section-fem")
      made.columns.front().values = {-1e-6, -1e-6, 0.0, 0.0};

  const Figure section = shown()[1];

  EXPECT_EQ(section.title, "Section through both bodies, fem");
  EXPECT_NE(section.caption.find("in the second body"), std::string::npos);
  EXPECT_EQ(section.panels[0].y.low, 0.0); // the deeper end
  EXPECT_EQ(section.panels[0].y.high, -1.0);
}

} // namespace asperity::reports::stress_figures_test
