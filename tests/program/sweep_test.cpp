// Tests of running a sweep: an ordinary result per point, the same numbers as
// the single case, nothing lost by a kill, every point checked.
#include "results/result_reader.hpp"
#include "tests/program/program.hpp"
#include "tests/same_bits.hpp"

#include <nlohmann/json.hpp>

namespace asperity::program::sweep_test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string swept = R"([expect]
area_scale = { above = 0.1, below = 5, methods = ["halfspace"] }
[sweep]
"surface.hurst" = [0.5, 0.8]
"surface.seed" = [3, 4]
)";

class SweepRuns : public ProgramTest {
protected:
  SweepRuns() { write("rough.toml", small_case + swept); }

  Json sweep_json() const {
    return Json::parse(text_of(folder / "out/rough/sweep.json"));
  }

  std::string point(int i) const {
    return (folder / "out/rough/points/00").string() + std::to_string(i);
  }
};

const std::string small_run = "run rough.toml --methods halfspace,theory ";

TEST_F(SweepRuns, WritesOneReportOnAllPoints) {
  const Ended done = run(small_run);

  ASSERT_EQ(done.exit_code, 0) << done.output;
  EXPECT_NE(done.output.find("4 of 4 expectations are met"), std::string::npos)
      << done.output;
  const Json sweep = sweep_json();
  EXPECT_EQ(sweep["points"].size(), 4U);
  EXPECT_EQ(sweep["points"][3]["label"],
            "surface.hurst = 0.8, surface.seed = 4");
  for (const Json& one : sweep["points"]) {
    EXPECT_EQ(one["status"], "complete");
    EXPECT_TRUE(one["methods"]["halfspace"]["area_scale"]["value"].is_number());
  }
  const std::string table = text_of(folder / "out/rough/sweep.csv");
  EXPECT_NE(table.find("\n2,0.8,3,complete,halfspace,area_scale,"),
            std::string::npos);
  const std::string page = text_of(folder / "out/rough/report.html");
  for (const char* words : {"sweep-pressure-gap-halfspace", "sweep-area-scale",
                            "sweep-map-halfspace-area-scale"})
    EXPECT_TRUE(fs::exists(folder / "out/rough/figures" /
                           (std::string(words) + ".svg")))
        << words;
  EXPECT_NE(page.find("All expectations are met at 4 points."),
            std::string::npos);
  for (const char* name :
       {"sweep-pressure-gap-halfspace", "sweep-area-scale"}) // explorable
    EXPECT_NE(page.find(std::string("{\"name\":\"") + name), std::string::npos)
        << name;
  EXPECT_NE(page.find("Content-Security-Policy"), std::string::npos);
}

// A point is an ordinary case: --set gives the same bits, and its folder is a
// result like any other.
TEST_F(SweepRuns, HasTheNumbersOfEachPointAlone) {
  ASSERT_EQ(run(small_run + "--no-cache").exit_code, 0);
  ASSERT_EQ(run(small_run + "--no-cache --no-report --set sweep= --set "
                            "surface.hurst=0.8 --out alone")
                .exit_code,
            0);

  tests::expect_same_bits(results::read_result(point(2)),
                          results::read_result(folder / "alone"));
  EXPECT_EQ(run("report " + point(2)).exit_code, 0);
  EXPECT_EQ(run("check " + point(2)).exit_code, 0);
}

// A kill at any moment loses no finished point, and --resume computes only what
// is missing.
TEST_F(SweepRuns, ResumesAfterAKill) {
  run(small_run + "--no-cache --threads 1 --set surface.points=128",
      "timeout -s KILL 1.2");
  const Ended resumed = run(small_run + "--no-cache --threads 1 --resume --set "
                                        "surface.points=128");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
  const auto written = fs::last_write_time(point(0) + "/result.h5");

  const Ended again = run(small_run + "--no-cache --threads 1 --resume --set "
                                      "surface.points=128");

  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(fs::last_write_time(point(0) + "/result.h5"), written);
  EXPECT_NE(again.output.find("4/4"), std::string::npos) << again.output;
  EXPECT_NE(again.output.find("is complete already"), std::string::npos);
  const Json points = sweep_json()["points"];
  ASSERT_EQ(points.size(), 4U);
  for (const Json& one : points)
    EXPECT_EQ(one["status"], "complete");
}

// A point whose case has changed is computed again by --resume; the others are
// kept.
TEST_F(SweepRuns, ResumesWithOtherValues) {
  ASSERT_EQ(run(small_run + "--no-report").exit_code, 0);

  const Ended more = run(small_run + "--resume --no-report --set "
                                     "sweep.\"surface.seed\"=[3,5]");

  EXPECT_EQ(more.exit_code, 0) << more.output;
  EXPECT_NE(more.output.find("seed = 3  is complete already"),
            std::string::npos)
      << more.output;
  EXPECT_EQ(more.output.find("seed = 5  is complete already"),
            std::string::npos);
}

// Seeds are samples whose mean is stated, unless each has several realisations,
// the first of which would stand for all.
TEST_F(SweepRuns, StatesNoMeanOfFirstRealisations) {
  write("seeds.toml", small_case + "[sweep]\n\"surface.seed\" = [3, 4]\n");
  for (const std::string count : {"1", "2"}) {
    const Ended ended = run("run seeds.toml --methods halfspace --set "
                            "surface.realizations=" +
                            count + " --out seeds" + count);
    ASSERT_EQ(ended.exit_code, 0) << ended.output;
    EXPECT_EQ(fs::exists(folder / ("seeds" + count) / "loads.csv"),
              count == "1");
    EXPECT_EQ(ended.output.find("mean and standard deviation of one map") !=
                  std::string::npos,
              count == "1")
        << ended.output;
  }
}

