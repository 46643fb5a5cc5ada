// Tests of a run that is divided into parts: joined, they are the undivided
// run; nothing is lost by a kill; what is missing or foreign is named.
#include "results/result_reader.hpp"
#include "tests/program/program.hpp"
#include "tests/same_bits.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>

namespace asperity::program::parts_test {

namespace fs = std::filesystem;

const std::string swept_keys = R"([expect]
area_scale = { above = 0.1, below = 5, methods = ["halfspace"] }
[sweep]
"surface.hurst" = [0.5, 0.8]
"surface.points" = [32, 64]
)";

class Parts : public ProgramTest {
protected:
  Parts() {
    write("rough.toml", small_case);
    write("swept.toml", small_case + swept_keys);
  }

  /// Runs one part without a cache, and returns how it ended.
  Ended part(const std::string& name, const std::string& words,
             const std::string& more = "") const {
    return run("run " + name + " --no-cache --threads 2 --part " + words + " " +
               more);
  }

  void expect_good(const Ended& ended) const {
    EXPECT_EQ(ended.exit_code, 0) << ended.output;
  }

  void expect_refusal(const Ended& ended, const std::string& words) const {
    EXPECT_EQ(ended.exit_code, 2) << ended.output;
    EXPECT_NE(ended.output.find(words), std::string::npos) << ended.output;
  }

  /// The bytes of every file below a folder, by its path there, but for logs.
  std::map<std::string, std::string> files(const std::string& name) const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder / name))
      if (entry.is_regular_file() && entry.path().extension() != ".txt")
        all[fs::relative(entry.path(), folder / name).string()] =
            text_of(entry.path());
    return all;
  }

  static void expect_same_surface(const results::SurfaceRecord& one,
                                  const results::SurfaceRecord& other) {
    EXPECT_EQ(one.grid, other.grid);
    EXPECT_EQ(one.heights, other.heights);
    EXPECT_EQ(one.rms_slope, other.rms_slope);
    EXPECT_EQ(one.spectrum.size(), other.spectrum.size());
  }

  /// Every number of two results but times, surfaces and tables included.
  void expect_same_result(const fs::path& one, const fs::path& other) const {
    const results::Result a = results::read_result(folder / one);
    const results::Result b = results::read_result(folder / other);
    tests::expect_same_bits(a, b);
    for (std::size_t m = 0; m < a.methods.size(); ++m) {
      EXPECT_EQ(a.methods[m].description, b.methods[m].description);
      EXPECT_EQ(a.methods[m].realizations.size(),
                b.methods[m].realizations.size());
    }
    ASSERT_EQ(a.surfaces.size(), b.surfaces.size());
    for (std::size_t r = 0; r < a.surfaces.size(); ++r)
      expect_same_surface(a.surfaces[r], b.surfaces[r]);
    ASSERT_EQ(a.tables.size(), b.tables.size());
    for (std::size_t t = 0; t < a.tables.size(); ++t)
      for (std::size_t c = 0; c < a.tables[t].columns.size(); ++c)
        EXPECT_EQ(a.tables[t].columns[c].values, b.tables[t].columns[c].values)
            << a.tables[t].name;
  }
};

const std::string methods = "--methods theory,halfspace,fem ";

// One method has fewer realisations than the others, one part has no work for
// it, and tables follow from the maps of realisation 0.
TEST_F(Parts, OfRealisationsJoinToTheUndividedRun) {
  const std::string keys = methods + "--set surface.realizations=5 --set "
                                     "fem.realizations=2 --set "
                                     "report.stress_inside=true ";
  expect_good(run("run rough.toml --no-cache --out whole " + keys));
  for (const char* which : {"3/3", "1/3", "2/3"})
    expect_good(part("rough.toml", which, keys));

  expect_good(run("merge out/rough"));

  expect_same_result("out/rough", "whole");
  EXPECT_EQ(text_of(folder / "out/rough/curves.csv"),
            text_of(folder / "whole/curves.csv"));
  expect_good(run("diff out/rough whole --tolerance 0"));
  EXPECT_TRUE(fs::exists(folder / "out/rough/report.html"));
  EXPECT_FALSE(fs::exists(folder / "out/rough/parts/joined"));
}

