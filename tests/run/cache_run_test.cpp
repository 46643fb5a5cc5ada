// Tests of runs with a cache: which change of a case causes which steps to be
// computed again, and that cached numbers are those that were computed.
#include "input/reader/read_case.hpp"
#include "input/reader/vocabulary.hpp"
#include "run/methods/cache/case_keys.hpp"
#include "run/run_case.hpp"
#include "tests/folder.hpp"
#include "tests/rough_case.hpp"
#include "tests/same_bits.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace asperity::run::cache_run_test {

using Overrides = std::vector<std::string>;

const std::string pressed_case =
    tests::rough_case("pressed", 32, tests::four_loads, R"([halfspace]
contact = "hard"
[halfspace.soft]
contact = "penalty"
penalty = "100 E*/h"
)");

// The theory once, two elastic methods on two realisations, four loads each.
constexpr int a_method = 2 * 4;
constexpr int all_steps = 4 + 2 * a_method;

class CachedRun : public tests::FolderTest {
protected:
  RunOutcome run(const Overrides& overrides, methods::Cache& beside,
                 const std::string& out = "out") const {
    const cases::Case contact_case = cases::read_case_text(
        text, (folder / "pressed.toml").string(), overrides);
    return run_case(contact_case, {folder / out, {}, false, 1, "", &beside});
  }

  /// The number of steps that are computed with the cache of this test.
  int computed(const Overrides& overrides = {},
               const std::string& out = "out") {
    return run(overrides, cache, out).computed_steps;
  }

  results::Result result(const std::string& out) const {
    return results::read_result(folder / out);
  }

  std::string text = pressed_case;
  methods::Cache cache{folder / "cache", 100'000'000};
};

/// A list of loads in E*.
std::string loads(const std::string& pressures) {
  return "load.nominal_pressure=[" + pressures + "]";
}

TEST_F(CachedRun, UnchangedIsReadBitByBit) {
  EXPECT_EQ(computed({}, "first"), all_steps);

  const RunOutcome second = run({}, cache, "second");

  EXPECT_EQ(second.computed_steps, 0);
  EXPECT_EQ(second.kept_steps, all_steps);
  tests::expect_same_bits(result("first"), result("second"), true);
}

// Titles, reports, comments and the order of keys do not affect any number.
TEST_F(CachedRun, DescriptionsChangeNothing) {
  computed();
  text.replace(text.find("\"pressed\""), 9, "\"another title\"");
  text.replace(text.find("rms_slope = 0.1\n"), 16, "# steep\n");
  text.replace(text.find("seed = 3\n"), 9, "rms_slope = 0.1\nseed = 3\n");

  EXPECT_EQ(computed({"expect.kappa={above=1.0,methods=[\"halfspace\"]}"}), 0);
}

TEST_F(CachedRun, OneMethodsKeyRunsThatMethodAgain) {
  computed();

  EXPECT_EQ(computed({"halfspace.soft.penalty=50 E*/h"}), a_method);
  EXPECT_EQ(computed({"theory.gamma=0.5"}), 4);
  EXPECT_EQ(computed({"halfspace.tolerance=1e-7"}), 2 * a_method); // inherited
  EXPECT_EQ(computed(), 0); // the first is still in the cache
}

// Layers reach the half-space, and a change of any of their numbers computes
// the steps again: a stiff coating raises the mean plane at equal load.
TEST_F(CachedRun, LayersRunEveryMethodAgainAndChangeIt) {
  const auto coated = [](const std::string& modulus) {
    return Overrides{"material.layers=[{thickness=\"0.05 length\","
                     "youngs_modulus=\"" +
                     modulus + "\",poisson_ratio=0.2}]"};
  };
  computed({}, "bare");

  EXPECT_EQ(computed(coated("20 GPa"), "stiff"), all_steps);
  EXPECT_EQ(computed(coated("30 GPa"), "stiffer"), all_steps);
  EXPECT_EQ(computed(coated("20 GPa"), "again"), 0);

  const auto first_gap = [&](const std::string& out) {
    for (const results::MethodRecord& method : result(out).methods)
      if (method.name == "halfspace")
        return method.realizations[0].points[0].mean_gap;
    return 0.0;
  };
  EXPECT_GT(first_gap("stiff"), 1.05 * first_gap("bare"));
  EXPECT_GT(first_gap("stiffer"), first_gap("stiff"));
  for (const results::MethodRecord& method : result("stiff").methods)
    EXPECT_NE(method.description.find(method.kind == "theory"
                                          ? "uniform: without the layers"
                                          : "under 1 bonded layer"),
              std::string::npos)
        << method.description;
}

