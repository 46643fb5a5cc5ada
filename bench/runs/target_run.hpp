#pragma once

// asperity run --target-error: the case at the cheapest setting predicted to
// keep an error, and in its result whether it did.

#include <filesystem>
#include <string>
#include <vector>

#include "bench/runs/target_error.hpp"

namespace asperity::app {

class TargetRun {
public:
  /// Runs the coarse grids and chooses; says what on standard output.
  /// @param contact_case  of that file with those overrides
  /// @param folder        of the case's result; the search works below it
  TargetRun(const cases::Case& contact_case, std::filesystem::path file,
            std::vector<std::string> overrides,
            const std::filesystem::path& folder, double target);

  bool is_chosen() const { return outcome_.problem.empty(); }

  /// The case with the chosen settings laid over it, as --set would.
  cases::Case chosen_case() const;

  /// Holds the result of that case against the exact solution or one finer run
  /// a method.
  /// @return  true if every promise held
  bool verify(const cases::Case& chosen, const std::filesystem::path& folder);

  /// After a promise was broken: true if another setting is predicted to keep
  /// the error, which is then that of chosen_case().
  bool choose_again();

  /// Says what was promised and found, and writes both into the result.
  void record(const std::filesystem::path& folder) const;

private:
  void print_choice() const;

  std::filesystem::path file_;
  std::vector<std::string> overrides_;
  std::vector<std::string> lengths_; ///< in node spacings, kept in metres: the
                                     ///< chosen grid has the case's surface
  TargetSearch search_;
  reports::TargetOutcome outcome_;
};

} // namespace asperity::app
