#pragma once

// Bounds on the errors of a pressure field that any program may have computed.
// The certificate: its numbers follow from heights, operator and pressure
// alone, and hold whoever supplied the pressure. The derivations are in
// docs/numerics/certificate.md.

#include "contact/operators/surface_operator.hpp"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace asperity::contact {

/// The discrete problem of solver.hpp without adhesion, at a prescribed mean
/// pressure, and an answer to it.
struct SubmittedField {
  std::span<const double> heights;  ///< h [m], finite
  double local_compliance = 0.0;    ///< c = 1/k of a penalty [m/Pa] >= 0
  double nominal_pressure = 0.0;    ///< p_0, prescribed [Pa] > 0
  std::span<const double> pressure; ///< p, as submitted [Pa]; may have tension
  /// Weighted mean of the gap, as submitted [m]; NaN: not submitted.
  double mean_gap = std::numeric_limits<double>::quiet_NaN();
  double hardness = std::numeric_limits<double>::infinity(); ///< H [Pa]
};

/// What one application of the operator tells of a field. Tension is cut off
/// and the mean is scaled to p_0 before it is applied; the two defects are
/// counted here. With a hardness, nodes that carry it may overlap.
struct FieldCheck {
  double load_error = 0.0;      ///< (<p> - p_0)/p_0 as submitted [1]
  double largest_tension = 0.0; ///< -min p as submitted [Pa] >= 0
  std::size_t nodes_in_tension = 0;
  double area_fraction = 0.0; ///< weighted part of the nodes with p > 0 [1]
  /// Mean gap by the pressure, <p, h - C p - c p>/p_0 - <h>: the one at which p
  /// does no work on the gap [m]; with a hardness H, p (1 - p/H) does none.
  double mean_gap = 0.0;
  double largest_penetration = 0.0; ///< max(-g) at that separation [m] >= 0
  double rms_penetration = 0.0;     ///< over all nodes [m]
  /// <p, |g|>/p_0 at that separation: the mean gap under the pressure [m].
  double complementarity = 0.0;
  double elastic_energy = 0.0; ///< <p, C p>/2 [J/m^2]
  /// G = <p, g> with the smallest u for which g >= 0 everywhere, with a
  /// hardness <p, g+> + <H - p, g-> with the best u, plus the allowance for
  /// roundoff [J/m^2]: E(p) - E(p*) <= G for the potential E(p) = <p, C p + c
  /// p>/2 - <h, p> and its minimiser p*.
  double duality_gap = 0.0;
  /// sqrt(2 G/<p, C p + c p>): bounds |p - p*|/|p| in the energy norm [1].
  double pressure_error = 0.0;
  /// Bounds |u - u*| for the submitted u, or for `mean_gap` if none is
  /// submitted [m]. It grows with sqrt(G); bound_separation() is far sharper.
  double mean_gap_error = 0.0;
};

/// Bounds of the mean gap u* of the exact discrete answer. The separation of
/// the derivation is larger by the weighted mean of the heights, which is not 0
/// for a surface of unweighted mean 0 under finite elements of second order.
struct SeparationBounds {
  double low = 0.0;          ///< [m] u* >= low
  double high = 0.0;         ///< [m] u* <= high
  double polished_gap = 0.0; ///< G of the polished pressure [J/m^2]
  int solver_iterations = 0; ///< for the two auxiliary contact problems
  /// Largest |u - u*| that the bounds allow for the submitted u, or for
  /// FieldCheck::mean_gap if none was submitted [m].
  double error = 0.0;
};

/// @param elasticity  C of the half-space, slab, layers or condensed block on
///                    the grid of the answer; its scratch is used. If ranks
///                    share its rows, check_field() is collective and the
///                    fields have the own rows.
/// @throws std::domain_error  sizes differ, a number is not finite or outside
///                            its range, no node has a pressure > 0, or none
///                            has one between 0 and the hardness
FieldCheck check_field(SurfaceOperator& elasticity,
                       const SubmittedField& submitted);

/// Computes the bounds of the mean separation by two contact problems whose
/// solutions need not be trusted: the submitted pressure solved further, and a
/// flat punch on its contact area. The best of several bounds is reported, one
/// of which stays close where contact is undecided, as at the load of first
/// full contact. Costs some 50 to 100 iterations of the solver.
/// @throws std::domain_error  as check_field()
SeparationBounds bound_separation(SurfaceOperator& elasticity,
                                  const SubmittedField& submitted);

} // namespace asperity::contact
