// Tests of the commands for scripts: describe, diff, the options of check,
// --json and --quiet.
#include "tests/program/program.hpp"

#include <nlohmann/json.hpp>

namespace asperity::program::inspect_test {

using Json = nlohmann::json;

class Inspect : public ProgramTest {
protected:
  Inspect() {
    write("small.toml", small_case);
    write("strict.toml", std::string(small_case) +
                             "[expect]\n"
                             "iterations_max = [{ below = 1, methods = "
                             "[\"halfspace\"] }, { below = 1000, "
                             "methods = [\"fem\"] }]\n");
  }

  /// Standard output alone.
  std::string answer(const std::string& arguments) const {
    return run(arguments, "sh -c '\"$0\" \"$@\" 2> errors.txt'").output;
  }

  Json json(const std::string& arguments) const {
    return Json::parse(answer(arguments), nullptr, false);
  }
};

TEST_F(Inspect, DescribeResolvesEveryKeyInSi) {
  const Json told = json("describe small.toml --set surface.points=32 --json");

  const auto value = [&](const char* key) {
    return told["keys"][key]["value"];
  };
  EXPECT_EQ(value("surface.length"), 1e-6);
  EXPECT_EQ(told["keys"]["surface.length"]["unit"], "m");
  EXPECT_EQ(told["keys"]["surface.length"]["written"], "\"1 um\"");
  EXPECT_EQ(value("surface.points"), 32);
  EXPECT_EQ(value("surface.wavelength_short"), 8e-6 / 32);
  EXPECT_EQ(value("fem.depth"), 1e-6) << "a default in units of the length";
  EXPECT_TRUE(told["keys"]["fem.depth"]["written"].is_null());
  EXPECT_EQ(value("load.nominal_pressure").size(), 4U);
  EXPECT_NEAR(value("load.nominal_pressure")[3].get<double>(),
              0.05 * 2e9 / (1 - 0.09), 1.0);
  EXPECT_FALSE(told["keys"].contains("surface.edges"))
      << "a default of another kind of surface";
  EXPECT_DOUBLE_EQ(told["derived"]["node_spacing"]["value"], 1e-6 / 32);
  EXPECT_NEAR(told["derived"]["rms_slope"]["value"].get<double>(), 0.1, 0.02);
  EXPECT_NEAR(told["loads"][3]["reduced"].get<double>(), 0.05, 1e-12);
  EXPECT_EQ(told["methods"].size(), 3U);
  EXPECT_EQ(told["plan"]["methods"][1]["steps"], 8);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_F(Inspect, DescribeShowsAVariantWithWhatItInherits) {
  write("variant.toml",
        std::string(small_case) + "[fem.hard]\ncontact = \"hard\"\n");

  const Json keys = json("describe variant.toml --json")["keys"];

  EXPECT_EQ(keys["fem.contact"]["value"], "penalty");
  EXPECT_EQ(keys["fem.hard.contact"]["value"], "hard");
  EXPECT_EQ(keys["fem.hard.penalty"]["unit"], "Pa/m");
  EXPECT_EQ(keys["fem.hard.penalty"]["value"], keys["fem.penalty"]["value"]);
}

TEST_F(Inspect, DiffFindsKeysNumbersAndMissingRows) {
  ASSERT_EQ(run("run small.toml --methods halfspace,theory --no-report "
                "--quiet")
                .exit_code,
            0);
  ASSERT_EQ(run("run small.toml --methods halfspace --no-report --no-cache "
                "--out again")
                .exit_code,
            0);
  ASSERT_EQ(run("run small.toml --methods halfspace,theory --no-report --out "
                "other --set surface.seed=4")
                .exit_code,
            0);

  EXPECT_EQ(run("diff out/small out/small").exit_code, 0);
  EXPECT_EQ(run("diff out/small small.toml --quiet").exit_code, 0);
  const Json same = json("diff out/small again --json");
  EXPECT_EQ(same["missing"].size(), 1U) << same.dump(1);
  EXPECT_EQ(same["missing"][0]["name"], "theory");
  for (const Json& method : same["methods"])
    EXPECT_EQ(method["rows_that_differ"], 0) << same.dump(1);
  const Ended differ = run("diff out/small other --tolerance 1e-6");
  EXPECT_EQ(differ.exit_code, 1);
  EXPECT_NE(differ.output.find("surface.seed                     3 | 4"),
            std::string::npos)
      << differ.output;
  EXPECT_NE(differ.output.find("halfspace        8 of 8 rows differ"),
            std::string::npos)
      << differ.output;
  EXPECT_NE(differ.output.find("theory           4 rows are equal"),
            std::string::npos)
      << differ.output;
  std::string steep = small_case;
  const std::string loads = "nominal_pressure = ";
  steep.insert(steep.find(loads) + loads.size(), "[\"0.1 E* h'\"] # ");
  write("steep.toml", steep);
  ASSERT_EQ(run("run steep.toml --methods halfspace --no-report --out steep")
                .exit_code,
            0);
  EXPECT_EQ(run("diff steep steep").exit_code, 0) << "a unit of the surface";
  EXPECT_EQ(run("diff steep steep.toml --quiet").exit_code, 0);
  EXPECT_EQ(run("diff out/small peers").exit_code, 2);
  EXPECT_EQ(run("diff out/small nowhere").exit_code, 2);
}

TEST_F(Inspect, CheckTakesTheOptionsOfRun) {
  const Ended checked =
      run("check strict.toml --methods fem --set surface.points=32 --out here "
          "--threads 1 --quiet");

  EXPECT_EQ(checked.exit_code, 0) << checked.output;
  EXPECT_EQ(checked.output, "") << "the expectation of fem is met";
  const Json described = json("diff here strict.toml --json");
  EXPECT_NE(described["keys"].dump().find("surface.points"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  const Ended refused = run("check here --set surface.points=64");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.output.find("--set applies to cases"), std::string::npos)
      << refused.output;
}

TEST_F(Inspect, CheckPrintsOnlyWhatIsNotMetOrJson) {
  const Ended quiet = run("check strict.toml --methods halfspace,fem --quiet");
  EXPECT_EQ(quiet.exit_code, 1);
  EXPECT_EQ(quiet.output.find("strict: failed     halfspace"), 0U)
      << quiet.output;
  EXPECT_EQ(std::count(quiet.output.begin(), quiet.output.end(), '\n'), 1);

  const Json told = json("check out/strict --json");
  EXPECT_EQ(told["exit_code"], 1);
  const Json& summary = told["results"][0]["summary"];
  EXPECT_EQ(summary["expectations"][0]["verdict"], "failed");
  EXPECT_EQ(summary["expectations"][1]["verdict"], "ok");
}

// The file for a job server exists in every case.
TEST_F(Inspect, CheckWritesJunitAlsoIfACaseCannotBeRead) {
  write("broken.toml", "schema = 1\n");

  const Ended both = run("check broken.toml strict.toml --methods halfspace "
                         "--junit a.xml");
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_NE(both.output.find("failed     halfspace"), std::string::npos)
      << "the case after the bad one: " << both.output;
  EXPECT_EQ(run("check nowhere.toml --junit b.xml").exit_code, 2);
  EXPECT_EQ(run("check strict.toml missing.h5").exit_code, 2);
  const Ended lost = run("check strict.toml --junit strict.toml/c.xml");

  const std::string broken = text_of(folder / "a.xml");
  EXPECT_NE(broken.find("name=\"broken.toml\""), std::string::npos) << broken;
  EXPECT_NE(broken.find("[surface] is missing"), std::string::npos) << broken;
  EXPECT_NE(text_of(folder / "b.xml").find("<error"), std::string::npos);
  EXPECT_EQ(lost.exit_code, 2) << lost.output;
  EXPECT_NE(lost.output.find("strict.toml is no folder"), std::string::npos)
      << lost.output;
}

TEST_F(Inspect, RunAnswersInJsonAndNothingElse) {
  const Json told = json("run small.toml --methods theory --json");
  EXPECT_EQ(told["exit_code"], 0) << told.dump();
  EXPECT_EQ(told["results"][0]["folder"], "out/small");
  EXPECT_EQ(told["results"][0]["summary"]["case"], "small");
  EXPECT_EQ(json("report out/small --json")["results"].size(), 1U);
  EXPECT_EQ(json("run small.toml --dry-run --json")[0]["case"], "small");
  EXPECT_GT(json("list --json").size(), 20U);
  EXPECT_EQ(json("cache --json")["folder"], "cache");
  EXPECT_EQ(answer("run small.toml --methods theory --quiet"), "");
}

// The computed numbers are the same to the last byte; times are in a separate
// file.
TEST_F(Inspect, TablesOfTwoRunsAreTheSame) {
  const std::string small = "run small.toml --methods halfspace --no-cache "
                            "--quiet --set surface.points=32 --out ";
  ASSERT_EQ(run(small + "a").exit_code, 0);
  ASSERT_EQ(run(small + "b").exit_code, 0);

  EXPECT_EQ(text_of(folder / "a/curves.csv"), text_of(folder / "b/curves.csv"));
  EXPECT_NE(text_of(folder / "a/times.csv"), text_of(folder / "b/times.csv"));
}

} // namespace asperity::program::inspect_test