// A sweep replaces the last one when all of its points are complete.
TEST_F(SweepRuns, ReplacesThePreviousSweep) {
  ASSERT_EQ(run(small_run).exit_code, 0);
  const std::string before = text_of(point(0) + "/result.h5");
  const std::string page = text_of(folder / "out/rough/report.html");
  const std::string large = small_run +
                            "--no-cache --no-report --threads 1 --set "
                            "surface.points=128 ";

  EXPECT_EQ(
      interrupt(large, "out/rough/.new-run/points/001/result.h5").exit_code,
      130);
  EXPECT_TRUE(text_of(point(0) + "/result.h5") == before);
  EXPECT_TRUE(text_of(folder / "out/rough/report.html") == page);

  const Ended resumed = run(large + "--resume");
  EXPECT_EQ(resumed.exit_code, 0);
  EXPECT_NE(resumed.output.find("is complete already"), std::string::npos);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(results::read_result(point(i) + "/result.h5")
                  .surfaces.at(0)
                  .grid.points_x,
              128);
  EXPECT_FALSE(fs::exists(folder / "out/rough/report.html"));
  EXPECT_FALSE(fs::exists(folder / "out/rough/.new-run"));
}

// Ctrl-C ends all points in order; the report states what is missing.
TEST_F(SweepRuns, IsInterruptedInOrder) {
  const Ended ended =
      interrupt(small_run + "--no-cache --threads 1 --set surface.points=128",
                "out/rough/points/001/result.h5");

  EXPECT_EQ(ended.exit_code, 130) << ended.output;
  EXPECT_NE(ended.output.find("continue with --resume"), std::string::npos);
  EXPECT_EQ(sweep_json()["points"][0]["status"], "complete");
  EXPECT_EQ(sweep_json()["points"][3]["status"], "missing");
  EXPECT_NE(text_of(folder / "out/rough/report.html").find("are not complete"),
            std::string::npos);
}

// `check` checks every point, of a case and of a folder.
TEST_F(SweepRuns, IsCheckedAtEveryPoint) {
  write(
      "rough.toml",
      small_case +
          "[expect]\narea_scale = { above = 0.1, methods = [\"halfspace\"] }\n"
          "[sweep]\n\"surface.hurst\" = [0.5, 0.8]\n"
          "\"expect.area_scale.below\" = [5, 0.2]\nfem = [\"\"]\n");
  const Ended refused = run("check rough.toml");
  EXPECT_EQ(refused.exit_code, 2) << refused.output; // fem is not a key

  write(
      "rough.toml",
      small_case +
          "[expect]\narea_scale = { above = 0.1, methods = [\"halfspace\"] }\n"
          "[sweep]\ncombine = \"zip\"\n\"surface.hurst\" = [0.5, 0.8]\n"
          "\"expect.area_scale.below\" = [5, 0.2]\n");
  const Ended checked =
      run("check rough.toml --methods theory,halfspace --junit found.xml");
  EXPECT_EQ(checked.exit_code, 1) << checked.output;
  EXPECT_NE(checked.output.find("rough, point 001"), std::string::npos)
      << checked.output;
  EXPECT_NE(checked.output.find("failed     halfspace      area_scale"),
            std::string::npos);
  EXPECT_NE(text_of(folder / "found.xml").find("failures=\"1\""),
            std::string::npos);
  EXPECT_EQ(run("check out/rough").exit_code, 1);
}

// A dry run names the points and writes nothing.
TEST_F(SweepRuns, IsPlanned) {
  const Ended planned = run(small_run + "--dry-run");

  EXPECT_EQ(planned.exit_code, 0);
  EXPECT_NE(planned.output.find("surface.hurst = 0.8, surface.seed = 3"),
            std::string::npos);
  EXPECT_NE(planned.output.find("4 points, "), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "out"));
}

// Options for a single case are refused, and a point that does not fit into
// memory is named; nothing is written.
TEST_F(SweepRuns, RefusesBeforeItRuns) {
  EXPECT_EQ(run("problem rough.toml").exit_code, 2);
  EXPECT_EQ(run("bench rough.toml").exit_code, 2);
  EXPECT_EQ(run("run rough.toml --target-error 1%").exit_code, 2);
  const Ended large = run("run rough.toml --methods halfspace --set "
                          "sweep.\"surface.points\"=[64,65536]");

  EXPECT_EQ(large.exit_code, 2) << large.output;
  EXPECT_NE(large.output.find("surface.points = 65536"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "out/rough"));
}

// A damaged sweep.json or point is reported.
TEST_F(SweepRuns, ReadsDamagedFiles) {
  ASSERT_EQ(run(small_run + "--no-report").exit_code, 0);
  std::ofstream(point(1) + "/result.h5") << "no result";
  fs::copy_file(point(0) + "/result.h5", point(2) + "/result.h5",
                fs::copy_options::overwrite_existing);

  EXPECT_EQ(run("report out/rough").exit_code, 0);
  EXPECT_EQ(sweep_json()["points"][1]["status"], "missing");
  EXPECT_NE(text_of(folder / "out/rough/report.html").find("of another case"),
            std::string::npos);
  std::ofstream(folder / "out/rough/sweep.json") << "{}";
  EXPECT_EQ(run("report out/rough").exit_code, 2);
}

} // namespace asperity::program::sweep_test