TEST_F(CachedRun, AnotherMethodRunsThatAlone) {
  computed();
  text += "[halfspace.slab]\nthickness = \"0.5 length\"\n";

  EXPECT_EQ(computed(), a_method);
}

TEST_F(CachedRun, AnotherSurfaceOrMaterialRunsAllAgain) {
  computed();

  EXPECT_EQ(computed({"surface.seed=4"}), all_steps);
  EXPECT_EQ(computed({"surface.hurst=0.7"}), all_steps);
  EXPECT_EQ(computed({"material.poisson_ratio=0.4"}), all_steps);
}

TEST_F(CachedRun, RealizationsAreCachedOneByOne) {
  computed();

  EXPECT_EQ(computed({"surface.realizations=3"}), 2 * 4);
}

// A method with a smaller number of realisations solves the first ones, finds
// them in the cache, and never has more than the surface.
TEST_F(CachedRun, AMethodMaySolveFewerRealizations) {
  const Overrides fewer{"halfspace.soft.realizations=1"};
  EXPECT_EQ(computed(fewer, "fewer"), 4 + a_method + 4);
  const results::Result written = result("fewer");
  EXPECT_EQ(written.methods.at(1).realizations.size(), 2U);
  EXPECT_EQ(written.methods.at(2).realizations.size(), 1U);

  EXPECT_EQ(computed(), 4);
  EXPECT_EQ(computed(fewer), 0);
  EXPECT_EQ(computed({"halfspace.soft.realizations=9"}, "more"), 0);
  EXPECT_EQ(result("more").methods.at(2).realizations.size(), 2U);
}

// An additional load at the end costs one step per curve, and the result is
// that of an uninterrupted run, bit for bit: the step starts from the saved
// state.
TEST_F(CachedRun, ALoadAtTheEndCostsOneStep) {
  const std::string three = "\"1e-3 E*\",\"1e-2 E*\",\"2e-2 E*\"";
  const Overrides longer{loads(three + ",\"4e-2 E*\""), "report.fields=0"};
  methods::Cache none;
  run(longer, none, "whole");
  EXPECT_EQ(computed({loads(three), "report.fields=0"}), 3 + 2 * 6);

  EXPECT_EQ(computed(longer, "longer"), 1 + 2 * 2);

  tests::expect_same_bits(result("whole"), result("longer"));
}

// A load in the middle changes every later load. The state before it is no
// longer available; the result is still that of a run without a cache, bit for
// bit.
TEST_F(CachedRun, ALoadInTheMiddleRunsWhatFollows) {
  computed({loads("\"1e-3 E*\",\"1e-2 E*\",\"4e-2 E*\""), "report.fields=0"});
  const Overrides other{loads("\"1e-3 E*\",\"2e-2 E*\",\"4e-2 E*\""),
                        "report.fields=0"};
  methods::Cache none;
  run(other, none, "whole");

  EXPECT_EQ(computed(other, "other"), 2 + 2 * 2 * 2);

  tests::expect_same_bits(result("whole"), result("other"));
}

// Maps that were not saved cannot be read: only realisation 0 has them, in each
// of the elastic methods.
TEST_F(CachedRun, MoreMapsCostTheirSteps) {
  computed();

  methods::Cache none;
  run({"report.fields=4"}, none, "whole");

  EXPECT_EQ(computed({"report.fields=4"}, "maps"), 2 * 3);
  tests::expect_same_bits(result("whole"), result("maps"));
  EXPECT_EQ(computed({"report.fields=2"}), 0);
}

