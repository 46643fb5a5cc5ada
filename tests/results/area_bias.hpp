#pragma once

// Measurements and output of the program that determines the bias of the
// contact area. Owns the operators, the estimators and the tables.

#include "contact/solvers/load_sequence.hpp"
#include "results/observables/area_estimate.hpp"

#include <array>
#include <compare>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace asperity::area_bias {

inline constexpr int waves = 16; ///< shortest waves in the side
inline constexpr int coarsest = 2;
inline constexpr int finest = 64; ///< nodes in the shortest wave
inline constexpr std::array loads{0.01, 0.03, 0.1, 0.3, 1.0}; ///< p/(E* h')

/// An elastic operator on the grid with E* = 1 Pa and a thickness of one side.
struct Kernel {
  std::string name;
  std::function<std::unique_ptr<contact::SurfaceOperator>(const Grid&)> make;
  results::AreaCoefficients coefficients; ///< the program's own
  double penalty = 0.0;                   ///< k [E*/h], 0: hard
  int finest = 32;                        ///< r up to which it is used
};

/// The half-space first; it gives the limit.
std::vector<Kernel> all_kernels();

/// The results of one solution.
struct Sample {
  double counted = 0.0;   ///< A/A_0 by counting nodes
  double lines = 0.0;     ///< (A.3)
  double corrected = 0.0; ///< (A.5), with the program's coefficients
  double fitted = 0.0;    ///< by (21) for the distribution of pressures
  double perimeter = 0.0; ///< S_d h
  double euler = 0.0;     ///< chi h^2/A_0
  double mean_gap = 0.0;  ///< in h_rms
};

Sample measure(const Grid& grid, const contact::ContactSolution& solution,
               double rms_height,
               const results::AreaCoefficients& coefficients);

struct Place {
  std::string kernel;
  int r = 0;
  std::size_t load = 0;
  int surface = 0;

  friend auto operator<=>(const Place&, const Place&) = default;
};

using Samples = std::map<Place, Sample>;

/// The limit at one load on one surface.
struct Limit {
  double area = 0.0;
  double mean_gap = 0.0; ///< in h_rms
};

using Limits = std::map<std::pair<std::size_t, int>, Limit>; ///< load, surface

Limits find_limits(const Samples& samples, int n_surfaces);

/// Prints the difference of two more extrapolations of the half-space from the
/// limit: Richardson's for the lines and for the count, over the two finest
/// grids.
void print_limit_doubt(const Samples& samples, const Limits& limits);

/// Prints c of the corrected count, and c and e of (A.5), by least squares on
/// the relative error at all loads and surfaces, r = 8 to 32.
void print_calibration(const Kernel& kernel, const Samples& samples,
                       const Limits& limits);

/// Prints the relative error of each estimator, with one row per r and one
/// column per load.
void print_areas(const Kernel& kernel, const Samples& samples,
                 const Limits& limits);

/// Prints the error of the mean gap in h_rms, and of gamma, the slope
/// du/d ln p between the first and the third load.
void print_gaps(const Kernel& kernel, const Samples& samples,
                const Limits& limits);

} // namespace asperity::area_bias
