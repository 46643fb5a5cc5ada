#pragma once

// Computes the subsurface stress of a continuum block from the surface
// pressure, on planes of constant depth. It contains the decay of each Fourier
// mode with depth.

#include "base/grid.hpp"
#include "base/ranks/convolution.hpp"
#include "contact/operators/layered_compliance.hpp"

#include <complex>
#include <memory>
#include <span>
#include <vector>

namespace asperity::contact {

/// Stress on one plane, tension positive, z pointing into the block; six fields
/// [Pa].
struct StressPlane {
  std::vector<double> xx, yy, zz, xy, yz, zx;
};

/// Von Mises stress sqrt(3 J_2) [Pa] >= 0 at each node.
std::vector<double> von_mises(const StressPlane& plane);

/// Largest shear stress, half the difference of the largest and the smallest
/// principal stress [Pa] >= 0, at each node.
std::vector<double> largest_shear(const StressPlane& plane);

/// On the interface of two layers the in-plane stress is discontinuous; this
/// selects the layer.
enum class InterfaceSide { upper, lower };

/// The largest von Mises stress and its position.
struct StressPeak {
  double von_mises = 0.0; ///< [Pa]
  double depth = 0.0;     ///< below the surface [m]
  std::size_t node = 0;   ///< lateral position, see Grid::index
  /// Side of the interface, if the position lies on one.
  InterfaceSide side = InterfaceSide::upper;
};

/// The stress of one pressure field on one block. A mode p exp(iqx) on the
/// frictionless surface is a plane-strain field in the plane of q and z, and
/// LayerStack computes its stress. In the half-space, with f = (1 + q z)
/// exp(-q z) and its derivatives with respect to q z,
///
///     sigma_zz = -f p,  sigma_qq = f'' p,  sigma_zq = -i f' p,
///     sigma_tt = nu (sigma_qq + sigma_zz).
///
/// The uniform pressure p_0 gives sigma_zz = -p_0 and sigma_xx = sigma_yy =
/// -nu/(1-nu) p_0 with nu of each layer: the block has no lateral strain.
class StressInside {
public:
  /// @param block     poisson_ratio is read for every far boundary,
  ///                  -1 < nu <= 0.5; contact_modulus > 0, which has no effect
  ///                  without layers
  /// @param pressure  [Pa], grid.size() values, as computed by a contact solver
  /// @throws std::domain_error  a size or a number is outside its range
  StressInside(const Grid& grid, const mechanics::ElasticBlock& block,
               std::span<const double> pressure, int threads = 1);

  /// Stress on one plane.
  /// @param depth  z [m], 0..thickness
  /// @param side   side of the interface, if the plane is one
  /// @throws std::domain_error  depth is outside its range
  /// @par Accuracy  roundoff for the band-limited pressure; within two grid
  ///            spacings of the surface, the stress of wavelengths that the
  ///            grid does not resolve is missing
  /// @see  K. L. Johnson, Contact Mechanics (1985), Sec. 13.1
  StressPlane at_depth(double depth,
                       InterfaceSide side = InterfaceSide::upper) const;

  /// Von Mises stress [Pa] in one row of nodes.
  /// @param row  0..points_y-1
  std::vector<double> von_mises_row(double depth, int row) const;

  /// The largest shear stress [Pa] at a point that strongest() has found.
  double shear_at(const StressPeak& peak) const;

  /// The largest von Mises stress of the block and its position, from one grid
  /// spacing below the surface down to half the side length (or the far
  /// boundary): the longest wavelength is strongest at a sixth of the side
  /// length. The search evaluates planes whose depths grow by a constant
  /// factor, and both sides of each interface, then applies Brent's method
  /// between the neighbours of the best plane in its layer. The first grid
  /// spacing below the surface is excluded; a coating of that thickness, or the
  /// upper side of its interface, is therefore not examined.
  /// @par Accuracy  0.1 % of the stress and 1 % of the depth, for this pressure
  ///            field
  StressPeak strongest() const;

private:
  struct Plane {
    std::size_t layer;
    double depth;
  };

  using Complex = std::complex<double>;

  StressPlane stress_in(const Plane& place) const;
  double strength_in(const Plane& plane) const;
  std::vector<Plane> planes_to_search(double shallowest, double deepest) const;
  std::span<const LayerStack::Wave> waves_of(std::size_t mode) const;
  /// Calls take(jx, jy, mode) for the modes but the mean; threads call it at
  /// the same time. `mode` is an index into spectrum_.
  template <class Take>
  void each_mode(const Take& take) const;

  Grid grid_;
  LayerStack stack_;
  std::unique_ptr<Convolution<double>> fourier_;
  /// Of the pressure, column by column [Pa].
  std::vector<Complex> spectrum_;
  /// Layer amplitudes of each mode, layers contiguous; empty for the
  /// half-space, where they are the same for all modes.
  std::vector<LayerStack::Wave> waves_;
};

} // namespace asperity::contact