// The same name and size with one height that differs.
TEST_F(CachedRun, AChangedMapIsNotInTheCache) {
  const auto write_map = [&](double last) {
    std::ofstream stream(folder / "map.txt");
    for (int i = 0; i < 64; ++i)
      stream << fmt::format("{:.3f}{}", i == 63 ? last : 1e-2 * (7 * i % 11),
                            i % 8 == 7 ? '\n' : ' ');
  };
  text.replace(
      0, text.find("[material]"),
      "schema = 1\ntitle = \"map\"\n[surface]\nkind = \"measured\"\n"
      "file = \"map.txt\"\nlength = \"1 um\"\n"
      "height_unit = \"1 um\"\nlevel = \"none\"\nedges = \"periodic\"\n");
  write_map(0.02);
  EXPECT_EQ(computed(), 3 * 4);
  EXPECT_EQ(computed(), 0);

  write_map(0.03);

  EXPECT_EQ(computed(), 3 * 4);
}

// A damaged entry costs its own step, not the run and not the other steps.
TEST_F(CachedRun, ADamagedStepIsComputedAgain) {
  computed({}, "first");
  std::filesystem::path step;
  for (const auto& file : std::filesystem::directory_iterator(cache.folder()))
    if (file.path().extension() == ".step" &&
        (step.empty() || file.path() < step))
      step = file.path();
  std::filesystem::resize_file(step, 200);

  EXPECT_EQ(run({}, cache, "second").kept_steps, all_steps - 1);
  tests::expect_same_bits(result("first"), result("second"));
  EXPECT_EQ(computed(), 0); // it is in the cache again
}

// Every key that names a file is among those whose bytes enter the cache keys
// and are compared on resuming. A new key of the vocabulary fails here until it
// is added.
TEST(InputHashes, CoverEveryFileOfTheVocabulary) {
  std::set<std::string> keys;
  for (const cases::Table& table : cases::vocabulary())
    for (const cases::Key& key : table.keys)
      if (key.type == cases::ValueType::path && key.name != "base")
        keys.insert(table.name + "." + key.name);

  EXPECT_EQ(keys, (std::set<std::string>{"surface.file", "mesh.file",
                                         "material.variation.file"}));
}

// Methods share an operator if they differ only in the contact law or the
// magnification. Any other key, including keys that are added to the vocabulary
// later, separates them.
TEST_F(CachedRun, OnlyTheContactLawSharesAnOperator) {
  const auto of_variant = [this](const std::string& key) {
    const cases::Case read = cases::read_case_text(
        text + "[halfspace.other]\n" + key + "\n", "pressed.toml");
    const methods::CaseKeys keys(read, "program");
    return std::pair(
        keys.operator_text(read.methods[1], {32, 32, 1.0, 1.0}),
        keys.operator_text(read.methods.back(), {32, 32, 1.0, 1.0}));
  };
  for (const char* key : {"tolerance = 1e-6", "max_iterations = 9",
                          "contact = \"penalty\"\npenalty = \"9 E*/h\"",
                          "magnification = 2.0", "realizations = 1"}) {
    const auto [base, other] = of_variant(key);
    EXPECT_EQ(base, other) << key;
  }
  for (const char* key : {"thickness = \"1 length\"", "top = \"sliding\""}) {
    const auto [base, other] = of_variant(key);
    EXPECT_NE(base, other) << key;
  }
}

// Another build or another processor has another identity, which is in every
// key.
TEST_F(CachedRun, AnotherBuildHasOtherKeys) {
  const cases::Case contact_case = cases::read_case_text(text, "pressed.toml");
  const methods::CaseKeys ours(contact_case, methods::program_identity());
  const methods::CaseKeys again(contact_case, methods::program_identity());
  const methods::CaseKeys theirs(contact_case,
                                 methods::program_identity() + " changed");
  for (const cases::MethodSpec& method : contact_case.methods) {
    EXPECT_EQ(ours.steps(method, 0), again.steps(method, 0));
    EXPECT_NE(ours.steps(method, 0)[0], ours.steps(method, 1)[0]);
    for (const std::size_t step : {0u, 3u})
      EXPECT_NE(ours.steps(method, 0)[step], theirs.steps(method, 0)[step]);
  }
  EXPECT_NE(ours.of_operator("q2"), theirs.of_operator("q2"));
}

} // namespace asperity::run::cache_run_test
