#pragma once

// This file contains the surface operator of a laterally homogeneous block: a
// convolution with one real compliance per wavevector. The operator owns its
// transforms.

#include "base/convolution.hpp"
#include "contact/operators/surface_operator.hpp"

#include <memory>
#include <vector>

namespace asperity::contact {

/// The operator displacement(q) = C(q) pressure(q), used for the half-space,
/// the elastic slab, the condensed linear finite-element block and the atomic
/// lattice.
class FourierOperator final : public SurfaceOperator {
public:
  /// @param compliance  C(q) [m/Pa], grid.half_spectrum_size() values in the
  ///                    order of Grid::half_spectrum_size; > 0 and finite
  ///                    except for the uniform mode (0, 0), which is not read
  /// @param threads     number used by each application, >= 1; the result does
  ///                    not depend on it
  /// @throws std::domain_error  an array has the wrong size or a value is
  ///                            outside its range
  FourierOperator(const Grid& grid, std::vector<double> compliance,
                  int threads = 1);

  std::unique_ptr<SurfaceOperator> clone() const override;

  const Grid& grid() const override;

  std::span<const double> nodal_weights() const override { return {}; }

  void displacement(std::span<const double> pressure,
                    std::span<double> displacement) override;
  void displacement_change(std::span<const float> pressure_change,
                           std::span<float> displacement_change) override;
  void pressure_estimate(std::span<const float> gap, double local_compliance,
                         std::span<float> pressure) override;
  double short_wave_compliance() const override;

  bool is_shift_invariant() const override { return true; }

  int threads() const override;

  /// The operator on half the points per side, which keeps C(q) of the
  /// wavevectors that the coarse grid resolves. Null if the number of points is
  /// odd or the coarse grid would have fewer than 32 points per side.
  std::unique_ptr<SurfaceOperator> coarsened() const override;

  /// C(q) [m/Pa] as given; the value at (0, 0) has no meaning.
  std::span<const double> compliance() const;

private:
  struct Shared; // immutable: transforms and symbol, shared by all clones
  explicit FourierOperator(std::shared_ptr<const Shared> shared);

  std::shared_ptr<const Shared> shared_;
  Convolution<double>::Scratch exact_scratch_;
  Convolution<float>::Scratch scratch_;
  double inverted_compliance_ = -1.0; ///< local compliance in inverse_ [m/Pa]
  Convolution<float>::Symbol inverse_;
};

} // namespace asperity::contact
