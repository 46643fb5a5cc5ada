// Tests of the program with a cache: a second run, a killed one, two at once.
// The numbers must not depend on the cache.
#include "tests/program/cached_program.hpp"

#include <cstdio>
#include <future>

namespace asperity::program::cache_program_test {

// The steps that a killed run finished are read and the rest is computed; the
// result is the same bit for bit. The run is killed at several moments, so that
// some fall within a step.
TEST_F(CachedProgram, AKilledRunReusesItsSteps) {
  const std::string long_run = "run small.toml --set surface.points=256 "
                               "--methods halfspace --no-report --threads 1 ";
  ASSERT_EQ(run(long_run + "--no-cache --out whole").exit_code, 0);
  for (const char* seconds : {"0.3", "0.5", "0.8"})
    run(long_run + "--out killed", std::string("timeout -s KILL ") + seconds);

  const Ended done = run(long_run + "--out killed");

  ASSERT_EQ(done.exit_code, 0) << done.output;
  EXPECT_LT(computed(done), 2 * 4) << done.output;
  tests::expect_same_bits(result("whole"), result("killed"));
}

TEST_F(CachedProgram, TwoRunsAtOnceAgree) {
  computed("--no-cache --out whole");
  const std::string other =
      "cd " + folder.string() +
      " && ASPERITY_CACHE=cache " ASPERITY_PROGRAM
      " run small.toml --no-report --out two > two.txt 2>&1";
  auto two = std::async(std::launch::async,
                        [&] { return std::system(other.c_str()); });
  const Ended one = run("run small.toml --no-report --out one");

  ASSERT_EQ(one.exit_code, 0) << one.output;
  ASSERT_EQ(two.get(), 0) << text_of(folder / "two.txt");
  tests::expect_same_bits(result("whole"), result("one"));
  tests::expect_same_bits(result("whole"), result("two"));
}

// The operator of a Q2 grid is read where only the surface is new, and its
// set-up is still counted with its cost.
TEST_F(CachedProgram, AQ2OperatorIsBuiltOnce) {
  const std::string q2 = "--methods fem --set fem.element=Q2 "
                         "--set surface.realizations=1 ";
  computed(q2 + "--out first");

  EXPECT_EQ(computed(q2 + "--set surface.seed=4 --out second"), 4);
  computed(q2 + "--set surface.seed=4 --no-cache --out whole");

  tests::expect_same_bits(result("whole"), result("second"));
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

} // namespace asperity::program::cache_program_test
