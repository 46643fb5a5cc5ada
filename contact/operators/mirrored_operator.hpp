#pragma once

// The surface operator of pressures that equal their mirror images, on a
// quarter of the cell.

#include "base/mirrored_convolution.hpp"
#include "contact/operators/even_symbol.hpp"
#include "contact/operators/surface_operator.hpp"

#include <memory>

namespace asperity::contact {

/// C of a cell whose pressures and displacements equal their mirror images
/// about the borders of quarter_of(the cell), as those of a mirrored map do:
/// the surface of the map between frictionless walls. The grid is that quarter,
/// and an application costs a quarter.
class MirroredOperator final : public SurfaceOperator {
public:
  /// What does not change, shared by all clones.
  struct Symbol {
    std::shared_ptr<const EvenSymbol> compliance; ///< of the cell [m/Pa]
    double softest = 0.0;                         ///< largest compliance [m/Pa]
    double short_wave = 0.0;                      ///< see SurfaceTraits [m/Pa]
  };

  /// @param symbol   of a cell of even numbers of points
  /// @param threads  >= 1
  MirroredOperator(Symbol symbol, int threads);

protected:
  std::unique_ptr<SurfaceOperator> do_clone() const override;
  void do_displacement(std::span<const double> pressure,
                       std::span<double> displacement) override;
  void do_pressure_estimate(std::span<const float> gap, double local_compliance,
                            std::span<float> pressure) override;
  void do_pressure_of(std::span<const double> displacement,
                      std::span<double> pressure) override;

private:
  Symbol symbol_;
  MirroredConvolution<double> exact_;
  MirroredConvolution<float> estimate_;
};

} // namespace asperity::contact