TEST_F(Parts, OfASweepJoinToTheUndividedRun) {
  const std::string keys = "--methods theory,halfspace ";
  expect_good(run("run swept.toml --no-cache --out whole " + keys));
  for (const char* which : {"2/3", "1/3", "3/3"})
    expect_good(part("swept.toml", which, keys));

  expect_good(run("merge out/swept"));

  for (int i = 0; i < 4; ++i) {
    const std::string point = "points/00" + std::to_string(i);
    expect_same_result("out/swept/" + point, "whole/" + point);
  }
  for (const char* name : {"sweep.csv", "sweep.json"})
    EXPECT_EQ(text_of(folder / "out/swept" / name),
              text_of(folder / "whole" / name))
        << name;
  expect_good(run("check out/swept"));
}

// Quick settings, overrides with blanks and quotes, and the options of the
// methods reach the part and the merge.
TEST_F(Parts, KeepTheirOptions) {
  fs::create_directories(folder / "my case");
  write("my case/case.toml", small_case);
  write("my case/quick.set", "surface.points=32\n");
  const std::string words = "'my case' --quick --exactly --set \"title=it's\" "
                            "--methods halfspace --out 'an out' --no-cache ";
  expect_good(run("run " + words + "--part 1/2"));
  expect_refusal(run("merge 'an out'"),
                 "--part 2/2: parts/2-of-2 has no result.h5");
  expect_good(run("run " + words + "--part 2/2"));

  expect_good(run("merge 'an out' --no-report"));
  const results::Result merged = results::read_result(folder / "an out");
  EXPECT_EQ(merged.case_title.substr(0, 4), "it's");
  EXPECT_EQ(merged.surfaces.at(1).grid.points_x, 32);
  EXPECT_EQ(merged.methods.size(), 1U);
}

TEST_F(Parts, AreMergedTwiceToTheSameFiles) {
  for (const auto& [name, more] :
       {std::pair<std::string, std::string>{"rough", ""},
        {"swept", " --no-report"}}) {
    for (const char* which : {"1/2", "2/2"})
      expect_good(part(name + ".toml", which, "--methods theory,halfspace"));
    expect_good(run("merge out/" + name + more));
    const auto once = files("out/" + name);

    expect_good(run("merge out/" + name + more));

    const auto twice = files("out/" + name);
    ASSERT_EQ(once.size(), twice.size());
    for (const auto& [path, bytes] : once)
      EXPECT_TRUE(twice.at(path) == bytes) << path;
  }
}

TEST_F(Parts, ThatAreCompleteAreNotRunAgain) {
  expect_good(part("rough.toml", "2/2", "--methods halfspace"));
  expect_good(part("swept.toml", "2/2", "--methods halfspace"));
  const auto before = std::pair(files("out/rough"), files("out/swept"));

  const Ended of_case = part("rough.toml", "2/2", "--methods halfspace");
  const Ended of_sweep = part("swept.toml", "2/2", "--methods halfspace");

  for (const Ended& again : {of_case, of_sweep}) {
    expect_good(again);
    EXPECT_NE(again.output.find("is complete already"), std::string::npos);
  }
  EXPECT_TRUE(std::pair(files("out/rough"), files("out/swept")) == before);
}

// A killed part loses at most the steps in progress, the merge refuses it, and
// the same command continues it.
TEST_F(Parts, ResumeAfterAKill) {
  const std::string keys =
      "--methods halfspace --no-report --set surface.points=384 ";
  expect_good(run("run rough.toml --no-cache --out whole " + keys));
  expect_good(part("rough.toml", "1/2", keys));
  write("kill.sh", "\"$@\" &\n"
                   "until grep -q ' 1/4 ' log.txt || ! kill -0 $! 2>&-; do\n"
                   "  sleep 0.01\ndone\nkill -KILL $!; wait $!\n");
  const Ended killed =
      run("run rough.toml --no-cache --part 2/2 " + keys, "sh kill.sh");
  ASSERT_EQ(killed.exit_code, 137) << killed.output;
  const Ended refused = run("merge out/rough");
  expect_refusal(refused, "1 of 2 parts is missing or incomplete");
  expect_refusal(refused, "--part 2/2: parts/2-of-2 is running and has ");

  expect_good(part("rough.toml", "2/2", keys));

  expect_good(run("merge out/rough --no-report"));
  expect_same_result("out/rough", "whole");
}

