#pragma once

// Holds the outcome matrix: the number of instances in the bins of each axis by
// outcome.

#include "robustness/instance.hpp"
#include "robustness/instance_report.hpp"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace asperity::robustness {

/// Number of instances in one cell by outcome.
struct Counts {
  std::array<int, n_outcomes> by_outcome{};

  void add(Outcome outcome) { ++by_outcome[static_cast<std::size_t>(outcome)]; }

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

  int sound_but_refused() const { return sound_but_refused_; }

  double seconds() const { return seconds_; } ///< CPU time of all instances

  /// Returns the counts of one bin; zeros if there are none.
  Counts of(const std::string& axis, const std::string& label) const;

  /// Returns the counts of instances in two bins at once; the order is
  /// irrelevant.
  Counts of(const std::string& axis, const std::string& label,
            const std::string& other_axis,
            const std::string& other_label) const;

  const std::map<MetamorphicRelation, RelationCounts>& relations() const {
    return relations_;
  }

  /// Instances neither verified nor refused, in the order in which they were
  /// added.
  const std::vector<InstanceResult>& others() const { return others_; }

  /// The verified instances with the most iterations, in descending order; at
  /// most ten.
  const std::vector<InstanceResult>& slowest() const { return slowest_; }

private:
  void keep_if_slow(const InstanceResult& result);

  Counts total_;
  std::map<std::pair<std::string, std::string>, Counts> pairs_;
  std::map<MetamorphicRelation, RelationCounts> relations_;
  std::vector<InstanceResult> others_;
  std::vector<InstanceResult> slowest_;
  int sound_but_refused_ = 0;
  double seconds_ = 0.0;
};

} // namespace asperity::robustness
