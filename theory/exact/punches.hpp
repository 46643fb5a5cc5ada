#pragma once

// Rigid indenters on an elastic half-space: the flat-ended cylinder and the
// cone, whose fields have closed forms, and the cylinder with a rounded edge.

namespace asperity::theory {

/// Contact of an axisymmetric punch: radius, approach and load.
struct PunchContact {
  double contact_radius = 0.0; ///< a [m]
  double approach = 0.0;       ///< delta [m], positive into contact
  double load = 0.0;           ///< F [N]
};

/// A flat-ended cylinder: F = 2 E* a delta.
/// @see  K. L. Johnson, Contact Mechanics (1985), Sec. 3.8
class FlatPunch {
public:
  /// @param punch_radius     a [m] > 0
  /// @param contact_modulus  E* [Pa] > 0
  /// @throws std::domain_error  an argument is outside its range or not finite,
  ///                            as for all members
  FlatPunch(double punch_radius, double contact_modulus);

  /// @param load  F [N], may be tensile: the contact edge does not move
  PunchContact contact(double load) const;

  /// Contact pressure F/(2 pi a^2 sqrt(1 - r^2/a^2)) for r < a, infinite at the
  /// edge, 0 outside [Pa].
  double pressure(double load, double radius) const;

  /// Surface displacement delta for r <= a, (2 delta/pi) asin(a/r) outside [m].
  double displacement(double load, double radius) const;

  /// Moment about the middle of its end under which it tilts by a small angle,
  /// (4/3) E* a^3 angle [N m]. The whole end stays in contact while the
  /// approach is at least 2 a |angle|.
  /// @param angle  [rad], finite
  double moment(double angle) const;

  /// The load under which a surface that lies `recess` behind the flat end
  /// touches midway between four punches of a square array, where it touches
  /// first: F of
  ///
  ///     F/(2 E* a) - (2 - sqrt 2) S F/(pi E* L) = recess
  ///
  /// with S = square_array_constant() of hertz.hpp. The displacement at a punch
  /// by all others, -S F/(pi E* L), and midway, (1 - sqrt 2) S F/(pi E* L), are
  /// potentials of the square lattice, which is the union of two lattices of
  /// sqrt(2) times its period.
  /// @param recess  [m] > 0
  /// @param period  L [m] > 2 a
  /// @par Accuracy  (a/L)^3
  double touching_load_in_array(double recess, double period) const;

  /// The same for one punch, at a distance r from its middle.
  /// @param radius  r [m] > a
  double touching_load(double recess, double radius) const;

private:
  double punch_radius_;
  double contact_modulus_;
};

/// A cone of height s r: a = 2 delta/(pi s), F = (pi/2) E* s a^2.
/// @see  I. N. Sneddon, Int. J. Eng. Sci. 3, 47 (1965)
class Cone {
public:
  /// @param slope            s of its flank against the surface [1] > 0, small
  /// @param contact_modulus  E* [Pa] > 0
  /// @throws std::domain_error  an argument is outside its range or not finite,
  ///                            as for all members
  Cone(double slope, double contact_modulus);

  /// @param load  F [N] >= 0
  PunchContact contact(double load) const;

  /// Contact pressure (E* s/2) arcosh(a/r) for r < a, infinite on the axis, 0
  /// outside [Pa].
  double pressure(double load, double radius) const;

  /// Surface displacement delta - s r for r <= a,
  /// s [a asin(a/r) + sqrt(r^2 - a^2) - r] outside [m].
  double displacement(double load, double radius) const;

private:
  double slope_;
  double contact_modulus_;
};

/// A flat end of radius b with a rounded edge: the height is 0 for r <= b and
/// -(r - b)^2/(2 R) outside. With s^2 = a^2 - b^2 and t = atan(s/b)
///
///     delta = a (s - b t)/R,   F = (2 E*/R) (2 s^3/3 + b^2 s/2 - b a^2 t/2)
///
/// which is Hertz' sphere for b = 0, and the flat punch for R = 0.
/// @see  M. Ciavarella, Int. J. Solids Struct. 36, 4149 (1999); V. L. Popov et
///       al., Handbook of Contact Mechanics (2019), Chap. 2, for g
class RoundedPunch {
public:
  /// @param end_radius       b [m] > 0
  /// @param edge_radius      R [m] > 0
  /// @param contact_modulus  E* [Pa] > 0
  /// @throws std::domain_error  an argument is outside its range or not finite,
  ///                            as for all members
  RoundedPunch(double end_radius, double edge_radius, double contact_modulus);

  /// @param load  F [N] >= 0
  /// @par Accuracy  rounding, times (b/s)^2 in a contact that hardly leaves the
  ///                flat end
  PunchContact contact(double load) const;

  /// Surface displacement in a contact of contact(): delta - (r - b)^2/(2 R)
  /// within, and outside, by quadrature to 1e-6 of delta,
  ///
  ///     (2/pi) int_b^a g'(x) asin(x/r) dx,   g' = (2 s - b t)/R at x for a
  ///
  double displacement(const PunchContact& spot, double radius) const;

private:
  double end_radius_;
  double edge_radius_;
  double contact_modulus_;
};

} // namespace asperity::theory
