#pragma once

// The block as input of every solver of this module: layers of elastic cells
// from the contact surface upwards, and the condition on the far boundary.

#include "base/grid.hpp"
#include "mechanics/far_boundary.hpp"
#include "mechanics/material.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace asperity::fem {

/// One layer of homogeneous, isotropic, linear elastic cells.
struct ElasticLayer {
  double thickness = 0.0;     ///< [m] > 0
  double lame_modulus = 0.0;  ///< lambda [Pa] > -2 mu / 3
  double shear_modulus = 0.0; ///< mu [Pa] > 0
};

/// A laterally uniform, periodic block in small-strain elasticity. The contact
/// surface carries no shear traction (frictionless contact).
struct LayeredBlock {
  std::vector<ElasticLayer> layers; ///< at least one; that of the contact
                                    ///< surface is first
  /// Condition on the far boundary. clamped: u = 0; sliding: u_z = 0 and no
  /// shear traction; pressure: a uniform normal traction that balances the
  /// contact pressure.
  mechanics::FarBoundary far_boundary = mechanics::FarBoundary::clamped;
};

/// Whether the far boundary fixes component 0..2 of the displacement to 0.
inline bool holds(mechanics::FarBoundary far_boundary, std::size_t component) {
  return far_boundary == mechanics::FarBoundary::clamped ||
         (far_boundary == mechanics::FarBoundary::sliding && component == 2);
}

/// Computes lambda [Pa] and mu [Pa] of a material.
/// @param youngs_modulus  E [Pa] > 0
/// @param poisson_ratio   nu [1], -1 < nu < 0.5
/// @throws std::domain_error  an argument is outside its range
ElasticLayer elastic_layer(double thickness, double youngs_modulus,
                           double poisson_ratio);

/// A block of one material in layers of the given thicknesses.
LayeredBlock homogeneous_block(std::span<const double> thickness,
                               double youngs_modulus, double poisson_ratio,
                               mechanics::FarBoundary far_boundary);

/// A block in layers of the given thicknesses, each of the material at its
/// mid-depth.
/// @param interfaces  depths of the interfaces between materials [m],
///                    increasing
/// @param moduli      moduli of the materials, starting at the contact surface;
///                    one more than interfaces
/// @throws std::domain_error  a modulus or a count is outside its range
LayeredBlock bonded_block(std::span<const double> thickness,
                          std::span<const double> interfaces,
                          std::span<const mechanics::BodyModuli> moduli,
                          mechanics::FarBoundary far_boundary);

/// Refuses a block without layers or with a layer outside the ranges of
/// ElasticLayer.
/// @throws std::domain_error  in these cases
void require_block(const LayeredBlock& block);

/// Refuses a grid that does not consist of the nodes of cells with a width of
/// `nodes_per_cell` node spacings.
/// @throws std::domain_error  in this case
void require_cells(const Grid& grid, int nodes_per_cell);

} // namespace asperity::fem
