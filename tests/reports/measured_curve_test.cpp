// Tests of reports/analysis/measured_curve.hpp and of the names of several
// results: a user's own curve, in the user's units, stands beside a result with
// its deviations, and results of one case have names that differ.
#include "base/shown_number.hpp"
#include "input/units.hpp"
#include "reports/analysis/measured_curve.hpp"
#include "reports/analysis/summary.hpp"
#include "reports/analysis/surface_theory.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/pages/agreement.hpp"
#include "reports/pages/answers.hpp"
#include "reports/pages/entry_names.hpp"
#include "reports/pages/html_report.hpp"
#include "results/types/method_columns.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::measured_curve_test {

class MeasuredCurve : public ReportFolder {
protected:
  MeasuredCurve() { std::filesystem::create_directories(folder); }

  results::Result read(const std::string& text) const {
    std::ofstream(folder / "mine.csv") << text;
    return read_measured_curve(folder / "mine.csv", result);
  }

  std::string mistake(const std::string& text) const {
    try {
      (void)read(text);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }

  results::Result result = synthetic::rough_result(rough, 1);
};

TEST_F(MeasuredCurve, HasTheUnitsOfItsColumns) {
  const auto rows = read("# area [%]; pressure [MPa]; gap [nm]\n"
                         "1.5;2;30\n3;4;20\n")
                        .methods[0]
                        .realizations[0]
                        .points;
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_DOUBLE_EQ(rows[0].area_fraction, 0.015);
  EXPECT_DOUBLE_EQ(rows[0].nominal_pressure, 2e6);
  EXPECT_DOUBLE_EQ(rows[1].mean_gap, 20e-9);

  const Grid& grid = result.surfaces[0].grid;
  const double nominal = grid.length_x * grid.length_y;
  const auto loads =
      read("load [N],area [um^2]\n1e-3,2\n").methods[0].realizations[0].points;
  EXPECT_DOUBLE_EQ(loads[0].nominal_pressure, 1e-3 / nominal);
  EXPECT_DOUBLE_EQ(loads[0].area_fraction, 2e-12 / nominal);
  EXPECT_TRUE(std::isnan(loads[0].mean_gap));

  // A quarter of what was pressed is the map.
  result.surfaces[0].map = {grid.points_x / 2, grid.points_y / 2};
  EXPECT_DOUBLE_EQ(read("load [N],gap [nm]\n1e-3,2\n")
                       .methods[0]
                       .realizations[0]
                       .points[0]
                       .nominal_pressure,
                   4e-3 / nominal);
  EXPECT_DOUBLE_EQ(nominal_area(result), nominal / 4.0);
}

// As Excel, pandas, LibreOffice and COMSOL save a table.
TEST_F(MeasuredCurve, IsReadAsProgramsSaveIt) {
  const char* const texts[] = {
      "\xEF\xBB\xBFpressure [MPa],area [%]\r\n1,1.5\r\n10,\r\n,\r\n",
      "\"pressure [MPa]\",\"area [%]\"\n1,1.5\n10,\n",
      "\"pressure [MPa]\",\"area [%]\"\n\"1\",\"1.5\"\n\"10\",\"\"\n",
      "\"pressure (MPa)\",\"area (%)\"\n\"1,0\",\"1,5\"\n\"10,0\",\n",
      "pressure (MPa),area (1)\n1,0.015\n10,NaN\n",
      "Pressure / MPa;Area / %\n1,0;1,5\n10,0;\n",
      "sep=;\npressure [N/mm^2];area [%]\n1;1,5\n10;\n",
      ",pressure [MPa],area [%]\n0,1.0,1.5\n1,10.0,\n",
      "pressure [MPa],area [%],gap [nm]\n1,1.5,\n10,,\n",
      "pressure [MPa],area [%],,\n1,1.5,,\n10,,,\n",
      "pressure_MPa\tarea_%\n1\t1.5\n10\tn/a\n",
      "% Model:              contact.mph\n% Version:            COMSOL "
      "6.0.0.318"
      "\n% Date:               Nov 20 2026, 15:04\n"
      "% pressure (MPa)          area (1)\n"
      "1                         0.015\n10                        NaN\n",
      "# measured on 3 May\n# pressure [MPa] area [%] gap [nm]\n1 1.5 nan\n10 "
      "nan nan\n"};
  for (const char* const text : texts) {
    ASSERT_EQ(mistake(text), "") << text;
    const auto rows = read(text).methods[0].realizations[0].points;

    ASSERT_EQ(rows.size(), 2U) << text;
    EXPECT_NEAR(rows[0].nominal_pressure, 1e6, 1e-9) << text;
    EXPECT_NEAR(rows[0].area_fraction, 0.015, 1e-17) << text;
    EXPECT_NEAR(rows[1].nominal_pressure, 1e7, 1e-8) << text;
    EXPECT_TRUE(std::isnan(rows[1].area_fraction)) << text;
    EXPECT_TRUE(std::isnan(rows[1].mean_gap)) << text;
  }
}

TEST_F(MeasuredCurve, HasEveryUnitOfTheTable) {
  const Grid& grid = result.surfaces[0].grid;
  const double nominal = grid.length_x * grid.length_y;
  int pressures = 0, areas = 0;
  for (const input::Unit& unit : input::units()) {
    const std::string symbol(unit.symbol);
    if (unit.dimension == input::Dimension::pressure) {
      EXPECT_DOUBLE_EQ(read("pressure [" + symbol + "];gap [m]\n3;1\n")
                           .methods[0]
                           .realizations[0]
                           .points[0]
                           .nominal_pressure,
                       unit.in_si(3.0))
          << symbol;
      ++pressures;
    }
    if (unit.dimension == input::Dimension::area) {
      const double number = 0.1 * nominal / unit.in_si(1.0);
      EXPECT_NEAR(
          read(fmt::format("pressure (bar);area ({})\n1;{}\n", symbol, number))
              .methods[0]
              .realizations[0]
              .points[0]
              .area_fraction,
          0.1, 1e-15)
          << symbol;
      ++areas;
    }
  }
  EXPECT_GT(pressures, 20);
  EXPECT_GT(areas, 5);
}

// Tension needs a result in which there is adhesion.
TEST_F(MeasuredCurve, MayHaveTensionBesideAdhesion) {
  const std::string text = "pressure [MPa],gap [nm]\n-2,30\n0,25\n4,20\n";
  EXPECT_NE(mistake(text).find("mine.csv:2: must have a pressure > 0: the "
                               "result beside it has no adhesion"),
            std::string::npos)
      << mistake(text);

  result.methods[1].realizations[0].points[0][columns::adhesive_energy] =
      -1e-12;

  const auto rows = read(text).methods[0].realizations[0].points;
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_DOUBLE_EQ(rows[0].nominal_pressure, -2e6);
  EXPECT_EQ(rows[1].nominal_pressure, 0.0);
  EXPECT_NE(mistake("pressure [MPa],gap [nm]\n,30\n").find("mine.csv:2: "),
            std::string::npos);
  const results::Result mine = read(text);
  const cases::Case without = case_of(mine);
  std::vector<ReportEntry> entries{entry_of(result, rough),
                                   entry_of(mine, without)};
  EXPECT_TRUE(write_report(entries, folder, "no-such-gnuplot").size() > 0);
}

TEST_F(MeasuredCurve, AnswersMistakes) {
  for (const auto& [text, part] :
       {std::pair("presure [MPa],gap [nm]\n1,2\n",
                  "mine.csv:1: the column \"presure\" is unknown"),
        std::pair("presure [MPa],gap [nm]\n1,2\n", "nearest: pressure"),
        std::pair("pressure,gap [nm]\n1,2\n", "\"pressure\" has no unit"),
        std::pair("pressure [nm],gap [nm]\n1,2\n",
                  "has the unit nm of a length, but must have one of: Pa"),
        std::pair("pressure [kn/mm^2],gap [nm]\n1,2\n", "nearest: kN/mm^2"),
        std::pair("gap [nm],pressure [MPa]\n1,1e308\n",
                  "mine.csv:2: has a number that is infinite in SI units"),
        std::pair("pressure [MPa],gap [nm]\n1,5,2,5\n",
                  "separate the columns by semicolons"),
        std::pair("\xFF\xFEp", "is written in UTF-16; save it as CSV in UTF-8"),
        std::pair(",pressure [MPa],area [%]\n0,1,\n1,,3\n", "mine.csv:3: "),
        std::pair("pressure [Pa]\n1\n", "must name a pressure and an area"),
        std::pair("pressure [Pa],load [N]\n1,1\n", "is there twice"),
        std::pair("pressure [Pa],gap [m]\n1,1\n-2,1\n", "mine.csv:3: "),
        std::pair("pressure [Pa],area [%]\n1,101\n", "mine.csv:2: "),
        std::pair("pressure [Pa],gap [m]\n1,2,3\n", "mine.csv:2: "),
        std::pair("pressure [Pa],gap [m]\n1,x\n", "mine.csv:2: "),
        std::pair("", "mine.csv")})
    EXPECT_NE(mistake(text).find(part), std::string::npos)
        << text << mistake(text);
}

// A curve with twice the area, and no gap, of the first method.
TEST_F(MeasuredCurve, IsComparedWithTheFirstMethod) {
  std::string text = "pressure [Pa],area [1]\n";
  for (const auto& row : result.methods[1].realizations[0].points)
    if (row.area_fraction_corrected < 0.5)
      text += fmt::format("{},{}\n", row.nominal_pressure,
                          2.0 * row.area_fraction_corrected);
  const results::Result mine = read(text);
  const cases::Case without = case_of(mine);
  std::vector<ReportEntry> entries{entry_of(result, rough),
                                   entry_of(mine, without)};
  name_entries(entries, {});

  const std::vector<Series> series = series_of(entries);
  const Agreement agreement = agreements_of(entries, series).front();

  EXPECT_EQ(agreement.problem, "");
  EXPECT_EQ(agreement.method, "mine");
  EXPECT_NEAR(agreement.largest(&AgreementRow::area_difference), 1.0, 1e-9);
  EXPECT_NE(series.back().legend.find("mine, |ΔA|/A ≤ 100 %"),
            std::string::npos)
      << series.back().legend;
  EXPECT_TRUE(write_report(entries, folder, "no-such-gnuplot").size() > 0);
  EXPECT_NE(text_of(folder / "comparison.csv").find("\"mine\""),
            std::string::npos);
}

// u of the theory with gamma = 0.45 on the surface of the result: what is
// fitted is exact up to the digits of the file. A scatter of 1 % of h_rms gives
// an interval that contains it.
TEST_F(MeasuredCurve, HasTheGammaOfTheSpectrumBesideIt) {
  SurfaceTheories theories(result);
  const SurfaceTheory theory = theories.of(result.surfaces.front());
  const auto quantities = [&](double scatter) {
    std::string text = "pressure [Pa],gap [m]\n";
    for (int i = 0; i < 12; ++i) {
      const double pressure = 2e-4 * std::pow(100.0, i / 11.0) * 2e9;
      const LossSplit split = theory.gap(pressure);
      text += fmt::format("{},{}\n", pressure,
                          0.45 * split.at_one + 0.55 * split.at_zero +
                              (i % 2 == 0 ? 1.0 : -1.0) * scatter *
                                  result.surfaces.front().rms_height);
    }
    const results::Result mine = read(text);
    return summarize(mine, case_of(mine)).methods.front().quantities;
  };
  ASSERT_EQ(result.contact_modulus, 2e9);

  const auto exact = quantities(0.0);
  const auto noisy = quantities(0.01);

  for (const char* name : {"gamma_curve", "gamma_matched"}) {
    EXPECT_NEAR(exact.at(name).value, 0.45, 1e-9) << name;
    EXPECT_GT(noisy.at(name).half_width, 1e-3) << name;
    EXPECT_LT(std::abs(noisy.at(name).value - 0.45), noisy.at(name).half_width)
        << name;
  }
  const results::Result mine = read(text_of(folder / "mine.csv"));
  const cases::Case without = case_of(mine);
  const std::vector<std::string> answers =
      curve_answers(entry_of(mine, without), entry_of(result, rough));
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(
      answers[0].rfind("On the surface of polymer, γ of this curve is ", 0), 0U)
      << answers[0];
  EXPECT_NE(answers[0].find(number_text(noisy.at("gamma_curve")) +
                            " by the whole curve"),
            std::string::npos)
      << answers[0];
  for (const results::MethodRecord& method : result.methods)
    EXPECT_NE(answers[1].find("from " + method.name + " is "),
              std::string::npos)
        << answers[1];
  result.surfaces.front().heights.clear();
  EXPECT_EQ(quantities(0.0).at("gamma_curve").remark,
            "the heights are not in the result");
}

TEST_F(MeasuredCurve, ResultsOfOneCaseHaveNamesThatDiffer) {
  result.path = "a/result.h5";
  results::Result finer = result;
  finer.path = "b";
  cases::Case fine = rough;
  set_text(rough, "[surface]\npoints = 64\nseed = 1\n");
  set_text(fine, "[surface]\npoints = 128\nseed = 1\n");
  const auto names = [&](const std::vector<std::string>& labels) {
    std::vector<ReportEntry> entries{entry_of(result, rough),
                                     entry_of(finer, fine)};
    name_entries(entries, labels);
    return entries[0].summary.case_name + "; " + entries[1].summary.case_name;
  };
  EXPECT_EQ(names({}), "polymer (surface.points = 64); polymer "
                       "(surface.points = 128)");
  EXPECT_EQ(names({"coarse", "fine"}), "coarse; fine");
  set_text(fine, rough.text);
  EXPECT_EQ(names({}), "polymer (a); polymer (b)");
  finer.path = "a/";
  EXPECT_EQ(names({}), "polymer (result 1); polymer (result 2)");
}

TEST_F(MeasuredCurve, ReportsBeginInTheUnitsOfALaboratory) {
  auto& points = result.methods[1].realizations[0].points;
  points.resize(3);
  const double rows[3][3] = {
      {2e6, 0.0123, 50e-9}, {2e7, 0.1, 20e-9}, {1.5e9, 0.9, 1e-9}};
  for (std::size_t i = 0; i < 3; ++i) {
    points[i].nominal_pressure = rows[i][0];
    points[i].area_fraction_corrected = rows[i][1];
    points[i].mean_gap = rows[i][2];
    points[i].area_fraction = 1.1 * rows[i][1];
  }

  EXPECT_EQ(answers_of(entry_of(result, rough)).front(),
            "At 2 MPa 1.2 % (1.1 to 1.4) of the area touches and the mean gap "
            "is 50 nm; at 20 MPa 10 % (9 to 11) and 20 nm; at 1.5 GPa 90 % (81 "
            "to 99) and 1 nm.");
  write(result, "no-such-gnuplot");
  const Grid& grid = result.surfaces[0].grid;
  EXPECT_NE(
      text_of(folder / "report.html")
          .find(fmt::format("<td class=\"number\">1.23 ± 0.12 %</td><td "
                            "class=\"number\">{}</td><td "
                            "class=\"number\">50 nm</td>",
                            uncertain_text(0.0123 * grid.area(),
                                           0.00123 * grid.area(), "m^2"))),
      std::string::npos);
  result.methods.resize(1); // the theory alone
  EXPECT_TRUE(answers_of(entry_of(result, rough)).empty());
}

} // namespace asperity::reports::measured_curve_test
