#pragma once

// Waves in bonded isotropic layers under a frictionless face, one wavevector at
// a time: the surface compliance, and the stress below it. Owns the recursion
// that carries a far face's or a half-space's answer up through the layers.

#include "contact/operators/halfspace.hpp"

#include <array>
#include <span>
#include <vector>

namespace asperity::contact {

/// One layer of a stack as its waves see it.
struct StackLayer {
  double top = 0.0;             ///< depth of its upper face [m]
  double thickness = 0.0;       ///< [m] > 0; infinite of a half-space
  double contact_modulus = 0.0; ///< E* = E/(1 - nu^2) [Pa] > 0
  double poisson_ratio = 0.0;   ///< nu [1], -1 < nu <= 0.5
  double lateral_ratio = 0.0;   ///< k = nu/(1 - nu) [1]
};

/// An isotropic layered solid, periodic along its face. A wave exp(iqx) is
/// plane strain in the plane of q and z (z into the block). With displacements
/// u_q = i v, u_z = w and the tractions that a plane's upper side gives to its
/// lower one, -sigma_zq = i s, -sigma_zz = n, Hooke's law and balance are, in a
/// layer of E* = E/(1 - nu^2) and k = nu/(1 - nu), with x = q z, displacements
/// in units of 1/(E* q) and tractions in pascals,
///
///     v' = -2(1+k) s - w,    w' = k v - (1-k^2) n,                      (L.1)
///     s' = -v - k n,         n' = s,        sigma_qq = -v - k n.        (L.2)
///
/// The four roots are 1, 1, -1, -1. Waves that decay downwards carry a traction
/// a, those that decay upwards -b, with displacements H a and H' b:
///
///     H = [ 2, 1-k ; 1-k, 2 ],      H' = [ 2, k-1 ; k-1, 2 ],           (L.3)
///     a(x) = exp(-x) [ 1-x, -x ; x, 1+x ] a(0) = D(x) a(0),             (L.4)
///     b(-x) = exp(-x) [ 1-x, x ; -x, 1+x ] b(0) = D'(x) b(0).           (L.5)
///
/// What lies under a plane answers it by two columns, displacements U and
/// tractions T; T U^-1 is its 2x2 stiffness, and U or T alone may be singular.
/// Far faces: clamped U = 0, T = 1; pressure U = 1, T = 0; sliding
/// U = diag(1, 0), T = diag(0, 1). A half-space: U = H, T = 1.
///
/// Up through a layer of thickness t, x = q t, from its bottom (U, T):
///
///     x > 1:   R = (U - H T) (U + H' T)^-1,   Q = D'(x) R D(x),
///              U <- H + H' Q,   T <- 1 - Q;                             (L.6)
///     x <= 1:  (U, T) <- exp(-M x) (U, T), M the matrix of (L.1), (L.2). (L.7)
///
/// (L.6) holds decaying exponentials only, and R is the bottom's reflection.
/// (L.7) is kept for thin layers, where the four waves of (L.3) are nearly
/// alike: its entries are sums of equal signs, so that a plate's stiffness in
/// bending, x^3, keeps its digits. Between two layers U is multiplied by the
/// ratio of their E* (displacements are continuous); every (U, T) is normalised
/// by (U + T)^-1 on the right, which exists as the stiffness is positive. At
/// the face the shear is zero:
///
///     C(q) = (U T^-1)_ww / (E*_1 q).                                    (L.8)
///
/// @see  the stiffness matrices of E. Kausel and J. M. Roesset, Bull. Seismol.
///       Soc. Am. 71, 1743 (1981) and S. I. Rokhlin and L. Wang, J. Acoust.
///       Soc. Am. 112, 822 (2002), here at no frequency and for pairs (U, T)
class LayerStack {
public:
  /// A wave in one layer: (v, w, s, n) at its top where q t <= 1, else a at its
  /// top and b at its bottom; displacements in the layer's units.
  using Wave = std::array<double, 4>;

  /// Stress over the pressure's amplitude: sigma_zz, sigma_qq, sigma_zq / i and
  /// the out-of-plane sigma_tt = nu (sigma_qq + sigma_zz).
  struct Stress {
    double zz, qq, zq, tt;
  };

  /// @throws std::domain_error  a modulus or thickness is not > 0, a Poisson's
  ///                            ratio outside -1 < nu <= 0.5, or the layers are
  ///                            not thinner than the block together
  explicit LayerStack(const ElasticBlock& block);

  /// The block's layers and, as the last, what is left of its depth.
  std::size_t size() const { return layers_.size(); }

  double thickness() const { return thickness_; } ///< of all [m], or infinite

  const StackLayer& layer(std::size_t index) const { return layers_[index]; }

  /// C(q), normal displacement over pressure.
  /// @param wavevector  q [rad/m] > 0
  /// @return            [m/Pa] > 0
  /// @par Accuracy  rounding, 1e-14, for q t of 1e-8 to infinity; 4e-14 for
  ///            moduli a million times apart
  double compliance(double wavevector) const;

  /// The waves of all layers under a pressure exp(iqx).
  /// @param wavevector  q [rad/m] > 0
  /// @param waves       size() of them
  void find_waves(double wavevector, std::span<Wave> waves) const;

  /// @param depth  z [m], within the layer
  Stress stress(std::size_t layer, const Wave& wave, double wavevector,
                double depth) const;

private:
  std::vector<StackLayer> layers_;
  double thickness_;
  FarFace far_face_;
};

/// C(q) of a block at one wavevector [m/Pa], as LayerStack has it.
/// @throws std::domain_error  as LayerStack; wavevector is not > 0
double layered_compliance(double wavevector, const ElasticBlock& block);

} // namespace asperity::contact
