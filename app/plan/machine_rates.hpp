#pragma once

// How fast this machine is at the two things a contact run is made of, by a
// short probe.

#include "base/grid.hpp"

#include <map>
#include <utility>

namespace asperity::app {

/// CPU times of one thread. A probe takes some ten iterations on the grid
/// asked for and is made once a grid.
class MachineRates {
public:
  /// @param largest_probe  points a side [1] >= 16; a larger grid is taken
  ///        from one of that size by n log n, which a cache that overflows
  ///        makes up to twice too small
  explicit MachineRates(int largest_probe);

  /// Of a transform and its inverse [s].
  double transform_time(const Grid& grid);

  /// Of the contact solver, all that it does in one iteration [s].
  double iteration_time(const Grid& grid);

  /// Time here over time on the reference machine, on which the constants of
  /// cost_model.cpp were measured, for a transform of 256 x 256.
  double slowness();

private:
  struct Times {
    double transform = 0.0;
    double iteration = 0.0;
  };

  Times times(const Grid& grid);
  static Times probe(int points_x, int points_y);

  int largest_probe_;
  std::map<std::pair<int, int>, Times> known_;
};

} // namespace asperity::app
