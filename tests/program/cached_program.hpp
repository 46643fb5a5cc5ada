#pragma once

// The program on a small case with a cache, and what its runs say of the cache.

#include "tests/program/program.hpp"
#include "tests/same_bits.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace asperity::program {

using results::Result;

// The theory once, half-space and fem on two realisations, four loads each.
inline constexpr int all_steps = 4 + 2 * 4 + 2 * 4;

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
    const Ended done = run("run small.toml --no-report " + arguments);
    EXPECT_EQ(done.exit_code, 0) << done.output;
    return computed(done);
  }
};

} // namespace asperity::program
