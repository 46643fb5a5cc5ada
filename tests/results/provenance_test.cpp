// Tests of results/provenance.hpp: the facts are complete and belong to this
// run.
#include "results/provenance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string>
#include <string_view>

namespace asperity::results::provenance_test {

std::string fact(const Provenance& facts, const std::string& name) {
  const auto found =
      std::find_if(facts.begin(), facts.end(),
                   [&](const auto& entry) { return entry.first == name; });
  return found == facts.end() ? "" : found->second;
}

/// True if `text` has the shape: '9' stands for a digit, 'x' for a hexadecimal
/// one, anything else for itself.
bool has_shape(std::string_view text, std::string_view shape) {
  return std::equal(text.begin(), text.end(), shape.begin(), shape.end(),
                    [](unsigned char letter, char expected) {
                      if (expected == '9')
                        return std::isdigit(letter) != 0;
                      if (expected == 'x')
                        return std::isxdigit(letter) != 0;
                      return letter == static_cast<unsigned char>(expected);
                    });
}

TEST(ProgramFacts, RecordTheProvenance) {
  const Provenance facts = program_facts();

  const std::string commit = fact(facts, "commit");
  EXPECT_TRUE(commit == "unknown" || has_shape(commit, "xxxxxxxxxxxx"))
      << commit;
  const std::string dirty = fact(facts, "dirty");
  EXPECT_TRUE(dirty == "unknown" || dirty == "yes" || dirty == "no") << dirty;
  EXPECT_EQ(commit == "unknown", dirty == "unknown");
  EXPECT_EQ(fact(facts, "FFTW").substr(0, 4), "fftw");
  EXPECT_EQ(fact(facts, "HDF5").substr(0, 2), "1.");
  for (const char* name : {"program", "compiler", "build type", "Boost", "fmt",
                           "toml11", "processor", "cores", "memory", "system"})
    EXPECT_NE(fact(facts, name), "") << name;
}

TEST(UtcNow, IsIso8601) {
  EXPECT_TRUE(has_shape(utc_now(), "2099-99-99T99:99:99Z"));
}

// The CPU time is the process's own, so work raises it.
TEST(RunClock, CountsWorkAndGivesMemory) {
  const RunClock clock;
  const double before =
      std::atof(fact(clock.facts(3.0 * (1 << 20)), "CPU time").c_str());
  volatile double sum = 0.0;
  for (int i = 0; i < 50'000'000; ++i)
    sum = sum + 1.0;

  const Provenance after = clock.facts(3.0 * (1 << 20));

  EXPECT_GT(std::atof(fact(after, "CPU time").c_str()), before);
  EXPECT_GT(std::atof(fact(after, "wall time").c_str()), 0.0);
  EXPECT_EQ(fact(after, "peak memory"), "3 MiB");
}

} // namespace asperity::results::provenance_test
