// What a run writes, its reader accepts, and what a row leaves empty is
// explained, on random cases: problems of the robustness matrix with every
// study, law, edge and method that a case can ask for beside them. A case that
// is refused is refused before anything is computed.
#include "input/input_error.hpp"
#include "input/reader/read_case.hpp"
#include "input/types/omissions.hpp"
#include "reports/analysis/summary.hpp"
#include "results/result_reader.hpp"
#include "results/types/curve_columns.hpp"
#include "run/run_case.hpp"
#include "suite/robustness/draft.hpp"
#include "tests/folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace asperity::run::written_results_test {

using robustness::Draft;
using robustness::Instance;

constexpr std::uint64_t seed = 44;

/// A random problem with what else a case can ask for.
struct RandomCase {
  Instance instance;
  std::vector<std::string> overrides;
};

/// Draws what the instance does not have, each by its name.
class Extras {
public:
  explicit Extras(RandomCase& drawn)
      : draft_(seed, drawn.instance.index, nullptr, {}), drawn_(drawn) {}

  bool coin(const std::string& name, double probability) const {
    return draft_.uniform(name, 0.0, 1.0) < probability;
  }

  double number(const std::string& name, double low, double high) const {
    return draft_.log_uniform(name, low, high);
  }

  void add(const std::string& entry) { drawn_.overrides.push_back(entry); }

  void add_methods();
  void add_studies();

private:
  Draft draft_;
  RandomCase& drawn_;
};

/// Adds other methods beside that of the instance, one with a long name.
void Extras::add_methods() {
  const std::string& method = drawn_.instance.method;
  if (method == "halfspace" && drawn_.instance.label("law") == "hard" &&
      coin("hardness", 0.5))
    add(fmt::format("halfspace.hardness={:g} E* h'",
                    number("hardness value", 1e-3, 1e3)));
  if (coin("theory", 0.4)) {
    add("theory.gamma=0.4");
    add(coin("loss", 0.5) ? "theory.loss_factor=wang-mueser"
                          : "theory.loss_factor=xu");
    if (coin("theory hardness", 0.3))
      add(fmt::format("theory.hardness={:g} E* h'",
                      number("theory hardness value", 0.01, 10.0)));
  }
  if (coin("winkler", 0.2))
    add(fmt::format("winkler.stiffness={:g} E*/h",
                    number("stiffness", 1e-3, 1e3)));
  if (coin("variant", 0.15))
    add(method + "." +
        std::string(static_cast<std::size_t>(number("name", 1.0, 100.0)), 'x') +
        "={}");
}

void Extras::add_studies() {
  if (coin("flow", 0.4))
    add("flow={ viscosity = 1e-3, pressure_drop = 1e5, length = 1.0, width = "
        "2.0 }");
  if (coin("spots", 0.4))
    add("spots={}");
  if (coin("conductance", 0.5)) {
    add("conductance={ thermal_conductivity = 50.0, "
        "counter_thermal_conductivity = 16.0 }");
    if (coin("gap", 0.7)) {
      add(fmt::format("conductance.gap_conductivity={:.17e}",
                      number("gap_conductivity", 1e-12, 1e3)));
      add(fmt::format("conductance.smallest_gap={:.17e}",
                      number("smallest_gap", 1e-18, 1e3)));
    }
  }
  if (coin("friction", 0.3))
    add(fmt::format("friction.coefficient={:g}",
                    number("coefficient", 0.01, 2.0)));
  if (coin("stress", 0.3))
    add("report.stress_inside=true");
  add("report.fields=all");
  if (coin("precision", 0.3))
    add("report.precision=double");
}

/// Returns nothing for problems of other families or of large grids.
std::optional<RandomCase> drawn_case(int index) {
  RandomCase drawn{robustness::draw_instance(seed, index), {}};
  const std::string family = drawn.instance.label("family");
  const std::string points = drawn.instance.label("points");
  if (family == "flawed" || family == "full-block" || family == "atoms" ||
      family == "theory" || points == "64" || points == "48" ||
      drawn.instance.label("shortest-wave") == "2")
    return std::nullopt;
  Extras extras(drawn);
  extras.add_methods();
  extras.add_studies();
  return drawn;
}

