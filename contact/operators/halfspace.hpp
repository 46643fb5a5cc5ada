#pragma once

// The continuum's surface compliance: isotropic half-space and slabs of finite
// thickness, frictionless face, a wavevector at a time.

#include "base/grid.hpp"
#include "contact/operators/fourier_operator.hpp"

#include <vector>

namespace asperity::contact {

/// What holds the far face of a slab. For waves (q > 0): clamped, no
/// displacement; sliding, no normal displacement and no shear; pressure, free.
enum class FarFace { clamped, sliding, pressure };

/// Compliance of a slab of thickness d relative to the half-space's, x = q d:
///
///     clamped   ((3-4 nu) sinh 2x - 2x)
///               / ((3-4 nu) cosh 2x + 2 x^2 + 5 - 12 nu + 8 nu^2)
///     sliding   (cosh 2x - 1) / (sinh 2x + 2x)
///     pressure  (sinh 2x + 2x) / (cosh 2x - 1 - 2 x^2)
///
/// All tend to 1 for x -> inf, within 4 x^2 exp(-2x).
/// @param reduced_wavevector  q d                                 [1] > 0
/// @param poisson_ratio       nu; clamped alone depends on it     [1] -1..0.5
/// @throws std::domain_error  an argument is outside its range
/// @par Accuracy  1e-14 relative for x > 0.1; below, the pressure and sliding
///            forms go through series, to 1e-12.
/// @see  K. L. Johnson, Contact Mechanics (1985), ch. 5; G. Carbone et al.,
///       J. Mech. Phys. Solids 56, 684 (2008)
double slab_compliance_factor(double reduced_wavevector, FarFace far_face,
                              double poisson_ratio);

/// A homogeneous, isotropic layer, bonded to what lies below it.
struct BondedLayer {
  double thickness = 0.0;      ///< [m] > 0
  double youngs_modulus = 0.0; ///< E [Pa] > 0
  double poisson_ratio = 0.0;  ///< nu [1], -1 < nu <= 0.5
};

/// An isotropic elastic block with a frictionless face, under bonded layers.
struct ElasticBlock {
  double contact_modulus = 0.0; ///< E* = E/(1 - nu^2) below the layers [Pa] > 0
  /// Below the layers; read where there are any or the far face is clamped.
  double poisson_ratio = 0.0;
  double thickness = 0.0; ///< layers included [m] > 0; infinity: the half-space
  FarFace far_face = FarFace::clamped;
  std::vector<BondedLayer> layers = {}; ///< the contact face's first
};

/// C(q) [m/Pa] on the half spectrum of the grid: 2 factor(q d) / (E* q), or
/// LayerStack's under layers; the uniform mode is set to 0.
/// @throws std::domain_error  a number of the block is outside its range
std::vector<double> block_compliance(const Grid& grid,
                                     const ElasticBlock& block);

/// The operator that goes with it.
FourierOperator halfspace_operator(const Grid& grid, const ElasticBlock& block,
                                   int threads = 1);

} // namespace asperity::contact
