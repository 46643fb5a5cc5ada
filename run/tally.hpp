#pragma once

// What the jobs of a run count: steps that were computed, read from the cache
// or failed, and evaluations that failed.

#include "results/types/result.hpp"

#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace asperity::run {

/// The work that the cache saved for one method.
struct KeptWork {
  int steps = 0;
  double cpu_time = 0.0; ///< steps and set-up [s]
};

/// Counters that the jobs update while they run.
class Tally {
public:
  /// @param is_told  whether failures are printed
  explicit Tally(bool is_told = true) : is_told_(is_told) {}

  std::atomic<int> computed_steps = 0;
  std::atomic<int> failed_steps = 0; ///< not converged
  /// Computed again only for the state of the solver after them.
  std::atomic<int> repeated_steps = 0;
  std::atomic<bool> uses_fem = false;

  /// @param thing  name of a method or a table
  void add_kept(const std::string& thing, const KeptWork& work);
  std::map<std::string, KeptWork> kept() const;
  int kept_steps() const;

  /// Returns the result of `compute`, or nothing if it throws. The failed
  /// evaluation of a solved case does not end the run; it is listed with the
  /// skipped work.
  template <class Compute>
  auto attempt(const std::string& what, Compute compute)
      -> std::optional<decltype(compute())> {
    try {
      return compute();
    } catch (const std::exception& error) {
      add_failure(what, error.what());
      return std::nullopt;
    }
  }

  std::vector<results::Skipped> failures() const;

private:
  void add_failure(const std::string& what, const std::string& why);

  bool is_told_;
  mutable std::mutex mutex_;
  std::map<std::string, KeptWork> kept_;
  std::vector<results::Skipped> failures_;
};

} // namespace asperity::run
