#pragma once

// The random numbers from which an instance is made: one stream for each of its
// axes, so that an axis that is added later changes no other.

#include "surfaces/maps/random_modes.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>

namespace asperity::robustness {

/// Counters of the random number streams of the axes. They define the meaning
/// of a seed and are never renumbered.
enum class Stream {
  family = 1,
  shape,
  law,
  control,
  far_boundary,
  program,
  relation,
  flaw,
  points,
  length,
  hurst,
  roll_off,
  shortest_wave,
  rms_slope,
  contact_modulus,
  poisson_ratio,
  thickness,
  growth,
  penalty,
  load,
  gamma,
  degree,
  coating_stiffness,
  coating_thickness,
  path,
  threads,
  later_flaw,
  boundaries,
  sides,
  linear_solver,
  modulus_ratio,
  mesh,
  counter,
  counter_radius,
  counter_stiffness,
  adhesion,
  grid_number,
  adhesive_law,
  spring,
};

/// The random numbers of one instance.
class Draw {
public:
  Draw(std::uint64_t seed, int index)
      : key_{seed, 0, surfaces::RandomStream::robustness_instances},
        index_(index) {}

  double uniform(Stream axis, double low, double high) const {
    return low + (high - low) * pair(axis).first;
  }

  double log_uniform(Stream axis, double low, double high) const {
    return std::exp(uniform(axis, std::log(low), std::log(high)));
  }

  /// Uses the second, independent number of an axis as a fair coin.
  bool coin(Stream axis) const { return pair(axis).second < 0.5; }

  template <class Value>
  Value pick(Stream axis, std::initializer_list<Value> values) const {
    const auto count = static_cast<double>(values.size());
    return values.begin()[static_cast<std::size_t>(uniform(axis, 0.0, count))];
  }

  /// Returns one of the values with a probability proportional to its weight.
  template <class Value>
  Value
  weigh(Stream axis,
        std::initializer_list<std::pair<Value, double>> weighted_values) const {
    double sum = 0.0;
    for (const auto& [value, weight] : weighted_values)
      sum += weight;
    double left = uniform(axis, 0.0, sum);
    for (const auto& [value, weight] : weighted_values)
      if ((left -= weight) < 0.0)
        return value;
    return weighted_values.begin()->first;
  }

private:
  surfaces::UniformPair pair(Stream axis) const {
    return surfaces::draw_mode(key_, index_, static_cast<int>(axis));
  }

  surfaces::RandomKey key_;
  int index_;
};

} // namespace asperity::robustness
