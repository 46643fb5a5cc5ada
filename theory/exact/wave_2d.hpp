#pragma once

// The contact of an elastic half-space and a rigid bisinusoidal surface, h = D
// cos(2 pi x/lambda) cos(2 pi y/lambda): the limits of light load and of nearly
// full contact in closed form, and the range between them from a numerical
// solution.

namespace asperity::theory {

/// @see K. L. Johnson, J. A. Greenwood, J. G. Higginson, Int. J. Mech. Sci. 27,
///      383 (1985). No friction, no adhesion. P = p/p*; a cell lambda^2 has two
///      crests and two troughs, each a square array of period lambda/sqrt2.
///
/// The members throw std::domain_error for an argument that is outside its
/// range or not finite. The members light_ and heavy_ return the limits
/// themselves; their documentation gives the range of validity as measured
/// against a numerical solution. The members without a prefix hold at every
/// load: they interpolate the differences from the limits in a table
/// (wave_2d_table.hpp), in P^{2/3}.
class Wave2dContact {
public:
  /// @param amplitude        D, height of a crest above the mean plane [m] > 0
  /// @param wavelength       lambda, along x and along y [m] > 0
  /// @param contact_modulus  E* [Pa] > 0
  Wave2dContact(double amplitude, double wavelength, double contact_modulus);

  /// p* = sqrt2 pi E* D/lambda [Pa], the load of full contact.
  double full_contact_pressure() const { return full_contact_pressure_; }

  /// Elastic energy per nominal area in full contact, D p*/8 [J/m^2].
  double full_contact_energy() const;

  /// A/A_0 [1] 0..1, with an error of 2e-4 as measured between the rows of the
  /// table; in the limits 2e-3 relative to the contact area and to the
  /// non-contact area, respectively.
  /// @param nominal_pressure  p [Pa] >= 0, as for all members
  double area_fraction(double nominal_pressure) const;

  /// Separation of the mean planes [m], with an error of 2e-6 D; 0 in full
  /// contact.
  double mean_gap(double nominal_pressure) const;

  /// Elastic energy per nominal area, int p (-du) = int_0^p u dp' - p u
  /// [J/m^2], with an error of 3e-7 D p*.
  double elastic_energy(double nominal_pressure) const;

  /// Light-load limit, Hertzian contact on every crest:
  /// A/A_0 = pi (3 P/8 pi)^{2/3} [1]. Valid for P < 0.1, where it is too small
  /// by about 0.75 P^{2/3} of its value.
  double light_area_fraction(double nominal_pressure) const;

  /// Light-load limit of the mean gap, Hertzian contact on every crest with the
  /// contribution of the neighbours to the approach from hertz.hpp,
  ///     D - a^2/R + S F/(pi E* lambda/sqrt2)
  /// with F = p lambda^2/2, R = lambda^2/(4 pi^2 D) [m]. Valid for P < 0.05,
  /// where it is too small by about 0.65 D P^{4/3} because of the fourth-order
  /// term of the crest shape.
  double light_mean_gap(double nominal_pressure) const;

  /// Limit near full contact, A/A_0 = 1 - (3/2 pi)(1 - P) [1]: circular cracks
  /// in the troughs, of radius b, b^2 = 3 (1 - P) lambda^2/(4 pi^2), for which
  /// the pressure at their edge has no singularity. Valid for P > 0.7, where
  /// the non-contact area is too small by at most 0.5 (1 - P) of its value.
  double heavy_area_fraction(double nominal_pressure) const;

  /// Limit of the mean gap near full contact, the volume of those cracks
  /// divided by A_0, with p = -tau_0 + tau_2 r^2 near a trough of the field in
  /// full contact:
  ///     (32/15) p* (1 - P) b^3/(E* lambda^2)
  ///     = (4 sqrt6/(5 pi^2)) D (1 - P)^{5/2}  [m].
  /// Valid for P > 0.7, where it is too small by 0.3 to 0.5 times (1 - P) of
  /// its value.
  double heavy_mean_gap(double nominal_pressure) const;

private:
  double reduced_pressure(double nominal_pressure) const; // P, at most 1

  double amplitude_;
  double wavelength_;
  double contact_modulus_;
  double full_contact_pressure_;
};

} // namespace asperity::theory
