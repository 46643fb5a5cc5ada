#pragma once

// Westergaard's contact of an elastic half-space and a rigid sinusoidal
// surface, h = D cos(2 pi x/lambda), which is exact at every load and in closed
// form.

namespace asperity::theory {

/// @see H. M. Westergaard, J. Appl. Mech. 6, 49 (1939); K. L. Johnson, Contact
///      Mechanics (1985), Sec. 13.2. Plane strain, no friction, no adhesion.
///
/// All members throw std::domain_error for an argument that is outside its
/// range or not finite, and are exact to roundoff. P = p/p* throughout; the
/// contact is full for P >= 1.
class WestergaardContact {
public:
  /// @param amplitude        D, half the height from trough to crest [m] > 0
  /// @param wavelength       lambda [m] > 0
  /// @param contact_modulus  E* [Pa] > 0
  WestergaardContact(double amplitude, double wavelength,
                     double contact_modulus);

  /// p* = pi E* D/lambda [Pa], the load of full contact.
  double full_contact_pressure() const { return full_contact_pressure_; }

  /// Area fraction (2/pi) asin sqrt(P) [1] 0..1.
  /// @param nominal_pressure  p [Pa] >= 0, as for all members
  double area_fraction(double nominal_pressure) const;

  /// Separation of the mean planes, D (1 - P + P ln P) [m]; 0 in full contact.
  double mean_gap(double nominal_pressure) const;

  /// The load with adhesion of no range (JKR), as a function of the area:
  ///
  ///     p/p* = sin^2(pi A/2) - alpha sqrt(tan(pi A/2)),
  ///     alpha = (2^(1/2)/pi) (lambda/D) (w/(E* lambda))^(1/2)
  ///
  /// It falls without bound towards full contact, which then holds any tension
  /// below the strength of the faces.
  /// @param area_fraction     A [1] 0 <= A < 1
  /// @param work_of_adhesion  w [J/m^2] >= 0
  /// @see  K. L. Johnson, Int. J. Solids Struct. 32, 423 (1995)
  double adhesive_pressure(double area_fraction, double work_of_adhesion) const;

  /// -dp/d(mean gap) = p*/(D ln(1/P)) [Pa/m], infinite in full contact, 0 at
  /// zero load.
  double contact_stiffness(double nominal_pressure) const;

  /// Elastic energy per nominal area, D p* P^2 (1/4 - ln(P)/2) [J/m^2]; D p*/4
  /// in full contact.
  double elastic_energy(double nominal_pressure) const;

  /// Contact pressure, with psi = pi x/lambda,
  ///     2 p* cos(psi) sqrt(P - sin^2 psi),  0 where P < sin^2 psi,
  ///     p + p* cos(2 psi) in full contact [Pa].
  /// @param position  x from a crest [m], any finite value
  double contact_pressure(double position, double nominal_pressure) const;

  /// Gap, with t = abs(sin(pi x/lambda)):
  ///     2 D [t sqrt(t^2 - P) - P arcosh(t/sqrt(P))],  0 in contact [m].
  double gap(double position, double nominal_pressure) const;

private:
  double reduced_pressure(double nominal_pressure) const; // P, at most 1

  double amplitude_;
  double wavelength_;
  double full_contact_pressure_;
};

} // namespace asperity::theory
