// Tests of the program with a cache: a second run, a killed one, two at once.
// The numbers must not depend on the cache.
#include "base/content_hash.hpp"

#include <cstdio>
#include <future>
#include <map>

#include "tests/app/program.hpp"
#include "tests/app/same_bits.hpp"

namespace asperity::app {
namespace {

using results::Result;

// The theory once, half-space and fem on two realisations, four loads each.
constexpr int all_steps = 4 + 2 * 4 + 2 * 4;

class CachedProgram : public ProgramTest {
protected:
  CachedProgram() { write("small.toml", small_case); }

  Result result(const std::string& name) const {
    return results::read_result(folder / name);
  }

  /// The number of steps that a run reports as computed; -1 if it reports none.
  static int computed(const Ended& run) {
    int steps = -1;
    int computed = -1;
    int kept = -1;
    const std::size_t words = run.output.find(" steps: ");
    const std::size_t start =
        words == std::string::npos ? 0 : run.output.rfind('\n', words) + 1;
    if (std::sscanf(run.output.c_str() + start,
                    "%d steps: %d computed, %d from the cache", &steps,
                    &computed, &kept) != 3)
      return -1;
    EXPECT_EQ(steps, computed + kept);
    return computed;
  }

  int computed(const std::string& arguments) const {
    const Ended done = run("run small.toml " + arguments);
    EXPECT_EQ(done.exit_code, 0) << done.output;
    return computed(done);
  }
};

TEST_F(CachedProgram, UnchangedIsReadAndNotComputed) {
  EXPECT_EQ(computed("--out first"), all_steps);

  EXPECT_EQ(computed("--out second"), 0);

  expect_same_bits(result("first"), result("second"), true);
  EXPECT_EQ(result("second").status, "complete");
}

// The steps that a killed run finished are read and the rest is computed; the
// result is the same bit for bit. The run is killed at several moments, so that
// some fall within a step.
TEST_F(CachedProgram, AKilledRunReusesItsSteps) {
  const std::string long_run = "run small.toml --set surface.points=256 "
                               "--methods halfspace --threads 1 ";
  ASSERT_EQ(run(long_run + "--no-cache --out whole").exit_code, 0);
  for (const char* seconds : {"0.3", "0.5", "0.8"})
    run(long_run + "--out killed", std::string("timeout -s KILL ") + seconds);

  const Ended done = run(long_run + "--out killed");

  ASSERT_EQ(done.exit_code, 0) << done.output;
  EXPECT_LT(computed(done), 2 * 4) << done.output;
  expect_same_bits(result("whole"), result("killed"));
}

TEST_F(CachedProgram, TwoRunsAtOnceAgree) {
  computed("--no-cache --out whole");
  const std::string other = "cd " + folder.string() +
                            " && ASPERITY_CACHE=cache " ASPERITY_PROGRAM
                            " run small.toml --out two > two.txt 2>&1";
  auto two = std::async(std::launch::async,
                        [&] { return std::system(other.c_str()); });
  const Ended one = run("run small.toml --out one");

  ASSERT_EQ(one.exit_code, 0) << one.output;
  ASSERT_EQ(two.get(), 0) << text_of(folder / "two.txt");
  expect_same_bits(result("whole"), result("one"));
  expect_same_bits(result("whole"), result("two"));
}

// The operator of a Q2 grid is read where only the surface is new, and its
// set-up is still counted with its cost.
TEST_F(CachedProgram, AQ2OperatorIsBuiltOnce) {
  const std::string q2 = "--methods fem --set fem.element=Q2 "
                         "--set surface.realizations=1 ";
  computed(q2 + "--out first");

  EXPECT_EQ(computed(q2 + "--set surface.seed=4 --out second"), 4);
  computed(q2 + "--set surface.seed=4 --no-cache --out whole");

  expect_same_bits(result("whole"), result("second"));
  const double built =
      result("first").methods.at(0).realizations.at(0).setup_cpu_time;
  EXPECT_GT(result("second").methods.at(0).realizations.at(0).setup_cpu_time,
            0.2 * built);
}

TEST_F(CachedProgram, TheCacheIsShownAndCleared) {
  computed("");
  const Ended shown = run("cache");
  EXPECT_EQ(shown.exit_code, 0);
  EXPECT_NE(shown.output.find(" entries, "), std::string::npos);
  EXPECT_EQ(shown.output.find("\n0 entries"), std::string::npos);

  const Ended cleared = run("cache --clear");

  EXPECT_NE(cleared.output.find("\n0 entries"), std::string::npos);
  EXPECT_EQ(computed("--out again"), all_steps);
}

bool is_kept(const Ended& run) {
  return run.output.find(" is up to date") != std::string::npos;
}

// The second run writes nothing, and answers as the first one did, by text and
// exit code, also where an expectation is not met.
TEST_F(CachedProgram, AnUnchangedFolderIsKept) {
  write("small.toml",
        small_case +
            "[expect]\nkappa = { above = 1e9, methods = [\"fem\"] }\n");
  const Ended first = run("run small.toml --out o");
  ASSERT_EQ(first.exit_code, 1) << first.output;
  const auto written = std::filesystem::last_write_time(folder / "o/result.h5");

  const Ended second = run("run small.toml --out o");

  EXPECT_TRUE(is_kept(second)) << second.output;
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_EQ(std::filesystem::last_write_time(folder / "o/result.h5"), written);
  EXPECT_FALSE(std::filesystem::exists(folder / "o/result.previous.h5"));
  const std::size_t findings = first.output.find("kappa ");
  ASSERT_NE(findings, std::string::npos);
  EXPECT_NE(second.output.find(first.output.substr(findings)),
            std::string::npos)
      << second.output;
}

/// The bytes of all files under a folder by their relative paths.
std::map<std::string, std::string> files_in(const std::filesystem::path& top) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(top))
    if (entry.is_regular_file())
      files[std::filesystem::relative(entry.path(), top).string()] =
          text_of(entry.path());
  return files;
}

