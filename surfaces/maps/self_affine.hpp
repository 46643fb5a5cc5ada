#pragma once

// The height spectrum given by a formula: constant up to the roll-off
// wavevector, self-affine up to the cut-off. Its amplitude and its moments have
// closed forms.

#include "surfaces/maps/isotropic_spectrum.hpp"

namespace asperity::surfaces {

/// Band and exponent of the spectrum.
struct SelfAffineShape {
  double hurst = 0.0;               ///< Hurst exponent H [1] 0..1
  double wavevector_low = 0.0;      ///< lower limit q_L [rad/m] > 0
  double wavevector_roll_off = 0.0; ///< roll-off q_0 [rad/m], q_L <= q_0
  double wavevector_high = 0.0;     ///< q_1 [rad/m], q_0 <= q_1, q_L < q_1
};

/// The spectrum of the surfaces of Yang and Persson (2008),
///
///     C(q) = C_0                    q_L <= q <= q_0
///     C(q) = C_0 (q/q_0)^(-2-2H)    q_0 <= q <= q_1
///
/// and 0 elsewhere; both ends belong to the band (is_in_band).
/// @see  C. Yang and B. N. J. Persson, J. Phys.: Condens. Matter 20, 215214
///       (2008), Sec. 4 and the caption of its spectrum
class SelfAffineSpectrum {
public:
  /// The spectrum with C_0 from <h^2> = rms_height^2 over the whole band.
  /// @param rms_height  h_rms [m] > 0
  /// @throws std::domain_error  an argument is outside its range
  static SelfAffineSpectrum with_rms_height(const SelfAffineShape& shape,
                                            double rms_height);

  /// The spectrum with C_0 from <|grad h|^2> = rms_slope^2 over the whole band.
  /// @param rms_slope  [1] > 0, both directions
  /// @throws std::domain_error  an argument is outside its range
  static SelfAffineSpectrum with_rms_slope(const SelfAffineShape& shape,
                                           double rms_slope);

  /// C(q) [m^4].
  double operator()(double wavevector) const;

  /// 2 pi int q^(1 + order) C(q) dq: <h^2> [m^2] for order 0, <|grad h|^2> [1]
  /// for 2, <(Laplacian h)^2> [1/m^2] for 4. H = 0 and H = 1, where one of the
  /// pieces is a logarithm, need no special treatment by the caller.
  /// @par Accuracy  a few eps
  double moment(int order) const;

  double rms_height() const; ///< [m]
  double rms_slope() const;  ///< both directions [1]

  /// Rms value of half the Laplacian, the mean of the principal curvatures
  /// [1/m].
  double rms_curvature() const;

  double plateau() const { return plateau_; } ///< C_0 [m^4]

  const SelfAffineShape& shape() const { return shape_; }

  /// The same spectrum in the general form.
  IsotropicSpectrum isotropic() const;

private:
  SelfAffineSpectrum(const SelfAffineShape& shape, double plateau);

  SelfAffineShape shape_;
  double plateau_;
};

} // namespace asperity::surfaces
