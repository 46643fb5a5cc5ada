#pragma once

// The surface operator of fields that equal their mirror images, on a quarter
// of the cell.

#include "base/ranks/mirrored_convolution.hpp"
#include "contact/operators/even_symbol.hpp"
#include "contact/operators/surface_operator.hpp"

#include <memory>
#include <span>
#include <vector>

namespace asperity::contact {

/// C of a cell whose pressures and displacements equal their mirror images
/// about its middle lines, as those of a mirrored map do: the surface of the
/// map between frictionless walls. The grid is quarter_of(the cell), and an
/// application costs a quarter.
class MirroredOperator final : public SurfaceOperator {
public:
  /// What does not change, shared by all clones.
  struct Symbol {
    std::shared_ptr<const EvenSymbol> compliance; ///< of the cell [m/Pa]
    double softest = 0.0;                         ///< largest compliance [m/Pa]
    double short_wave = 0.0;                      ///< see SurfaceTraits [m/Pa]
    /// That of the cell, for coarser grids.
    std::shared_ptr<const SurfaceOperator> whole;
  };

  /// @param symbol   of a cell of even numbers of points
  /// @param threads  >= 1
  MirroredOperator(Symbol symbol, int threads);

protected:
  std::unique_ptr<SurfaceOperator> do_clone() const override;
  void do_displacement(std::span<const double> pressure,
                       std::span<double> displacement) override;
  void do_displacement_change(std::span<const float> pressure_change,
                              std::span<float> displacement_change) override;
  void do_pressure_estimate(std::span<const float> gap, double local_compliance,
                            std::span<float> pressure) override;
  void do_pressure_of(std::span<const double> displacement,
                      std::span<double> pressure) override;
  std::unique_ptr<SurfaceOperator> do_coarsened() const override;

private:
  Symbol symbol_;
  MirroredConvolution<double> exact_;
  MirroredConvolution<float> convolution_;
};

/// Whether heights equal their mirror images about the middle lines of a grid,
/// to 1e-12 of the largest height.
/// @param heights  [m], grid.size() values
bool equals_mirror_images(std::span<const double> heights, const Grid& grid);

/// The first quarter of a field of a cell, quarter_of(cell).size() values.
/// @param whole  cell.size() values
/// @param cell   of even numbers of points
std::vector<double> first_quarter(std::span<const double> whole,
                                  const Grid& cell);

/// The field of a cell that equals its mirror images, cell.size() values, from
/// its first quarter.
std::vector<double> unfolded(std::span<const double> quarter, const Grid& cell);

} // namespace asperity::contact