bool is_restored(const Ended& run) {
  return run.output.find(" from the cache, with the report") !=
         std::string::npos;
}

// A deleted folder comes back byte for byte, with findings and exit code, and
// the figures are those that a run without the cache draws.
TEST_F(CachedProgram, ADeletedFolderIsRestored) {
  write("small.toml",
        small_case +
            "[expect]\nkappa = { above = 1e9, methods = [\"fem\"] }\n");
  const Ended first = run("run small.toml --out o");
  ASSERT_EQ(first.exit_code, 1) << first.output;
  const auto written = files_in(folder / "o");
  std::filesystem::remove_all(folder / "o");

  const Ended second = run("run small.toml --out o");

  EXPECT_TRUE(is_restored(second)) << second.output;
  EXPECT_EQ(computed(second), 0);
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_TRUE(files_in(folder / "o") == written);
  const std::size_t findings = first.output.find("kappa ");
  ASSERT_NE(findings, std::string::npos);
  EXPECT_NE(second.output.find(first.output.substr(findings)),
            std::string::npos)
      << second.output;
  ASSERT_EQ(run("run small.toml --no-cache --out whole").exit_code, 1);
  int figures = 0;
  for (const auto& [file, bytes] : files_in(folder / "whole"))
    if (file.starts_with("figures/") && !file.starts_with("figures/cost")) {
      EXPECT_TRUE(written.at(file) == bytes) << file;
      ++figures;
    }
  EXPECT_GT(figures, 0);
}

// The folder of another run is not mixed with the files that are restored, and
// a file that the cache has lost is drawn or written again.
TEST_F(CachedProgram, ARestoredFolderIsWhole) {
  const std::string theory = "run small.toml --methods theory --out ";
  ASSERT_EQ(run(theory + "o").exit_code, 0);
  const auto written = files_in(folder / "o");
  ASSERT_EQ(run("run small.toml --set report.fields=2 --out p").exit_code, 0);

  EXPECT_TRUE(is_restored(run(theory + "p")));

  auto other = files_in(folder / "p");
  EXPECT_EQ(other.erase("result.previous.h5"), 1U);
  EXPECT_TRUE(other == written);

  ASSERT_TRUE(std::filesystem::remove(
      folder / "cache" / (content_hash(written.at("report.html")) + ".file")));
  const Ended again = run(theory + "q");
  EXPECT_FALSE(is_restored(again)) << again.output;
  EXPECT_EQ(computed(again), 0);
  EXPECT_EQ(again.exit_code, 0);
}

// An output that is larger than a tenth of the cache would displace the steps
// of other cases. Here the limit is 150 kB and the page alone is larger than a
// tenth of it.
TEST_F(CachedProgram, ALargeOutputIsNotSaved) {
  const std::string limited = "ASPERITY_CACHE_SIZE=150kB";
  const std::string theory = "run small.toml --methods theory --out ";
  ASSERT_EQ(run(theory + "o", limited).exit_code, 0);
  ASSERT_GT(std::filesystem::file_size(folder / "o/report.html"), 15000U);

  const Ended again = run(theory + "p", limited);

  EXPECT_FALSE(is_restored(again)) << again.output;
  EXPECT_EQ(computed(again), 0);
}

// Whatever the files of the folder depend on, or a file itself, changes.
TEST_F(CachedProgram, AChangeIsNoticed) {
  const std::string again = "run small.toml --methods theory --out o";
  const auto expect_run = [&](const std::string& change,
                              const std::string& arguments = "") {
    const Ended changed = run(again + arguments);
    EXPECT_EQ(changed.exit_code, 0) << changed.output;
    EXPECT_FALSE(is_kept(changed)) << change;
    EXPECT_EQ(computed(changed), arguments == " --no-cache" ? 4 : 0) << change;
    EXPECT_TRUE(is_kept(run(again)) || !arguments.empty()) << change;
  };
  ASSERT_EQ(run(again).exit_code, 0);
  ASSERT_TRUE(is_kept(run(again)));

  std::filesystem::remove(folder / "o/curves.csv");
  expect_run("a table was deleted");
  write("o/report.html", "<html>");
  expect_run("the report was overwritten");
  write("o/output.json", "{");
  expect_run("the list of files is damaged");
  std::string titled = small_case;
  titled.replace(titled.find("small"), 5, "other");
  write("small.toml", titled);
  expect_run("the title");
  expect_run("options", " --no-report");
  expect_run("everything is computed", " --no-cache");
}

TEST_F(CachedProgram, AnInterruptedRunIsNotKept) {
  const std::string arguments =
      "run small.toml --set surface.points=512 --methods halfspace --out o";
  ASSERT_EQ(interrupt(arguments, "o/result.journal").exit_code, 130);
  EXPECT_FALSE(std::filesystem::exists(folder / "o/output.json"));

  const Ended again = run(arguments);

  EXPECT_FALSE(is_kept(again)) << again.output;
  EXPECT_EQ(again.exit_code, 0) << again.output;
}

} // namespace
} // namespace asperity::app
