#pragma once

// The stress below the face of a continuum block, from the pressure on it, a
// plane of constant depth at a time. Owns the decay of each wave with depth.

#include "base/fourier.hpp"
#include "base/grid.hpp"
#include "contact/halfspace.hpp"

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

/// Where the block is strained most.
struct StressPeak {
  double von_mises = 0.0; ///< [Pa]
  double depth = 0.0;     ///< below the face [m]
  std::size_t node = 0;   ///< Grid::index of the column it lies in
};

/// One pressure map on one block. A wave p exp(iqx) on the frictionless face
/// is plane strain in the plane of q and z, with Airy's function
/// (p/q^2) f(q z):
///
///     sigma_zz = -f p,  sigma_qq = f'' p,  sigma_zq = -i f' p,
///     sigma_tt = nu (sigma_qq + sigma_zz),      f(0) = 1, f'(0) = 0
///
/// and f = (1 + x) exp(-x) in the half-space; in a slab the far face gives
/// the two other conditions. The uniform pressure makes sigma_zz = -p_0 and
/// sigma_xx = sigma_yy = -nu/(1-nu) p_0: the block's sides do not move.
class StressInside {
public:
  /// @param block     poisson_ratio is read for every far face, -1 < nu <= 0.5
  /// @param pressure  [Pa], grid.size() values, as a solver gives them
  /// @throws std::domain_error  a size or a number is outside its range
  StressInside(const Grid& grid, const ElasticBlock& block,
               std::span<const double> pressure, int threads = 1);

  /// @param depth  z [m], 0..thickness
  /// @throws std::domain_error  depth is outside
  /// @par Accuracy  rounding for the pressure as a sum of waves: within two
  ///            spacings of the face what the grid cannot resolve is missing
  /// @see  K. L. Johnson, Contact Mechanics (1985), Sec. 13.1
  StressPlane at_depth(double depth) const;

  /// The largest von Mises stress of the block and its place, from one spacing
  /// below the face down to half a side (or the far face): the longest wave is
  /// strongest at a sixth of a side. Planes a quarter deeper each, then Brent's
  /// search between the neighbours of the best.
  /// @par Accuracy  0.1 % in the stress, 1 % in the depth, of this pressure map
  StressPeak strongest() const;

private:
  /// f = (a + b x) exp(-x) + (c + d y) exp(-y), x = q z, y = q (thickness - z).
  struct Decay {
    double a = 1.0;
    double b = 1.0;
    double c = 0.0;
    double d = 0.0;
  };

  struct Wave {
    double stress_zz, stress_qq, stress_zq; ///< -f, f'', -f' at one depth
  };

  Decay decay_of(double wavevector) const;
  Wave wave_at(std::size_t mode, double wavevector, double depth) const;
  std::vector<double> von_mises_at(double depth) const;

  Grid grid_;
  ElasticBlock block_;
  RealFourier fourier_;
  std::vector<std::complex<double>> spectrum_; ///< of the pressure [Pa]
  std::vector<Decay> decays_;                  ///< of a slab; else empty
};

} // namespace asperity::contact
