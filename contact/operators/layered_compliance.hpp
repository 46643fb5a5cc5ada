#pragma once

// Computes the elastic fields, per wavevector, in bonded isotropic layers under
// a frictionless surface: the surface compliance and the stress below the
// surface. It contains the recursion that carries the response of the far
// boundary, or of a half-space, up through the layers.

#include "mechanics/elastic_block.hpp"

#include <array>
#include <span>
#include <vector>

namespace asperity::contact {

/// One layer of a stack, with the quantities that the recursion uses.
struct StackLayer {
  double top = 0.0;             ///< depth of its upper boundary [m]
  double thickness = 0.0;       ///< [m] > 0; infinite for a half-space
  double contact_modulus = 0.0; ///< E* = E/(1 - nu^2) [Pa] > 0
  double poisson_ratio = 0.0;   ///< nu [1], -1 < nu <= 0.5
  double lateral_ratio = 0.0;   ///< k = nu/(1 - nu) [1]
};

/// An isotropic layered solid, periodic along its surface. A Fourier mode
/// exp(iqx) is a plane-strain field in the plane of q and z (z points into the
/// block). Let the displacements be u_q = i v, u_z = w, and the tractions that
/// the material above a plane exerts on the material below it be
/// -sigma_zq = i s, -sigma_zz = n. With x = q z, displacements in units of
/// 1/(E* q) and tractions in pascals, Hooke's law and equilibrium in a layer of
/// E* = E/(1 - nu^2) and k = nu/(1 - nu) are
///
///     v' = -2(1+k) s - w,    w' = k v - (1-k^2) n,                      (L.1)
///     s' = -v - k n,         n' = s,        sigma_qq = -v - k n.        (L.2)
///
/// The four roots are 1, 1, -1, -1. The solutions that decay downwards have the
/// traction a, those that decay upwards -b; their displacements are H a and
/// H' b:
///
///     H = [ 2, 1-k ; 1-k, 2 ],      H' = [ 2, k-1 ; k-1, 2 ],           (L.3)
///     a(x) = exp(-x) [ 1-x, -x ; x, 1+x ] a(0) = D(x) a(0),             (L.4)
///     b(-x) = exp(-x) [ 1-x, x ; -x, 1+x ] b(0) = D'(x) b(0).           (L.5)
///
/// The response of the material below a plane is given by two columns,
/// displacements U and tractions T. T U^-1 is its 2x2 stiffness; U or T alone
/// may be singular. The far boundaries are: clamped U = 0, T = 1; pressure
/// U = 1, T = 0; sliding U = diag(1, 0), T = diag(0, 1). For a half-space
/// U = H, T = 1.
///
/// A layer of thickness t, x = q t, maps (U, T) at its bottom to its top by
///
///     x > 1:   R = (U - H T) (U + H' T)^-1,   Q = D'(x) R D(x),
///              U <- H + H' Q,   T <- 1 - Q;                             (L.6)
///     x <= 1:  (U, T) <- exp(-M x) (U, T), M the matrix of (L.1), (L.2). (L.7)
///
/// (L.6) holds decaying exponentials only; R is the reflection at the bottom.
/// (L.7) is used for thin layers, where the four solutions of (L.3) are nearly
/// linearly dependent: its entries are sums of terms of equal sign, so that the
/// bending stiffness of a plate, proportional to x^3, is computed without
/// cancellation. Between two layers U is multiplied by the ratio of their E*,
/// because displacements are continuous. Every (U, T) is normalised by
/// (U + T)^-1 on the right, which exists because the stiffness is positive. At
/// the surface the shear traction is zero:
///
///     C(q) = (U T^-1)_ww / (E*_1 q).                                    (L.8)
///
/// @see  the stiffness matrices of E. Kausel and J. M. Roesset, Bull. Seismol.
///       Soc. Am. 71, 1743 (1981) and S. I. Rokhlin and L. Wang, J. Acoust.
///       Soc. Am. 112, 822 (2002), here in the static limit and for pairs
///       (U, T)
class LayerStack {
public:
  /// Fourier mode in one layer: (v, w, s, n) at its top if q t <= 1, otherwise
  /// a at its top and b at its bottom. Displacements are in the units of the
  /// layer.
  using Wave = std::array<double, 4>;

  /// Stress divided by the pressure amplitude: sigma_zz, sigma_qq, sigma_zq / i
  /// and the out-of-plane sigma_tt = nu (sigma_qq + sigma_zz).
  struct Stress {
    double zz, qq, zq, tt;
  };

  /// @throws std::domain_error  a modulus or thickness is not > 0, a Poisson's
  ///                            ratio is outside -1 < nu <= 0.5, or the layers
  ///                            together are not thinner than the block
  explicit LayerStack(const mechanics::ElasticBlock& block);

  /// Number of layers, including the material below the bonded layers as the
  /// last one.
  std::size_t size() const { return layers_.size(); }

  double thickness() const { return thickness_; } ///< total [m], or infinite

  const StackLayer& layer(std::size_t index) const { return layers_[index]; }

  /// C(q), the amplitude of the normal displacement divided by that of the
  /// pressure.
  /// @param wavevector  q [rad/m] > 0
  /// @return            [m/Pa] > 0
  /// @par Accuracy  roundoff, 1e-14, for q t from 1e-8 to infinity; 4e-14 for
  ///            moduli that differ by a factor of a million
  double compliance(double wavevector) const;

  /// Fourier modes of all layers under a pressure exp(iqx).
  /// @param wavevector  q [rad/m] > 0
  /// @param waves       size() values, overwritten
  void find_waves(double wavevector, std::span<Wave> waves) const;

  /// Stress of a Fourier mode at one depth.
  /// @param index  of the layer, from the contact surface
  /// @param depth  z [m], within the layer
  Stress stress(std::size_t index, const Wave& wave, double wavevector,
                double depth) const;

private:
  std::vector<StackLayer> layers_;
  double thickness_;
  mechanics::FarBoundary far_face_;
};

/// C(q) of a block at one wavevector [m/Pa], see LayerStack::compliance.
/// @throws std::domain_error  as LayerStack, or the wavevector is not > 0
double layered_compliance(double wavevector,
                          const mechanics::ElasticBlock& block);

} // namespace asperity::contact
