#pragma once

// The surface operator of an infinite half-space that is pressed inside a
// rectangle only: free boundaries, without periodic images.

#include "contact/operators/even_symbol.hpp"
#include "contact/operators/inverse_symbol.hpp"
#include "contact/operators/surface_operator.hpp"

#include <memory>
#include <vector>

namespace asperity::contact {

/// Displacement [m] of the surface of a half-space at the distance (x, y) from
/// the centre of a rectangle with the sides `side_x` and `side_y`, for a
/// uniform pressure of 1 Pa on it: the integral of 1/(pi E* r).
/// @param contact_modulus  E* [Pa] > 0
/// @par Accuracy  1e-12 of the value for a square at any distance
/// @see  K. L. Johnson, Contact Mechanics (1985), Eq. (3.25)
double rectangle_displacement(double x, double y, double side_x, double side_y,
                              double contact_modulus);

/// Twice the points and lengths in both directions: the grid of the convolution
/// without periodic images.
Grid padded_grid(const Grid& grid);

/// A quarter more points and lengths in both directions, for the
/// preconditioner. That of a coarse grid is the coarse one of this.
Grid grid_with_margin(const Grid& grid);

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
/// in both directions, whose added nodes have no pressure.
/// @see  R. W. Hockney, Methods Comput. Phys. 9, 135 (1970); S. Liu, Q. Wang,
///       G. Liu, Wear 243, 101 (2000)
class FreeHalfspace final : public SurfaceOperator {
public:
  /// @param contact_modulus  E* [Pa] > 0
  /// @param threads          as for FourierOperator
  /// @throws std::domain_error  an argument is outside its range
  FreeHalfspace(const Grid& grid, double contact_modulus, int threads = 1);

  std::unique_ptr<SurfaceOperator> clone() const override;

  const Grid& grid() const override;

  bool is_periodic() const override { return false; }

  std::span<const double> nodal_weights() const override { return {}; }

  void displacement(std::span<const double> pressure,
                    std::span<double> displacement) override;
  void displacement_change(std::span<const float> pressure_change,
                           std::span<float> displacement_change) override;

  /// The estimate inverts the convolution on the grid of twice as many points,
  /// for a gap that is 0 beyond the border. It is exact but for the pressure
  /// that this needs there.
  void pressure_estimate(std::span<const float> gap, double local_compliance,
                         std::span<float> pressure) override;
  /// A quarter more points in both directions: the displacements of pressures
  /// at distances up to 5/8 of the lengths are those of grid().
  const Grid& wide_grid() const override;
  void wide_pressure_estimate(std::span<const float> gap,
                              double local_compliance,
                              std::span<float> pressure) override;
  double short_wave_compliance() const override;

  int threads() const override { return exact_.threads(); }

  std::unique_ptr<SurfaceOperator> periodic_extension() const override;

  /// The operator with the same C of the wavevectors that it resolves, on half
  /// the points per side, as that of FourierOperator.
  std::unique_ptr<SurfaceOperator> coarsened() const override;

private:
  struct Shared; // immutable: transforms and symbol, shared by all clones
  explicit FreeHalfspace(std::shared_ptr<const Shared> shared);

  std::shared_ptr<const Shared> shared_;
  Convolution<double> exact_;
  Convolution<float> convolution_, wide_convolution_;
  InverseSymbol inverse_, wide_inverse_;
};

} // namespace asperity::contact
