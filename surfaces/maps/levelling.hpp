#pragma once

// This file removes the tilt and the second-order form (bow) that an instrument
// adds to a map.

#include "mechanics/surface_spec.hpp"
#include "surfaces/maps/height_map.hpp"

#include <span>
#include <vector>

namespace asperity::surfaces {

/// Subtracts the least-squares polynomial in x and y,
///
///     none   1
///     plane  1, x, y
///     bow    1, x, y, x^2, x y, y^2
///
/// or the sphere or cylinder of round_form.hpp,
///
/// so that at least the mean is removed. On a regular grid these polynomials
/// are spanned by products of the discrete Legendre polynomials of the two
/// sides, which are orthogonal: each coefficient is one projection and no
/// linear system is solved.
/// @par Accuracy  a few eps of the largest height before levelling
void remove_trend(HeightMap& map, mechanics::Levelling levelling);

/// One product of the discrete Legendre polynomials of the two sides.
struct TrendTerm {
  double factor = 0.0; ///< [m]
  int degree_x = 0;    ///< 0, 1 or 2
  int degree_y = 0;
};

/// The same for the rows of this process, with the bits of one process: each
/// projection is a sum over the rows in their order. Collective.
/// @param levelling  none, plane or bow
/// @return  what was subtracted, in this order
/// @throws std::domain_error  another levelling
std::vector<TrendTerm> remove_trend(const SharedRows& rows,
                                    std::span<double> heights,
                                    mechanics::Levelling levelling);

/// Subtracts such terms from other rows of the same map.
/// @param first    number of the first row
/// @param heights  whole rows of the grid [m]
void subtract_trend(const Grid& grid, std::span<const TrendTerm> terms,
                    int first, std::span<double> heights);

} // namespace asperity::surfaces
