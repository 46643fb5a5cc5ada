#pragma once

// The matrix: how many scenes of each axis' bins ended in which way.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "robustness/scene.hpp"
#include "robustness/scene_report.hpp"

namespace asperity::robustness {

/// Scenes of one cell by outcome.
struct Counts {
  std::array<int, n_outcomes> by_outcome{};

  void add(Outcome outcome) { ++by_outcome[static_cast<std::size_t>(outcome)]; }

  int of(Outcome outcome) const {
    return by_outcome[static_cast<std::size_t>(outcome)];
  }

  int all() const;
  int others() const; ///< neither verified nor refused
};

/// Twins of one kind.
struct TwinCounts {
  int pairs = 0;
  int same_bits = 0;
  double largest_difference = 0.0; ///< of mean gaps, over the tolerance [1]
};

/// A scene and how it ended.
struct SceneResult {
  Scene scene;
  SceneReport report;
};

class Matrix {
public:
  void add(const SceneResult& result);

  const Counts& total() const { return total_; }

  int sound_but_refused() const { return sound_but_refused_; }

  double seconds() const { return seconds_; } ///< CPU time of all scenes

  /// Scenes of one bin; zeros if there are none.
  Counts of(const std::string& axis, const std::string& label) const;

  /// Scenes in two bins at once; either order.
  Counts of(const std::string& axis, const std::string& label,
            const std::string& other_axis,
            const std::string& other_label) const;

  const std::map<Twin, TwinCounts>& twins() const { return twins_; }

  /// Neither verified nor refused, in the order they were added.
  const std::vector<SceneResult>& others() const { return others_; }

  /// Verified scenes that took the most iterations, most first; ten at most.
  const std::vector<SceneResult>& slowest() const { return slowest_; }

private:
  void keep_if_slow(const SceneResult& result);

  Counts total_;
  std::map<std::pair<std::string, std::string>, Counts> pairs_;
  std::map<Twin, TwinCounts> twins_;
  std::vector<SceneResult> others_;
  std::vector<SceneResult> slowest_;
  int sound_but_refused_ = 0;
  double seconds_ = 0.0;
};

} // namespace asperity::robustness
