#pragma once

// asperity run --target-error runs the case at the cheapest setting that is
// predicted to meet an error target, and records in its result whether it does.

#include "suite/bench/runs/target_error.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::bench {

class TargetRun {
public:
  /// Runs the coarse grids, chooses a setting and prints it on standard output.
  /// @param contact_case  the case in `file` with `overrides` applied
  /// @param folder        folder of the case's result; the search writes below
  ///     it
  TargetRun(const cases::Case& contact_case, std::filesystem::path file,
            std::vector<std::string> overrides,
            const std::filesystem::path& folder, double target);

  bool is_chosen() const { return outcome_.problem.empty(); }

  /// Returns the case with the chosen settings applied, as --set would.
  cases::Case chosen_case() const;

  /// Compares the result of that case with the exact solution or with one finer
  /// run per method.
  /// @return  true if every quantity meets the target
  bool verify(const cases::Case& chosen, const std::filesystem::path& folder);

  /// To be called after a missed target: true if another setting is predicted
  /// to meet the target, which is then that of chosen_case().
  bool choose_again();

  /// Prints the predicted and the measured errors and writes both into the
  /// result.
  void record(const std::filesystem::path& folder) const;

private:
  void print_choice() const;

  std::filesystem::path file_;
  std::vector<std::string> overrides_;
  /// Lengths in node spacings, fixed in metres, so that the chosen grid
  /// represents the surface of the case.
  std::vector<std::string> lengths_;
  TargetSearch search_;
  TargetOutcome outcome_;
};

} // namespace asperity::bench
