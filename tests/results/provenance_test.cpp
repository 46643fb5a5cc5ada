// Claims about results/provenance.hpp: the facts are there and are of this run.
#include "results/provenance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <regex>

namespace asperity::results {
namespace {

std::string fact(const Provenance& facts, const std::string& name) {
  const auto found =
      std::find_if(facts.begin(), facts.end(),
                   [&](const auto& entry) { return entry.first == name; });
  return found == facts.end() ? "" : found->second;
}

TEST(ProgramFacts, SayWhatMadeTheResult) {
  const Provenance facts = program_facts();

  EXPECT_TRUE(std::regex_match(fact(facts, "commit"),
                               std::regex("unknown|[0-9a-f]{12}")))
      << fact(facts, "commit");
  EXPECT_TRUE(
      std::regex_match(fact(facts, "dirty"), std::regex("yes|no|unknown")));
  EXPECT_EQ(fact(facts, "commit") == "unknown",
            fact(facts, "dirty") == "unknown");
  EXPECT_EQ(fact(facts, "FFTW").substr(0, 4), "fftw");
  EXPECT_TRUE(
      std::regex_match(fact(facts, "HDF5"), std::regex("1\\.[0-9]+\\.[0-9]+")));
  for (const char* name : {"program", "compiler", "build type", "Boost", "fmt",
                           "toml11", "processor", "cores", "memory", "system"})
    EXPECT_NE(fact(facts, name), "") << name;
}

TEST(UtcNow, IsIso8601) {
  EXPECT_TRUE(std::regex_match(
      utc_now(), std::regex("20[0-9]{2}-[01][0-9]-[0-3][0-9]T[0-2][0-9]:[0-5]"
                            "[0-9]:[0-6][0-9]Z")));
}

// Claim: the CPU time is the process's own, so work raises it.
TEST(RunClock, CountsWorkAndMemory) {
  const RunClock clock;
  const double before = std::atof(fact(clock.facts(), "CPU time").c_str());
  volatile double sum = 0.0;
  for (int i = 0; i < 50'000'000; ++i)
    sum = sum + 1.0;

  const Provenance after = clock.facts();

  EXPECT_GT(std::atof(fact(after, "CPU time").c_str()), before);
  EXPECT_GT(std::atof(fact(after, "wall time").c_str()), 0.0);
  EXPECT_GT(std::atof(fact(after, "peak memory").c_str()), 1.0);
}

} // namespace
} // namespace asperity::results
