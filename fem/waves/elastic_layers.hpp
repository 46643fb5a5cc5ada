#pragma once

// The block as every solver of this room takes it: layers of elastic cells
// from the contact face up, and what holds the top.

#include "base/grid.hpp"
#include "cases/types/case.hpp"

#include <span>
#include <vector>

namespace asperity::fem {

/// One layer of cells: homogeneous, isotropic, linear elastic.
struct ElasticLayer {
  double thickness = 0.0;     ///< [m] > 0
  double lame_modulus = 0.0;  ///< lambda [Pa] > -2 mu / 3
  double shear_modulus = 0.0; ///< mu [Pa] > 0
};

/// A laterally uniform, periodic block of small-strain elasticity. The contact
/// face carries no shear traction (no friction).
struct LayeredBlock {
  std::vector<ElasticLayer> layers; ///< the contact face's first, >= 1
  /// clamped: u = 0 on top; sliding: u_z = 0, no shear traction; pressure: a
  /// uniform normal traction that balances the contact pressure.
  cases::TopFace top = cases::TopFace::clamped;
};

/// lambda [Pa] and mu [Pa] of a material.
/// @param youngs_modulus E  [Pa] > 0
/// @param poisson_ratio  nu [1]  -1 < nu < 0.5
/// @throws std::domain_error  an argument is outside its range
ElasticLayer elastic_layer(double thickness, double youngs_modulus,
                           double poisson_ratio);

/// One material in layers of these thicknesses.
LayeredBlock homogeneous_block(std::span<const double> thickness,
                               double youngs_modulus, double poisson_ratio,
                               cases::TopFace top);

/// Layers of these thicknesses, each of the material that its middle lies in.
/// @param interfaces  depths at which materials meet [m], rising
/// @param moduli      of the materials, the contact face's first: one more than
///                    interfaces
/// @throws std::domain_error  a modulus or a count is outside its range
LayeredBlock bonded_block(std::span<const double> thickness,
                          std::span<const double> interfaces,
                          std::span<const cases::BodyModuli> moduli,
                          cases::TopFace top);

/// Refuses a block without layers, or with one outside ElasticLayer's ranges.
/// @throws std::domain_error
void require_block(const LayeredBlock& block);

/// Refuses a grid that is not that of nodes of cells `nodes_per_cell` wide.
/// @throws std::domain_error
void require_cells(const Grid& grid, int nodes_per_cell);

} // namespace asperity::fem
