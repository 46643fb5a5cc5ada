#pragma once

// The checks that a solution must pass. Each is separate, and none of them is
// the convergence criterion of the solver. The file owns their tolerances.

#include "contact/solvers/contact_problem.hpp"
#include "results/observables/observables.hpp"
#include "results/types/result.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace asperity::robustness {

/// The name of a failed check and its finding.
struct Failure {
  std::string check;  ///< "complementarity"
  std::string detail; ///< found and allowed values, with units
};

/// Evaluates C pressure without its mean [m].
using Displace = std::function<void(std::span<const double> pressure,
                                    std::span<double> displacement)>;

/// The contact problem that was posed.
struct AskedContact {
  std::span<const double> heights;    ///< [m]
  std::span<const double> weights;    ///< nodal weights, mean 1; empty: equal
  double local_compliance = 0.0;      ///< c [m/Pa]
  double gap_tolerance = 0.0;         ///< of the solver [m]
  double long_wave_compliance = 0.0;  ///< largest C(q) [m/Pa]
  double short_wave_compliance = 0.0; ///< smallest C(q) [m/Pa]
  /// Relative to the mean pressure [1]. The default is the rounding of a sum,
  /// for solvers based on a surface operator.
  double load_tolerance = 1e-12;
  /// The exact answer may lose nodes under increasing load, as a bent plate or
  /// elements that lock do.
  bool may_lose_contact = false;
  results::Border border = results::Border::periodic;
};

/// Returns the rounding of a gap [m]: 64 eps times the sum of the largest
/// magnitudes of its terms, where the displacement C p is bounded by the
/// compliance of the longest wave, plus N/8 eps times the penetration c p,
/// which is summed over N nodes.
double gap_rounding(const AskedContact& asked,
                    const contact::ContactSolution& solution);

/// Returns what the gaps of two solutions, or a gap and 0, may differ by [m]:
/// the tolerance of the solver, with a margin, plus the rounding.
double allowed_gap(const AskedContact& asked,
                   const contact::ContactSolution& solution);

/// Verifies one step by the following checks, in this order:
///
/// finite            no field contains NaN or infinity
/// pressure sign     p >= 0
/// apart             p = 0 at a mean gap above the highest node
/// balance           the mean pressure is the load (or the mean gap the gap)
/// gap field         gap = mean gap + C p - h about its mean, C p recomputed
/// overlap           gap + c p >= -tolerance everywhere
/// complementarity   |gap + c p| <= tolerance where p > 0
///
/// The tolerance is that of the solver plus the rounding above.
/// @return  the first check that fails; empty if all pass
std::optional<Failure> verify_step(const AskedContact& asked,
                                   const mechanics::LoadTarget& target,
                                   const contact::ContactSolution& solution,
                                   const Displace& displace);

/// The last two of these checks.
std::optional<Failure> verify_contact(const AskedContact& asked,
                                      const contact::ContactSolution& solution);

/// Verifies that every observable of a row exists and lies in its range: areas
/// in 0..1 (those that are fitted may be NaN, not determined), perimeters and
/// energies >= 0; and that it has converged.
std::optional<Failure> verify_row(const results::CurvePoint& row);

/// Verifies the certificate of a solution: from the tolerance t of the solver
/// it follows that the duality gap is at most 2 p_0 t.
/// @param elasticity  C
/// @return  the failure "certificate"; empty if it holds or if p = 0
std::optional<Failure>
verify_certificate(const AskedContact& asked,
                   const contact::ContactSolution& solution,
                   contact::SurfaceOperator& elasticity);

/// The quantities of a solution by which pairs of solutions are compared.
struct StepSummary {
  double nominal_pressure = 0.0; ///< [Pa]
  double mean_gap = 0.0;         ///< [m]
  /// Of the undeformed mean planes [m]; on a periodic surface the mean gap.
  double separation = 0.0;
  /// Energy of block and interface springs per nominal area [J/m^2]
  double energy = 0.0;
  double area = 0.0; ///< counted contact area [1]
  /// Share of nodes whose contact state depends on the tolerance.
  double marginal = 0.0;
  double tolerance = 0.0;        ///< tolerance of a gap, including rounding [m]
  bool may_lose_contact = false; ///< see AskedContact
};

StepSummary summary_of(const AskedContact& asked,
                       const contact::ContactSolution& solution);

/// Verifies, for two solutions a, b with p_a <= p_b:
///
/// monotone gap   u_b <= u_a, with the separation u
/// monotone area  A_b >= A_a, unless contact may be lost
/// energy         p_a (u_a - u_b) <= U_b - U_a <= p_b (u_a - u_b)
///
/// The last check is the integral of p = -dU/du between them: U(u) is convex,
/// so that its chord lies between its slopes for any increment. A solution with
/// tolerance t is exact for heights that differ by at most t; hence 2 t for a
/// gap, 4 p_b t plus the rounding of U for an energy, and for the area the
/// nodes whose pressure is less than that needed to lift them by t.
/// @return  the first check that fails; empty if all pass
std::optional<Failure> verify_pair(const StepSummary& first,
                                   const StepSummary& second);

/// Verifies two solutions for one load, before and after a cycle or in two unit
/// systems: gaps may differ by 2 t, energies by 4 p t. Lengths of the second
/// are `length_ratio` times those of the first, pressures `pressure_ratio`
/// times.
std::optional<Failure> verify_same(const StepSummary& first,
                                   const StepSummary& second,
                                   double length_ratio = 1.0,
                                   double pressure_ratio = 1.0);

} // namespace asperity::robustness
