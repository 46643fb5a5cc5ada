#include "run/tally.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace asperity::run {

void Tally::add_kept(const std::string& thing, const KeptWork& work) {
  const std::lock_guard lock(mutex_);
  KeptWork& sum = kept_[thing];
  sum.steps += work.steps;
  sum.cpu_time += work.cpu_time;
}

std::map<std::string, KeptWork> Tally::kept() const {
  const std::lock_guard lock(mutex_);
  return kept_;
}

int Tally::kept_steps() const {
  int steps = 0;
  for (const auto& [thing, work] : kept())
    steps += work.steps;
  return steps;
}

std::vector<results::Skipped> Tally::failures() const {
  const std::lock_guard lock(mutex_);
  return failures_;
}

void Tally::add_failure(const std::string& what, const std::string& why) {
  const std::lock_guard lock(mutex_);
  failures_.push_back({what, "failed: " + why});
  if (is_told_)
    fmt::print(stderr, "not computed: {}: {}\n", what, why);
}

} // namespace asperity::run
