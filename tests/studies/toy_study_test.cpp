// A study of one file: its settings, keys, column, answer and what it asks of
// methods are known to the reader of cases, to the warnings about methods that
// do not answer, to CSV files and to reports, and so is its number at a load.
#include "input/input_error.hpp"
#include "input/reader/bound_key.hpp"
#include "input/reader/case_schema.hpp"
#include "input/reader/documents.hpp"
#include "input/reader/read_case.hpp"
#include "reports/analysis/at_load.hpp"
#include "reports/pages/methods_text.hpp"
#include "results/csv.hpp"
#include "results/types/curve_columns.hpp"
#include "studies/study.hpp"
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>

namespace asperity::studies::toy_study_test {

struct Counting {
  int weight = 2; ///< of a node >= 1
};

const results::CurveColumn counted{
    "counting", {.name = "counted", .unit = "1", .text = "nodes, weighted"}};

const cases::StudyKeys& counting_keys() {
  static const cases::StudyKeys keys{
      .tables = {{.name = "counting",
                  .when = "Optional.",
                  .description = "Counts nodes.",
                  .keys = {cases::key<&Counting::weight>(
                      "weight", cases::between(1, 9), "Weight of a node.")}}},
      .read =
          [](cases::TableReader table, cases::Case& read) {
            table.read(read.studies.ask(Counting{}));
          },
      .is_asked = asks<Counting>,
      .questions = {
          {"[counting]", {"counted"}, asks<Counting>, cases::no_map}}};
  return keys;
}

const reports::StudyPages& counting_pages() {
  static const reports::StudyPages pages{
      .name = "counting",
      .methods_text =
          [](const cases::Case& asked) {
            return std::string(asks<Counting>(asked) ? " Nodes were counted."
                                                     : "");
          },
      .at_load = {{{.name = "half_of_counted",
                    .description = "Half of the count [1].",
                    .of = cases::QuantityOf::load},
                   [](const reports::StepAtLoad& step) {
                     return 0.5 * step.row[counted];
                   }}}};
  return pages;
}

const Study counting{
    .keys = counting_keys,
    .pages = counting_pages,
    .evaluate = [](const Step& step, results::CurvePoint& row) {
      row[counted] = step.contact_case.study<Counting>()->weight *
                     static_cast<double>(step.grid.size());
    }};

/// As the list of studies does it for its own.
const bool is_told = [] {
  static const cases::StudyKeys* const keys = &counting.keys();
  cases::add_studies({&keys, 1});
  reports::add_study_pages(counting.pages());
  return true;
}();

cases::Case read(const std::string& more) {
  return cases::read_case_text(std::string(cases::contact_case) + more,
                               "case.toml");
}

TEST(ToyStudy, IsReadFromItsTable) {
  ASSERT_TRUE(is_told);
  EXPECT_EQ(read("[counting]\nweight = 3\n").study<Counting>()->weight, 3);
  EXPECT_EQ(read("").study<Counting>(), nullptr);
  EXPECT_NE(cases::json_schema().find("\"counting\""), std::string::npos);
  EXPECT_NE(cases::case_reference_markdown().find("Weight of a node."),
            std::string::npos);
}

TEST(ToyStudy, RefusesWhatItsKeysDoNotAllow) {
  try {
    (void)read("[counting]\nweigth = 3\n");
    FAIL() << "an unknown key was read";
  } catch (const input::InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("counting.weigth is not a key of this table; nearest: "
                        "weight"),
              std::string::npos)
        << error.what();
  }
}

TEST(ToyStudy, EvaluatesAStep) {
  const cases::Case asked = read("[counting]\n");
  const methods::SurfaceOfCase surface;
  const std::vector<double> field(4, 0.0);
  results::CurvePoint row;
  counting.evaluate({asked,
                     asked.methods.front(),
                     surface,
                     {2, 2, 1.0, 1.0},
                     field,
                     field,
                     {mechanics::ContactCriterion{}, field, field}},
                    row);

  EXPECT_EQ(row[counted], 8.0);
  results::Result result;
  result.methods = {{"halfspace", "halfspace", "", {{{row}, {}, 0.0}}}};
  EXPECT_NE(results::curves_csv(result).find("counted [1]"), std::string::npos);
}

TEST(ToyStudy, HasANumberAtALoad) {
  const std::string name = "half_of_counted@p=1 MPa";
  const cases::Case asked =
      read("\"" + name + "\" = { below = 9 }\n[counting]\n");
  ASSERT_EQ(asked.expectations.back().quantity, name);
  EXPECT_EQ(asked.expectations.back().methods,
            (std::vector<std::string>{"halfspace", "fem"}));
  results::Result result;
  result.contact_modulus = 1e9;
  results::CurvePoint row;
  row.nominal_pressure = 1e6;
  row[counted] = 6.0;
  result.methods = {
      {"halfspace", "halfspace", "", {results::Curve{{row}, {}, 0.0}}}};
  reports::MethodSummary summary;

  reports::add_quantities_at_load(result, asked, result.methods.front(),
                                  nullptr, {&name, 1}, summary);

  EXPECT_EQ(summary.quantities.at(name).value, 3.0);
}

} // namespace asperity::studies::toy_study_test
