// Verifies that a run that is killed at any moments and resumed ends with the
// result of an uninterrupted one, bit for bit, with a cache and without.
#include "base/child_process.hpp"
#include "results/result_reader.hpp"
#include "results/types/method_columns.hpp"
#include "tests/program/program.hpp"
#include "tests/same_bits.hpp"

#include <algorithm>
#include <random>
#include <vector>

namespace asperity::program::resume_test {

class Resume : public ProgramTest {
protected:
  Resume() { write("small.toml", small_case); }

  ChildCommand command(const std::string& out, bool has_cache) const {
    ChildCommand command{{ASPERITY_PROGRAM, "run", "small.toml", "--out", out,
                          "--no-report", "--resume", "--threads", "2",
                          "--methods", methods_},
                         folder,
                         folder / (out + ".log")};
    command.environment.push_back("ASPERITY_CACHE=" +
                                  (folder / ("cache-" + out)).string());
    if (!has_cache)
      command.words.emplace_back("--no-cache");
    return command;
  }

  /// Compares the result of a run that was killed `kills_in_a_row` times with
  /// that of a run without interruption; `n_rows` times, each from nothing. The
  /// last run of a row is left alone, so that the number of runs is bounded on
  /// any machine, however slow it becomes.
  ///
  /// @return  how many runs were killed; the others ended before
  int kill_and_resume(int n_rows, int kills_in_a_row, bool has_cache,
                      double longest_life) {
    std::mt19937 random(has_cache ? 5 : 6);
    std::uniform_real_distribution<double> life(0.0, longest_life);
    const std::string out = has_cache ? "cached" : "alone";
    int n_killed = 0;
    for (int row = 0; row < n_rows; ++row) {
      for (int run = 0; run < kills_in_a_row; ++run) {
        ChildProcess child(command(out, has_cache));
        if (child.has_ended(life(random))) {
          EXPECT_EQ(child.end().exit_code, 0);
          continue;
        }
        child.kill();
        child.wait();
        ++n_killed;
      }
      const ChildEnd end = run_child(command(out, has_cache)).end;
      EXPECT_EQ(end.exit_code, 0) << text_of(folder / (out + ".log"));
      if (end.exit_code != 0)
        return n_killed;
      tests::expect_same_bits(whole_, results::read_result(folder / out));
      std::filesystem::remove_all(folder / out);
      std::filesystem::remove_all(folder / ("cache-" + out));
    }
    return n_killed;
  }

  /// Kills runs of these methods in rows of three, with a cache and without.
  void expect_same_bits_after(int n_rows, const std::string& methods) {
    methods_ = methods;
    const Ended whole = run("run small.toml --no-cache --no-report --methods " +
                            methods + " --out whole");
    ASSERT_EQ(whole.exit_code, 0) << whole.output;
    whole_ = results::read_result(folder / "whole");
    const ChildEnd timed = run_child(command("timed-" + methods, false)).end;
    EXPECT_GT(kill_and_resume(n_rows, 3, true, timed.wall_time), 0);
    EXPECT_GT(kill_and_resume(n_rows, 3, false, timed.wall_time), 0);
  }

  std::string methods_;
  results::Result whole_;
};

TEST_F(Resume, KillsAtAnyMomentChangeNoBit) {
  expect_same_bits_after(4, "theory,halfspace");
  expect_same_bits_after(1, "fem"); // loads deal.II, half a second each time
}

// A block that flows depends on the steps before. A run of it that is killed
// after a step goes on from the plastic strain that the cache has; where that
// file is cut off, the step is computed again.
TEST_F(Resume, ABlockThatFlowsGoesOnFromItsPlasticStrain) {
  namespace fs = std::filesystem;
  write("small.toml", imprint_case(6));
  methods_ = "fem";
  ASSERT_EQ(run("run small.toml --no-cache --no-report --methods fem --out "
                "whole")
                .exit_code,
            0);
  whole_ = results::read_result(folder / "whole");
  ASSERT_GT(whole_.methods.front()
                .realizations.front()
                .points.back()[columns::plastic_work],
            0.0);
  const auto states = [&] {
    std::vector<fs::path> found;
    if (fs::exists(folder / "cache-killed"))
      for (const auto& entry : fs::directory_iterator(folder / "cache-killed"))
        if (entry.path().extension() == ".state")
          found.push_back(entry.path());
    return found;
  };
  for (const bool is_cut_off : {false, true}) {
    ChildProcess child(command("killed", true));
    while (states().empty() && !child.has_ended(0.005)) {
    }
    child.kill();
    child.wait();
    ASSERT_FALSE(states().empty());
    if (is_cut_off)
      for (const fs::path& state : states())
        fs::resize_file(state, fs::file_size(state) / 2);
    ASSERT_EQ(run_child(command("killed", true)).end.exit_code, 0);
    const std::string said = text_of(folder / "killed.log");
    EXPECT_EQ(said.find("computed again") != std::string::npos, is_cut_off)
        << said;
    tests::expect_same_bits(whole_, results::read_result(folder / "killed"));
    fs::remove_all(folder / "killed");
    fs::remove_all(folder / "cache-killed");
  }
}

// Where the state after a step is lost, the steps before it are computed again;
// a cold start would give another solution in the last digits.
TEST_F(Resume, ALostStateIsComputedAgain) {
  namespace fs = std::filesystem;
  const std::string run_it = "run small.toml --methods halfspace --no-report ";
  ASSERT_EQ(run(run_it + "--no-cache --out whole").exit_code, 0);
  ASSERT_EQ(run(run_it + "--out first").exit_code, 0);
  std::vector<std::pair<fs::file_time_type, fs::path>> steps;
  int n_states = 0;
  for (const auto& entry : fs::directory_iterator(folder / "cache"))
    if (entry.path().extension() == ".step")
      steps.emplace_back(entry.last_write_time(), entry.path());
    else if (entry.path().extension() == ".state")
      n_states += fs::remove(entry.path());
  ASSERT_EQ(n_states, 2); // one per realisation
  fs::remove(std::max_element(steps.begin(), steps.end())->second);

  const Ended done = run(run_it + "--out second");

  ASSERT_EQ(done.exit_code, 0) << done.output;
  EXPECT_NE(done.output.find("steps 0 to 2 are computed again"),
            std::string::npos)
      << done.output;
  tests::expect_same_bits(results::read_result(folder / "whole"),
                          results::read_result(folder / "second"));
}

} // namespace asperity::program::resume_test
