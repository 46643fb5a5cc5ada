#pragma once

// The contact of an elastic surface and a rigid counter-surface: the
// complementarity problem, which has one surface operator, and its solution.

#include "contact/operators/surface_operator.hpp"
#include "mechanics/loading.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace asperity::contact {

/// Find the pressure p and the separation u with
///
///     gap = u + (C p)(x) - h(x)
///     p >= 0,  gap + c p >= 0,  p (gap + c p) = 0     at every node
///
/// c = 1/k is the compliance of a linear penalty (p = k times penetration);
/// c = 0 is hard contact. With a hardness H, the pressure is bounded,
///
///     0 <= p <= H,  gap + c p >= 0 where p < H,  <= 0 where p > 0,
///
/// and where p = H the gap may be negative: the depth of a plastic imprint. The
/// methods of solver.hpp project onto these pressures:
/// mechanics::surface_solver_of() refuses other laws.
struct ContactProblem {
  std::span<const double> heights; ///< h [m], elasticity.n_nodes() values
  double local_compliance = 0.0;   ///< c = 1/k [m/Pa] >= 0
  /// Largest accepted gap at nodes in contact and largest accepted overlap
  /// outside the contact [m] > 0. The remaining work p |gap| is then below p_0
  /// times this value.
  double gap_tolerance = 0.0;
  int max_iterations = 2000;
  double hardness = std::numeric_limits<double>::infinity(); ///< H [Pa] > 0

  bool has_hardness() const { return std::isfinite(hardness); }
};

struct ContactSolution {
  std::vector<double> pressure;     ///< p [Pa], >= 0 without adhesion
  std::vector<double> gap;          ///< [m]; -c p where in contact; where
                                    ///< p = H minus the depth of the imprint
  std::vector<double> displacement; ///< C p [m], see SurfaceOperator
  /// What was reached of what was prescribed: mean of p [Pa], of the gap [m].
  double nominal_pressure = 0.0;
  double mean_gap = 0.0;
  double load_tolerance = 0.0; ///< accepted error of the load, if one is [Pa]
  double gap_error = 0.0;      ///< largest violation, see gap_tolerance [m]
  int iterations = 0;          ///< iterations on this grid, or on tiles of it
  int transforms = 0; ///< applications of C or its inverse on this grid
  bool converged = false;
  /// With adhesion: the smallest eigenvalue of the Hessian of the energy per
  /// area on the nodes with an open gap [Pa/m], up to 10 %; > 0 at a minimum.
  double smallest_stiffness = std::numeric_limits<double>::quiet_NaN();
  /// With a hardness along a path: the mean depth of the imprint [m], this
  /// step's included.
  double mean_imprint = std::numeric_limits<double>::quiet_NaN();
  bool is_detached = false; ///< with adhesion: a tensile load parted the faces
  /// With adhesion along a path, if the faces part or come together in this
  /// step: nominal pressure [Pa] and mean gap [m] of the last state before.
  double jump_pressure = std::numeric_limits<double>::quiet_NaN();
  double jump_gap = std::numeric_limits<double>::quiet_NaN();
  std::string note; ///< describes unusual events; empty if there were none
};

} // namespace asperity::contact
