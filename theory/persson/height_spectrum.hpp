#pragma once

// What a surface is to the theory: an isotropic height spectrum, given as a
// formula or as the shells of a measured map. Owns its moments and its nodes.

#include <functional>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace asperity::theory {

/// C(q) of an isotropic surface, normalised as in the paper,
///
///     C(q) = (2 pi)^-2 int <h(x) h(0)> e^{-i q.x} d^2x,
///     <h^2> = 2 pi int q C(q) dq.
struct SpectrumFormula {
  /// C [m^4] >= 0 at a wavevector q [rad/m]; smooth between breaks.
  std::function<double(double)> height_spectrum;
  /// q_L, every kink or jump of C, q_1: ascending, > 0 [rad/m]. The spectrum
  /// is zero outside.
  std::vector<double> breaks;
};

/// All the roughness of a map with one |q|: its Fourier modes' mean squares,
/// added up. The theory takes it as a line of the spectrum,
/// 2 pi q C(q) = mean_square_height delta(q - wavevector).
struct SpectrumShell {
  double wavevector = 0.0;         ///< |q| [rad/m] > 0
  double mean_square_height = 0.0; ///< sum over the shell is h_rms^2 [m^2] >= 0
};

/// Moments along a line (Longuet-Higgins, Nayak), for asperity models.
struct ProfileMoments {
  double height = 0.0;    ///< m_0 = 2 pi int q C dq = h_rms^2 [m^2]
  double slope = 0.0;     ///< m_2 = pi int q^3 C dq = rms_slope^2/2 [1]
  double curvature = 0.0; ///< m_4 = (3 pi/4) int q^5 C dq [1/m^2]
};

/// A node of the rule for every integral of (9)-(19). With
/// M(q) = int_{q_L}^q q'^3 C dq', m = sqrt(M), w(q) = 1/(sqrt(pi) m) of (12):
///
///     sqrt(pi) int q^2 C w f(m) dq = 2 int_0^{m_1} f(m) dm/q(m)
///                                  = sum of weight * f(root_moment),
///
/// to rounding for each f that is smooth in ln m.
struct RoughnessNode {
  double root_moment = 0.0; ///< m [1] > 0
  double weight = 0.0;      ///< 2 dm/q [m]; may be negative for shells
  /// -d(1/q) = dq/q^2 [m], for int f(m) dq/q^2 over a formula, gaps of the
  /// spectrum included; 0 for shells, whose q moves by jumps.
  double inverse_step = 0.0;
};

/// A spectrum that is ready for the theory. Cheap to copy: the nodes are
/// shared and never change.
class HeightSpectrum {
public:
  /// @throws std::domain_error  breaks do not ascend from above 0, C is
  ///         negative or not finite somewhere, or there is no roughness at all
  explicit HeightSpectrum(SpectrumFormula formula);

  /// The shells in any order. M(q) is then a staircase, q(m) a constant on
  /// each of its steps, and the nodes integrate the steps themselves: nothing
  /// is binned, whatever the number of shells.
  /// @throws std::domain_error  a member outside its range or not finite, or
  ///         no roughness at all
  explicit HeightSpectrum(std::vector<SpectrumShell> shells);

  /// C(q) of a formula [m^4], 0 outside its breaks.
  /// @throws std::domain_error  the spectrum is made of shells: it has lines
  double density(double wavevector) const;
  bool has_density() const; ///< a formula, not shells
  /// Those of the formula, from q_L to q_1 [rad/m]; none for shells.
  std::span<const double> breaks() const;
  /// Ascending in wavevector, those without height left out; none for a
  /// formula.
  std::span<const SpectrumShell> shells() const;

  double wavevector_low() const;  ///< q_L, where roughness begins [rad/m]
  double wavevector_high() const; ///< q_1 [rad/m]
  double rms_height() const;      ///< h_rms [m]
  double rms_slope() const;       ///< sqrt of <|grad h|^2>, both directions [1]
  const ProfileMoments& profile_moments() const;

  /// int q^2 C dq [m]: what full contact's energy is made of, (9) with W = 1.
  double full_contact_moment() const;

  /// Descending in root_moment.
  std::span<const RoughnessNode> nodes() const;

  /// The part of the spectrum with low < q <= high: what is seen at the
  /// magnification high/q_0, or what is hidden at low/q_0.
  /// @throws std::domain_error  low >= high, or no roughness between them
  HeightSpectrum between(double low, double high) const;

private:
  struct Prepared;
  std::variant<SpectrumFormula, std::vector<SpectrumShell>> source_;
  std::shared_ptr<const Prepared> prepared_;
};

} // namespace asperity::theory
