#pragma once

// An elastic half-space on a rigid egg-box, h = D cos(2 pi x/lambda) cos(2 pi
// y/lambda): the two ends, light and nearly full, in closed form, and what lies
// between them from a numerical solution.

namespace asperity::theory {

/// @see K. L. Johnson, J. A. Greenwood, J. G. Higginson, Int. J. Mech. Sci. 27,
///      383 (1985). No friction, no adhesion. P = p/p*; a cell lambda^2 has two
///      crests and two troughs, each a square array of period lambda/sqrt2.
///
/// Members throw std::domain_error for an argument outside its range or not
/// finite. The light_ and heavy_ members return the limits themselves; how far
/// each limit holds is said with it, as measured against a numerical solution.
/// The members without a prefix hold at every load: they interpolate a table
/// (wave_2d_table.hpp) of what is left of the limits, in P^{2/3}.
class Wave2dContact {
public:
  /// @param amplitude        D, height of a crest over the mean plane [m] > 0
  /// @param wavelength       lambda, along x and along y [m] > 0
  /// @param contact_modulus  E* [Pa] > 0
  Wave2dContact(double amplitude, double wavelength, double contact_modulus);

  /// p* = sqrt2 pi E* D/lambda [Pa], the load of full contact.
  double full_contact_pressure() const { return full_contact_pressure_; }

  /// Energy per nominal area in full contact, D p*/8 [J/m^2].
  double full_contact_energy() const;

  /// A/A_0 [1] 0..1, to 2e-4 as measured between the table's rows; at both ends
  /// to 2e-3 of itself and of the open area.
  /// @param nominal_pressure  p [Pa] >= 0, here and below
  double area_fraction(double nominal_pressure) const;

  /// Between the mean planes [m], to 2e-6 D; 0 in full contact.
  double mean_gap(double nominal_pressure) const;

  /// Energy per nominal area, int p (-du) = int_0^p u dp' - p u [J/m^2], to
  /// 3e-7 D p*.
  double elastic_energy(double nominal_pressure) const;

  /// Hertz on every crest: A/A_0 = pi (3 P/8 pi)^{2/3} [1]. For P < 0.1; low
  /// by some 0.75 P^{2/3} of itself.
  double light_area_fraction(double nominal_pressure) const;

  /// Mean gap of Hertz's crests with their neighbours' share of the approach,
  ///     D - a^2/R + S F/(pi E* lambda/sqrt2)
  /// of hertz.hpp, F = p lambda^2/2, R = lambda^2/(4 pi^2 D) [m]. For P < 0.05;
  /// low by some 0.65 D P^{4/3}, the fourth order of the crest's shape.
  double light_mean_gap(double nominal_pressure) const;

  /// A/A_0 = 1 - (3/2 pi)(1 - P) [1]: round cracks in the troughs, of radius b,
  /// b^2 = 3 (1 - P) lambda^2/(4 pi^2), where the pressure at their rim ends
  /// without a singularity. For P > 0.7; the open area is low by at most
  /// 0.5 (1 - P) of itself.
  double heavy_area_fraction(double nominal_pressure) const;

  /// The volume of those cracks over A_0, with p = -tau_0 + tau_2 r^2 about
  /// a trough of the full contact's field:
  ///     (32/15) p* (1 - P) b^3/(E* lambda^2)
  ///     = (4 sqrt6/(5 pi^2)) D (1 - P)^{5/2}  [m].
  /// For P > 0.7; low by 0.3 to 0.5 times (1 - P) of itself.
  double heavy_mean_gap(double nominal_pressure) const;

private:
  double reduced_pressure(double nominal_pressure) const; // P, at most 1

  double amplitude_;
  double wavelength_;
  double contact_modulus_;
  double full_contact_pressure_;
};

} // namespace asperity::theory