class WrittenResults : public tests::FolderTest {
protected:
  /// What a run printed, or "" if it was refused before it computed anything.
  std::optional<cases::Case> ended(const RandomCase& drawn) const {
    std::filesystem::remove_all(folder / "out");
    std::ofstream(folder / "map.txt")
        << robustness::text_of_map(drawn.instance.map);
    std::optional<cases::Case> read;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    std::string refusal;
    try {
      read = cases::read_case_text(drawn.instance.text,
                                   (folder / "case.toml").string(),
                                   drawn.overrides);
      run_case(*read, {folder / "out", {}, false, 1});
    } catch (const input::InputError& error) {
      refusal = error.what();
    } catch (const std::domain_error& error) {
      refusal = error.what();
    }
    const std::string printed = testing::internal::GetCapturedStdout();
    testing::internal::GetCapturedStderr();
    if (refusal.empty())
      return read;
    EXPECT_EQ(printed.find(" step "), std::string::npos)
        << "refused at the end: " << refusal;
    EXPECT_FALSE(std::filesystem::exists(folder / "out" / "result.h5"))
        << refusal;
    return std::nullopt;
  }
};

/// The columns that a row leaves empty without a word.
std::vector<std::string> unexplained(const cases::Case& contact_case,
                                     const cases::MethodSpec& method,
                                     const results::CurvePoint& row) {
  std::vector<std::string> names;
  if (row.status != results::StepStatus::converged)
    return names;
  for (const cases::AskedTraits& one : cases::all_asked())
    if (one.is_in(contact_case) && one.obstacle(contact_case, method).empty())
      for (const char* const name : one.columns)
        if (std::isnan(results::curve_column(name).get(row)) &&
            row.note.find(name) == std::string::npos &&
            row.note.find("no flow: ") == std::string::npos)
          names.emplace_back(name);
  return names;
}

void expect_explained(const cases::Case& contact_case,
                      const results::Result& result) {
  for (const results::MethodRecord& record : result.methods)
    for (const results::CurvePoint& row : record.realizations.front().points)
      EXPECT_EQ(
          unexplained(contact_case,
                      *std::ranges::find(contact_case.methods, record.name,
                                         &cases::MethodSpec::name),
                      row),
          std::vector<std::string>())
          << record.name << ", step " << row.step << ": " << row.note;
}

TEST_F(WrittenResults, AreReadAndExplainWhatTheyLeaveEmpty) {
  int n_runs = 0;
  for (int index = 0; index < 450; ++index) {
    const std::optional<RandomCase> drawn = drawn_case(index);
    if (!drawn)
      continue;
    SCOPED_TRACE(fmt::format("case {}: {}\n{}", index,
                             robustness::text_of(drawn->instance),
                             fmt::join(drawn->overrides, "\n")));
    const std::optional<cases::Case> read = ended(*drawn);
    if (!read)
      continue;
    ++n_runs;
    try {
      const results::Result result = results::read_result(folder / "out");
      expect_explained(*read, result);
      for (const reports::MethodSummary& summary :
           reports::summarize(result, *read).methods)
        EXPECT_EQ(summary.problems, std::vector<std::string>()) << summary.name;
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GT(n_runs, 75);
}

TEST_F(WrittenResults, OfShippedStudiesExplainWhatTheyLeaveEmpty) {
  for (const std::string name : {"conductance", "seal"}) {
    SCOPED_TRACE(name);
    const cases::Case small = cases::read_case(
        std::string(ASPERITY_CASES) + "/" + name + "/case.toml",
        {"surface.points=64", "surface.realizations=1",
         "surface.wavelength_short=4 h", "expect="});
    testing::internal::CaptureStdout();
    run_case(small, {folder / "out", {}, false, 1});
    testing::internal::GetCapturedStdout();
    expect_explained(small, results::read_result(folder / "out"));
    std::filesystem::remove_all(folder / "out");
  }
}

} // namespace asperity::run::written_results_test
