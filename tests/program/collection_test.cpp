// Tests of collections: what is listed, what runs and in which folder, the
// overrides of --quick, and the state after an interruption.
#include "results/result_reader.hpp"
#include "tests/program/program.hpp"

namespace asperity::program::collection_test {

namespace fs = std::filesystem;

class Collection : public ProgramTest {
protected:
  Collection() {
    for (const char* part : {"mine/light", "mine/heavy"})
      fs::create_directories(folder / part);
    write("mine/README.md", "# My <paper>\n\nLight, then heavy.\n");
    write("mine/light/case.toml", small_case);
    write("mine/collection.toml", "parts = [\"light\", \"heavy\"]\n"
                                  "[figures]\nlight = [\"pressure-gap\"]\n");
    write("mine/light/reference.csv",
          "quantity,value,unit,uncertainty,source,why\n"
          "epsilon,4.047,1,0.0005,A,\n"
          "gamma_slope,-70,1,0.5,A,it is a joke\n");
    write("mine/light/quick.set", "# less\n\nsurface.points=32\n");
    write("mine/heavy/case.toml", "base = \"../light/case.toml\"\n"
                                  "title = \"heavy\"\nfem = \"\"\n"
                                  "[load]\nnominal_pressure = \"0.1 E*\"\n");
  }

  bool has(const std::string& file) const { return fs::exists(folder / file); }
};

// All parts run, in the order of README.md, each in its own folder, and a
// published number that differs widely changes no exit code.
TEST_F(Collection, RunsEveryPartAndReportsOnAll) {
  const Ended done = run("run mine --methods theory --out there");

  ASSERT_EQ(done.exit_code, 0) << done.output;
  EXPECT_LT(done.output.find("light: small"), done.output.find("heavy: heavy"));
  for (const char* file : {"there/light/result.h5", "there/light/report.html",
                           "there/heavy/result.h5", "there/heavy/report.html"})
    EXPECT_TRUE(has(file)) << file;
  const std::string page = text_of(folder / "there/report.html");
  EXPECT_NE(page.find("<h1>My &lt;paper&gt;</h1>"), std::string::npos);
  EXPECT_NE(page.find(">reproduced</td>"), std::string::npos);
  EXPECT_NE(page.find("not reproducible: it is a joke"), std::string::npos);
  EXPECT_NE(page.find("<a href=\"heavy/report.html\">"), std::string::npos);
}

// A single part is treated as any case.
TEST_F(Collection, RunsASinglePart) {
  EXPECT_EQ(run("run mine/light --methods theory --no-report").exit_code, 0);

  EXPECT_TRUE(has("out/light/result.h5"));
}

// A mistake in the last part is found before the first runs.
TEST_F(Collection, ReadsEveryPartBeforeItRunsOne) {
  write("mine/heavy/reference.csv", "no table\n");

  const Ended refused = run("run mine");

  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_FALSE(has("out"));
}

// A figure that no report has is an error before anything runs.
TEST_F(Collection, RefusesAMisspeltFigure) {
  write("mine/collection.toml", "parts = [\"light\", \"heavy\"]\n"
                                "[figures]\nlight = [\"presure-gap\"]\n");

  const Ended refused = run("run mine");

  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.output.find("collection.toml:3"), std::string::npos)
      << refused.output;
  EXPECT_NE(refused.output.find("nearest: pressure-gap"), std::string::npos);
  EXPECT_FALSE(has("out"));
}

// quick.set is applied before --set, and results of a quick run state it.
TEST_F(Collection, RunsQuickly) {
  const Ended done =
      run("run mine --quick --methods halfspace --set surface.realizations=1");

  ASSERT_EQ(done.exit_code, 0) << done.output;
  const auto light = results::read_result(folder / "out/mine/light");
  EXPECT_EQ(light.case_title, "small (quick)");
  EXPECT_EQ(light.surfaces.at(0).grid.points_x, 32);
  EXPECT_EQ(light.surfaces.size(), 1U);
  EXPECT_EQ(results::read_result(folder / "out/mine/heavy").case_title,
            "heavy");
  EXPECT_NE(done.output.find("heavy: there is no quick.set"),
            std::string::npos);
  EXPECT_NE(text_of(folder / "out/mine/report.html").find("A quick run"),
            std::string::npos);
}

// After an interruption the finished parts are there and reported; --resume
// runs the rest, including the parts that had not begun.
TEST_F(Collection, ContinuesAfterAnInterruption) {
  const std::string long_run =
      "run mine --methods halfspace --set surface.points=256 ";
  const Ended stopped = interrupt(long_run, "out/mine/light/result.journal");

  ASSERT_EQ(stopped.exit_code, 130) << stopped.output;
  EXPECT_TRUE(has("out/mine/report.html"));
  EXPECT_FALSE(has("out/mine/heavy"));

  const Ended resumed = run(long_run + "--resume");

  EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
  for (const char* part : {"out/mine/light", "out/mine/heavy"})
    EXPECT_EQ(results::read_result(folder / part).status, "complete") << part;
}

TEST_F(Collection, AreListedWithTheirParts) {
  const std::string listed = run("list").output;

  EXPECT_NE(listed.find("\npaper  "), std::string::npos) << listed;
  EXPECT_NE(listed.find("\npaper/polymer  "), std::string::npos) << listed;
  EXPECT_NE(run("run paper/polymers")
                .output.find("nearest shipped case: paper/polymer"),
            std::string::npos);
}

} // namespace asperity::program::collection_test