TEST_F(Parts, ThatAreMissingAreNamed) {
  expect_good(part("swept.toml", "3/4", "--methods halfspace"));

  const Ended refused = run("merge out/swept");

  expect_refusal(refused, "out/swept: 3 of 4 points are missing or incomplete");
  expect_refusal(refused, "point 003 (surface.hurst = 0.8, surface.points = "
                          "64): has not run yet");
  EXPECT_FALSE(fs::exists(folder / "out/swept/sweep.csv"));
  expect_refusal(run("merge out"), "out: has no parts; asperity run CASE");
  expect_refusal(run("merge nowhere"), "nowhere: there is no such folder");
  EXPECT_FALSE(fs::exists(folder / "nowhere"));
}

TEST_F(Parts, OfAnotherCaseAreRefused) {
  const std::string one = "--methods halfspace --no-report ";
  expect_good(part("rough.toml", "1/2", one));
  for (const std::string other : {"--set surface.seed=4", "--methods fem"}) {
    expect_good(part("rough.toml", "2/2", one + other));
    expect_refusal(run("merge out/rough"), "is of another case, of other");
  }

  expect_good(part("rough.toml", "2/2", one));
  write("rough.toml", small_case + "# changed\n");
  expect_good(part("rough.toml", "1/2", one));
  expect_refusal(run("merge out/rough"), "is of another case, of other");
  expect_good(part("rough.toml", "2/2", one)); // of the same numbers
  expect_good(run("merge out/rough --no-report"));
  fs::remove(folder / "out/rough/result.h5");

  expect_good(part("rough.toml", "1/1", one));
  expect_refusal(run("merge out/rough"), "; remove the folders that are not");
  fs::remove_all(folder / "out/rough/parts/1-of-1");
  fs::copy_file(folder / "out/rough/parts/1-of-2/result.h5",
                folder / "out/rough/parts/2-of-2/result.h5",
                fs::copy_options::overwrite_existing);
  expect_refusal(run("merge out/rough"), "has 0 of 4 load steps");
  EXPECT_FALSE(fs::exists(folder / "out/rough/result.h5"));
}

// Points of a sweep whose text has changed are computed again.
TEST_F(Parts, OfASweepThatHasChangedAreOfOneText) {
  for (const std::string more : {"", "# changed\n"}) {
    write("swept.toml", small_case + swept_keys + more);
    for (const char* which : {"1/2", "2/2"})
      expect_good(part("swept.toml", which, "--methods theory"));
    expect_good(run("merge out/swept --no-report"));
  }
}

TEST_F(Parts, RefuseWhatCannotBeDivided) {
  expect_refusal(part("rough.toml", "3/2"), "--part 3/2: must be I/N");
  expect_refusal(part("rough.toml", "half"), "1 <= I <= N, for example 3/8");
  expect_refusal(part("rough.toml", "1/3"), "must lie between 1 and 2");
  expect_refusal(part("swept.toml", "5/5"), "swept has 4 points");
  expect_refusal(part("rough.toml swept.toml", "1/2"), "name one case");
  expect_refusal(part("paper", "1/2"), "name one case");
  EXPECT_NE(part("rough.toml", "1/2", "--target-error 1%").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "out"));
}

// With --json, standard output is one JSON text.
TEST_F(Parts, AnswerInJson) {
  for (const char* words :
       {"run rough.toml --methods halfspace,theory --part 1/2 --json --quiet",
        "run rough.toml --methods halfspace,theory --part 2/2 --json --quiet",
        "merge out/rough --no-report --json --quiet",
        "plan rough.toml --slurm --time 10 --json --quiet"}) {
    const Ended ended = run(words);
    EXPECT_TRUE(nlohmann::json::accept(ended.output)) << words << ended.output;
  }
}

// An older result in the folder is replaced, as by a run.
TEST_F(Parts, ReplaceThePreviousResult) {
  expect_good(run("run rough.toml --methods theory --no-report"));
  for (const char* which : {"1/2", "2/2"})
    expect_good(part("rough.toml", which, "--methods halfspace"));

  expect_good(run("merge out/rough --no-report"));

  EXPECT_EQ(results::read_result(folder / "out/rough").methods.at(0).name,
            "halfspace");
}

} // namespace asperity::program::parts_test
