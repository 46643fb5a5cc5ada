#pragma once

// Holds the outcomes of a run: the number of instances in the bins of each axis
// by outcome, and what is written of them.

#include "suite/robustness/instance.hpp"
#include "suite/robustness/instance_report.hpp"
#include "suite/robustness/locking.hpp"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace asperity::robustness {

/// Number of instances in one bin by outcome.
struct Counts {
  std::array<int, n_outcomes> by_outcome{};

  int of(Outcome outcome) const {
    return by_outcome[static_cast<std::size_t>(outcome)];
  }

  int all() const;
  int others() const; ///< neither verified nor refused
};

/// Counts of metamorphic pairs of one kind.
struct RelationCounts {
  int pairs = 0;
  int same_bits = 0;
  /// Largest difference of mean gaps, in units of the tolerance [1]
  double largest_difference = 0.0;
};

/// An instance and its outcome.
struct InstanceResult {
  Instance instance;
  InstanceReport report;
};

class Matrix {
public:
  void add(const InstanceResult& result);

  const Counts& total() const { return total_; }

  double seconds() const { return seconds_; } ///< CPU time of all instances

  /// Returns the counts of one bin; zeros if there are none.
  Counts of(const std::string& axis, const std::string& label) const;

  const std::map<std::string, RelationCounts>& relations() const {
    return relations_;
  }

  /// Instances neither verified nor refused, in the order in which they were
  /// added.
  const std::vector<InstanceResult>& others() const { return others_; }

private:
  Counts total_;
  std::map<std::pair<std::string, std::string>, Counts> bins_;
  std::map<std::string, RelationCounts> relations_;
  std::vector<InstanceResult> others_;
  double seconds_ = 0.0;
};

/// Description of the run itself.
struct RunDescription {
  std::string rerun;   ///< "asperity robustness --seed 1", without --instance
  std::string commit;  ///< commit of the program
  std::string machine; ///< processor and number of cores
  double wall_seconds = 0.0;
  std::uint64_t seed = 0;
};

/// Return the header line and the line of an instance.
std::string csv_header();
std::string csv_line(const InstanceResult& result);

/// Returns the counts, the metamorphic pairs, locking and all instances with
/// other outcomes.
std::string json_of(const Matrix& matrix, const RunDescription& run,
                    const std::vector<LockingRow>& locking);

/// Returns the outcomes of each family, the metamorphic pairs and the instances
/// with other outcomes with the commands that run them again.
std::string text_of(const Matrix& matrix, const RunDescription& run);

} // namespace asperity::robustness
