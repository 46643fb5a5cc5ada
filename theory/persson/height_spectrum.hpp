#pragma once

// The isotropic height spectrum of a surface as input to the theory, given by a
// formula or by the shells of a measured map, with its moments and its
// quadrature nodes. Equation numbers in this file are those of Yang and Persson
// (2008).

#include <functional>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace asperity::theory {

/// C(q) of an isotropic surface, with the normalisation of Yang and Persson,
///
///     C(q) = (2 pi)^-2 int <h(x) h(0)> e^{-i q.x} d^2x,
///     <h^2> = 2 pi int q C(q) dq.
struct SpectrumFormula {
  /// C [m^4] >= 0 at a wavevector q [rad/m]; smooth between breaks.
  std::function<double(double)> height_spectrum;
  /// q_L, every kink or jump of C, and q_1: ascending, > 0 [rad/m]. The
  /// spectrum is zero outside.
  std::vector<double> breaks;
};

/// The roughness of a map at one |q|: the sum of the mean squares of its
/// Fourier modes. The theory treats it as a line of the spectrum,
/// 2 pi q C(q) = mean_square_height delta(q - wavevector).
struct SpectrumShell {
  double wavevector = 0.0;         ///< |q| [rad/m] > 0
  double mean_square_height = 0.0; ///< total over shells is h_rms^2 [m^2] >= 0
};

/// Moments of a profile (Longuet-Higgins, Nayak), for asperity models.
struct ProfileMoments {
  double height = 0.0;    ///< m_0 = 2 pi int q C dq = h_rms^2 [m^2]
  double slope = 0.0;     ///< m_2 = pi int q^3 C dq = rms_slope^2/2 [1]
  double curvature = 0.0; ///< m_4 = (3 pi/4) int q^5 C dq [1/m^2]
};

/// A node of the quadrature rule for all integrals of Eqs. (9)-(19). With
/// M(q) = int_{q_L}^q q'^3 C dq', m = sqrt(M), w(q) = 1/(sqrt(pi) m) of
/// Eq. (12):
///
///     sqrt(pi) int q^2 C w f(m) dq = 2 int_0^{m_1} f(m) dm/q(m)
///                                  = sum of weight * f(root_moment),
///
/// to roundoff for each f that is smooth in ln m.
struct RoughnessNode {
  double root_moment = 0.0; ///< m [1] > 0
  double weight = 0.0;      ///< 2 dm/q [m]; may be negative for shells
  /// -d(1/q) = dq/q^2 [m], for int f(m) dq/q^2 with a formula, including bands
  /// in which the spectrum vanishes; 0 for shells, where q is discontinuous.
  double inverse_step = 0.0;
};

/// A spectrum prepared for the theory. It is cheap to copy, because the nodes
/// are shared and immutable.
class HeightSpectrum {
public:
  /// @throws std::domain_error  breaks do not ascend from above 0, C is
  ///                            negative or not finite somewhere, or there is
  ///                            no roughness
  explicit HeightSpectrum(SpectrumFormula formula);

  /// Spectrum from shells, given in any order. M(q) is then a step function and
  /// q(m) is constant on each step; the nodes integrate the steps exactly
  /// without binning, whatever the number of shells.
  /// @throws std::domain_error  a member is outside its range or not finite, or
  ///         there is no roughness
  explicit HeightSpectrum(std::vector<SpectrumShell> shells);

  /// C(q) of a formula [m^4], 0 outside its breaks.
  /// @throws std::domain_error  the spectrum consists of shells, which are
  ///                            lines
  double density(double wavevector) const;
  bool has_density() const; ///< true for a formula, false for shells
  /// Breaks of the formula, from q_L to q_1 [rad/m]; empty for shells.
  std::span<const double> breaks() const;
  /// Shells in order of ascending wavevector, without those of zero height;
  /// empty for a formula.
  std::span<const SpectrumShell> shells() const;

  double wavevector_low() const;  ///< q_L, lower end of the spectrum [rad/m]
  double wavevector_high() const; ///< q_1 [rad/m]
  double rms_height() const;      ///< h_rms [m]
  double rms_slope() const;       ///< sqrt of <|grad h|^2>, both directions [1]
  const ProfileMoments& profile_moments() const;

  /// int q^2 C dq [m], which determines the energy in full contact, Eq. (9)
  /// with W = 1.
  double full_contact_moment() const;

  /// Nodes in descending order of root_moment.
  std::span<const RoughnessNode> nodes() const;

  /// The part of the spectrum with low < q <= high: the roughness resolved at
  /// the magnification high/q_0, or that unresolved at low/q_0.
  /// @throws std::domain_error  low >= high, or no roughness between them
  HeightSpectrum between(double low, double high) const;

private:
  struct Prepared;
  std::variant<SpectrumFormula, std::vector<SpectrumShell>> source_;
  std::shared_ptr<const Prepared> prepared_;
};

} // namespace asperity::theory
