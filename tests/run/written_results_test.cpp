// What a run writes, its reader accepts, and what a row leaves empty is
// explained, on random cases: problems of the robustness matrix with every
// study, law, edge and method that a case can ask for beside them. A case that
// is refused is refused before anything is computed.
#include "cases/reader/read_case.hpp"
#include "cases/types/omissions.hpp"
#include "input/input_error.hpp"
#include "reports/analysis/summary.hpp"
#include "results/result_reader.hpp"
#include "results/types/curve_columns.hpp"
#include "robustness/draw.hpp"
#include "robustness/kinds.hpp"
#include "robustness/written_case.hpp"
#include "run/run_case.hpp"
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

using robustness::Draw;
using robustness::Family;
using robustness::Instance;

constexpr std::uint64_t seed = 44;

/// Draws what the instance does not have. Each question has a stream of its
/// own, behind those of the instances.
class Extras {
public:
  explicit Extras(int index) : draw_(seed, index) {}

  bool coin(double probability) {
    return draw_.uniform(next(), 0.0, 1.0) < probability;
  }

  double number(double low, double high) {
    return draw_.log_uniform(next(), low, high);
  }

  template <class Value>
  Value of(std::initializer_list<Value> values) {
    return draw_.pick<Value>(next(), values);
  }

private:
  robustness::Stream next() {
    return static_cast<robustness::Stream>(1000 + count_++);
  }

  Draw draw_;
  int count_ = 0;
};

struct RandomCase {
  Instance instance;
  std::vector<std::string> overrides;
};

std::string entry(const std::string& key, double value) {
  return fmt::format("{}={:.17e}", key, value);
}

/// Adds a law with adhesion or a hardness to the contact.
void add_law(const std::string& method, Extras& extras, RandomCase& drawn) {
  const Instance& instance = drawn.instance;
  const Grid grid = robustness::grid_of(instance);
  const double rms = robustness::surface_of(instance, grid).height_scale;
  const double modulus = instance.contact_modulus;
  if (method != "winkler" && extras.coin(0.25)) {
    std::vector<std::string> laws;
    for (const mechanics::ContactLawTraits& law : mechanics::contact_laws())
      if (mechanics::is_adhesive(law.law))
        laws.emplace_back(law.name);
    drawn.overrides.push_back(
        method + ".contact=" +
        laws[static_cast<std::size_t>(extras.number(1.0, 6.999)) - 1]);
    drawn.overrides.push_back(method + ".penalty=");
    drawn.overrides.push_back(
        entry(method + ".work_of_adhesion",
              extras.number(1e-3, 1.0) * modulus * instance.rms_slope * rms));
  } else if (method == "halfspace" && extras.coin(0.3)) {
    double largest = 0.0;
    for (const mechanics::LoadTarget& target :
         robustness::targets_of(instance, rms))
      largest = std::max(largest, target.amount);
    if (instance.control == mechanics::Control::mean_gap)
      largest = modulus * instance.rms_slope;
    drawn.overrides.push_back(method + ".contact=hard");
    drawn.overrides.push_back(method + ".penalty=");
    drawn.overrides.push_back(
        entry(method + ".hardness",
              largest * extras.of({1.0, 1.0 + 1e-12, 1.001, 1.3, 5.0, 0.9})));
  }
}

/// Adds other methods beside that of the instance, one with a long name.
void add_methods(const std::string& method, Extras& extras, RandomCase& drawn) {
  if (extras.coin(0.4)) {
    drawn.overrides.emplace_back("theory.gamma=0.4");
    drawn.overrides.push_back(std::string("theory.loss_factor=") +
                              extras.of({"yang-persson", "wang-mueser", "xu"}));
    if (extras.coin(0.3))
      drawn.overrides.push_back(
          entry("theory.hardness", drawn.instance.contact_modulus *
                                       drawn.instance.rms_slope *
                                       extras.number(0.01, 10.0)));
  }
  if (extras.coin(0.2))
    drawn.overrides.push_back(
        fmt::format("winkler.stiffness={:g} E*/h", extras.number(1e-3, 1e3)));
  if (extras.coin(0.15))
    drawn.overrides.push_back(
        method + "." +
        std::string(static_cast<std::size_t>(extras.number(1.0, 100.0)), 'x') +
        "={}");
}

void add_studies(Extras& extras, RandomCase& drawn) {
  std::vector<std::string>& entries = drawn.overrides;
  const double length = drawn.instance.length;
  if (extras.coin(0.4))
    entries.emplace_back(
        "flow={ viscosity = 1e-3, pressure_drop = 1e5, length = 1.0, width = "
        "2.0 }");
  if (extras.coin(0.4))
    entries.emplace_back("spots={}");
  if (extras.coin(0.5)) {
    entries.emplace_back("conductance={ thermal_conductivity = 50.0, "
                         "counter_thermal_conductivity = 16.0 }");
    if (extras.coin(0.7)) {
      entries.push_back(
          entry("conductance.gap_conductivity", extras.number(1e-12, 1e3)));
      entries.push_back(entry("conductance.smallest_gap",
                              length * extras.number(1e-6, 1e-3)));
    }
  }
  if (extras.coin(0.3))
    entries.push_back(entry("friction.coefficient", extras.number(0.01, 2.0)));
  if (extras.coin(0.3))
    entries.emplace_back("report.stress_inside=true");
  entries.emplace_back("report.fields=all");
  if (extras.coin(0.3))
    entries.emplace_back("report.precision=double");
  if (extras.coin(0.3))
    entries.push_back(std::string("surface.edges=") +
                      extras.of({"mirror", "window", "free"}));
}

RandomCase drawn_case(int index) {
  RandomCase drawn{robustness::draw_instance(seed, index), {}};
  Extras extras(index);
  Instance& instance = drawn.instance;
  instance.path = robustness::Path::program;
  if (instance.family != Family::slab &&
      instance.family != Family::condensed_q1 &&
      instance.family != Family::condensed_q2)
    instance.family = Family::halfspace;
  instance.points = extras.of({8, 16, 16, 24, 32});
  instance.shortest_wave = 4.0; // which each of these grids resolves
  instance.flaw = robustness::Flaw::none;
  if (mechanics::is_adhesive(instance.law))
    instance.law = mechanics::ContactLaw::hard;
  instance = robustness::within_reach(instance);
  const std::string method =
      instance.family == Family::halfspace || instance.family == Family::slab
          ? "halfspace"
          : "fem";
  add_law(method, extras, drawn);
  add_methods(method, extras, drawn);
  add_studies(extras, drawn);
  return drawn;
}

class WrittenResults : public tests::FolderTest {
protected:
  /// What a run printed, or "" if it was refused before it computed anything.
  std::optional<cases::Case> ended(const RandomCase& drawn) const {
    std::filesystem::remove_all(folder / "out");
    std::ofstream(folder / "map.txt")
        << robustness::map_text_of(drawn.instance);
    std::optional<cases::Case> read;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    std::string refusal;
    try {
      read = cases::read_case_text(robustness::case_text_of(drawn.instance),
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

std::string text_of(const RandomCase& drawn, int index) {
  return fmt::format("case {}: {}\n{}", index,
                     robustness::text_of(drawn.instance),
                     fmt::join(drawn.overrides, "\n"));
}

TEST_F(WrittenResults, AreReadAndExplainWhatTheyLeaveEmpty) {
  int n_runs = 0;
  for (int index = 0; index < 150; ++index) {
    const RandomCase drawn = drawn_case(index);
    SCOPED_TRACE(text_of(drawn, index));
    const std::optional<cases::Case> read = ended(drawn);
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
