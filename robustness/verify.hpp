#pragma once

// The checks that an answer must pass, each by itself and none of them the
// solver's own. Owns their tolerances.

#include "contact/solvers/solver.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace asperity::robustness {

/// A check that failed, by name, and what it found.
struct Failure {
  std::string check;  ///< "complementarity"
  std::string detail; ///< found and allowed, with units
};

/// C pressure without its mean [m].
using Displace = std::function<void(std::span<const double> pressure,
                                    std::span<double> displacement)>;

/// What was asked of the answers.
struct AskedContact {
  std::span<const double> heights;    ///< [m]
  std::span<const double> weights;    ///< of nodes, mean 1; empty: equal
  double local_compliance = 0.0;      ///< c [m/Pa]
  double gap_tolerance = 0.0;         ///< of the solver [m]
  double long_wave_compliance = 0.0;  ///< the largest C(q) [m/Pa]
  double short_wave_compliance = 0.0; ///< the smallest [m/Pa]
  /// Of the mean pressure [1]: rounding of a sum for an operator's solver.
  double load_tolerance = 1e-12;
};

/// The rounding of a gap [m]: 64 eps of the largest of the terms it is made of,
/// the transform of the pressure taken at the longest wave's compliance, and
/// N/8 eps more of the depth c p, which is summed over N nodes.
double gap_rounding(const AskedContact& asked,
                    const contact::ContactSolution& solution);

/// finite            no field holds NaN or infinity
/// pressure sign     p >= 0
/// apart             p = 0 at a mean gap above the highest node
/// balance           the mean pressure is the load (or the mean gap the gap)
/// gap field         gap = mean gap + C p - h about its mean, C p taken anew
/// overlap           gap + c p >= -tolerance everywhere
/// complementarity   |gap + c p| <= tolerance where p > 0
///
/// The tolerance is the solver's and the rounding above.
/// @return  the first that fails; empty if all hold
std::optional<Failure> verify_step(const AskedContact& asked,
                                   const contact::LoadTarget& target,
                                   const contact::ContactSolution& solution,
                                   const Displace& displace);

/// An answer reduced to what pairs of them are compared by.
struct StepSummary {
  double nominal_pressure = 0.0; ///< [Pa]
  double mean_gap = 0.0;         ///< [m]
  double energy = 0.0;   ///< of block and springs per nominal area [J/m^2]
  double area = 0.0;     ///< counted contact area [1]
  double marginal = 0.0; ///< share of nodes whose contact the tolerance decides
  double tolerance = 0.0; ///< of a gap, rounding included [m]
};

StepSummary summary_of(const AskedContact& asked,
                       const contact::ContactSolution& solution);

/// Of two answers a, b with p_a <= p_b:
///
/// monotone gap   u_b <= u_a
/// monotone area  A_b >= A_a
/// energy         p_a (u_a - u_b) <= U_b - U_a <= p_b (u_a - u_b)
///
/// The last is p = -dU/du between them: U(u) is convex, so its chord lies
/// between its slopes, whatever the increment. An answer to the tolerance t is
/// exact for heights that differ by t at most; hence 2 t for a gap, 4 p_b t and
/// the rounding of U for an energy, and for the area the nodes with less
/// pressure than t takes to lift.
/// @return  the first that fails; empty if all hold
std::optional<Failure> verify_pair(const StepSummary& first,
                                   const StepSummary& second);

/// Of two answers to one load, before and after a cycle or in two unit
/// systems: gaps differ by 2 t, energies by 4 p t. Lengths of the second are
/// `length_ratio` times those of the first, pressures `pressure_ratio` times.
std::optional<Failure> verify_same(const StepSummary& first,
                                   const StepSummary& second,
                                   double length_ratio = 1.0,
                                   double pressure_ratio = 1.0);

} // namespace asperity::robustness
