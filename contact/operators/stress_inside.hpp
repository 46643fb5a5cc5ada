#pragma once

// The stress below the face of a continuum block, from the pressure on it, a
// plane of constant depth at a time. Owns the decay of each wave with depth.

#include "base/fourier.hpp"
#include "base/grid.hpp"
#include "contact/operators/layered_compliance.hpp"

#include <complex>
#include <span>
#include <vector>

namespace asperity::contact {

/// Stress in one plane, tension positive, z into the block; six maps of
/// grid.size() values [Pa].
struct StressPlane {
  std::vector<double> xx, yy, zz, xy, yz, zx;
};

/// sqrt(3 J_2) [Pa] >= 0 at each node.
std::vector<double> von_mises(const StressPlane& plane);

/// Half the difference of the outermost principal stresses [Pa] >= 0.
std::vector<double> largest_shear(const StressPlane& plane);

/// Where two layers meet, the stress along the plane has two values.
enum class InterfaceSide { upper, lower };

/// Where the block is strained most.
struct StressPeak {
  double von_mises = 0.0; ///< [Pa]
  double depth = 0.0;     ///< below the face [m]
  std::size_t node = 0;   ///< Grid::index of the column it lies in
  /// Of the interface, if it lies on one.
  InterfaceSide side = InterfaceSide::upper;
};

/// One pressure map on one block. A wave p exp(iqx) on the frictionless face
/// is plane strain in the plane of q and z, and LayerStack has its stress: in
/// the half-space, with f = (1 + q z) exp(-q z) and its derivatives by q z,
///
///     sigma_zz = -f p,  sigma_qq = f'' p,  sigma_zq = -i f' p,
///     sigma_tt = nu (sigma_qq + sigma_zz).
///
/// The uniform pressure makes sigma_zz = -p_0 and sigma_xx = sigma_yy =
/// -nu/(1-nu) p_0 with each layer's nu: the block's sides do not move.
class StressInside {
public:
  /// @param block     poisson_ratio is read for every far face, -1 < nu <= 0.5;
  ///                  contact_modulus > 0, but under no layers it means nothing
  /// @param pressure  [Pa], grid.size() values, as a solver gives them
  /// @throws std::domain_error  a size or a number is outside its range
  StressInside(const Grid& grid, const ElasticBlock& block,
               std::span<const double> pressure, int threads = 1);

  /// @param depth  z [m], 0..thickness
  /// @param side   of the interface, if the plane is one
  /// @throws std::domain_error  depth is outside
  /// @par Accuracy  rounding for the pressure as a sum of waves: within two
  ///            spacings of the face what the grid cannot resolve is missing
  /// @see  K. L. Johnson, Contact Mechanics (1985), Sec. 13.1
  StressPlane at_depth(double depth,
                       InterfaceSide side = InterfaceSide::upper) const;

  /// The largest von Mises stress of the block and its place, from one spacing
  /// below the face down to half a side (or the far face): the longest wave is
  /// strongest at a sixth of a side. Planes a quarter deeper each and both
  /// sides of each interface, then Brent's search between the neighbours of the
  /// best in its layer. What lies within one spacing of the face is not looked
  /// at: a coating that thin, or the upper side of its interface.
  /// @par Accuracy  0.1 % in the stress, 1 % in the depth, of this pressure map
  StressPeak strongest() const;

private:
  struct Plane {
    std::size_t layer;
    double depth;
  };

  StressPlane stress_in(const Plane& plane) const;
  double strength_in(const Plane& plane) const;
  std::vector<Plane> planes_to_search(double shallowest, double deepest) const;
  std::span<const LayerStack::Wave> waves_of(std::size_t mode) const;

  Grid grid_;
  LayerStack stack_;
  RealFourier fourier_;
  std::vector<std::complex<double>> spectrum_; ///< of the pressure [Pa]
  /// A mode's layers side by side; empty for the half-space, whose are alike.
  std::vector<LayerStack::Wave> waves_;
};

} // namespace asperity::contact
