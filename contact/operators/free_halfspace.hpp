#pragma once

// The surface operator of an infinite half-space that is pressed inside a
// rectangle only: free boundaries, without periodic images.

#include "contact/operators/fourier_operator.hpp"

namespace asperity::contact {

/// Displacement [m] of the surface of a half-space at the distance (x, y) from
/// the centre of a rectangle with the sides `side_x` and `side_y`, for a
/// uniform pressure of 1 Pa on it: the integral of 1/(pi E* r).
/// @param contact_modulus  E* [Pa] > 0
/// @par Accuracy  1e-12 of the value for a square at any distance
/// @see  K. L. Johnson, Contact Mechanics (1985), Eq. (3.25)
double rectangle_displacement(double x, double y, double side_x, double side_y,
                              double contact_modulus);

/// rectangle_displacement() around one pressed cell of a periodic grid. Its
/// transform is positive: that of the continuum, which is, differs from it by a
/// few per cent at long and by half at the shortest waves.
/// @param contact_modulus  E* [Pa] > 0
EvenSymbol::KernelRow rectangle_kernel(const Grid& wide,
                                       double contact_modulus);

/// The half-space under a pressure that is 0 outside the rectangle of the grid
/// and uniform in the cell around each node. The displacement, which vanishes
/// at infinity, is the sum of rectangle_displacement() over the nodes, without
/// approximation: the convolution is periodic on a grid of twice as many points
/// in both directions, whose added nodes have no pressure. The preconditioner
/// has a quarter more points in both directions: the displacements of pressures
/// at distances up to 5/8 of the lengths are those of the grid.
/// @see  R. W. Hockney, Methods Comput. Phys. 9, 135 (1970); S. Liu, Q. Wang,
///       G. Liu, Wear 243, 101 (2000)
/// @param contact_modulus  E* [Pa] > 0
/// @param threads          as for FourierOperator
/// @throws std::domain_error  an argument is outside its range
FourierOperator free_halfspace(const Grid& grid, double contact_modulus,
                               int threads = 1);

} // namespace asperity::contact
