#pragma once

// The surface operator of a block that looks the same at every node: a
// convolution, one real compliance a wavevector. Owns its transforms.

#include "base/convolution.hpp"
#include "contact/operators/surface_operator.hpp"

#include <memory>
#include <vector>

namespace asperity::contact {

/// displacement(q) = C(q) pressure(q): the half-space, the elastic slab, the
/// condensed linear finite-element block and the lattice.
class FourierOperator final : public SurfaceOperator {
public:
  /// @param compliance  C(q) [m/Pa], grid.half_spectrum_size() values in the
  ///                    order of Grid::half_spectrum_size; > 0 and finite but
  ///                    for the uniform mode (0, 0), which is not read
  /// @param threads     used by each application, >= 1; changes no bit
  /// @throws std::domain_error  wrong size, or a value outside its range
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
  int threads() const override;

  /// The long waves of C(q) on half the points; null below 32 points a side
  /// or for an odd number.
  std::unique_ptr<SurfaceOperator> coarsened() const override;

  /// C(q) [m/Pa] as given; the value at (0, 0) means nothing.
  std::span<const double> compliance() const;

private:
  struct Shared; // immutable: transforms and symbol
  explicit FourierOperator(std::shared_ptr<const Shared> shared);

  std::shared_ptr<const Shared> shared_;
  Convolution<double>::Scratch exact_scratch_;
  Convolution<float>::Scratch scratch_;
  double inverted_compliance_ = -1.0; ///< local compliance of inverse_ [m/Pa]
  Convolution<float>::Symbol inverse_;
};

} // namespace asperity::contact
