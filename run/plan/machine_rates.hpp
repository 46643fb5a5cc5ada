#pragma once

// Measures by a short probe how fast this machine performs the two dominant
// operations of a contact run.

#include "base/grid.hpp"

#include <map>
#include <utility>

namespace asperity::run {

/// CPU times of one thread. A probe takes about ten iterations on the requested
/// grid and is made once per grid.
class MachineRates {
public:
  /// @param largest_probe  largest probed number of points per side [1] >= 16.
  ///                       The time of a larger grid is extrapolated as
  ///                       n log n, which is up to a factor of two too small if
  ///                       the larger grid exceeds a processor cache.
  explicit MachineRates(int largest_probe);

  /// Returns the time of a Fourier transform and its inverse [s].
  double transform_time(const Grid& grid);

  /// Returns the total time of one iteration of the contact solver [s].
  double iteration_time(const Grid& grid);

  /// Returns the relative run time: the time of a 256 x 256 transform on this
  /// machine over that on the reference machine, on which the constants of
  /// cost_model.cpp were measured [1].
  double relative_time();

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

} // namespace asperity::run
