#pragma once

// The condensed Q2 block as an operator for the contact solver.

#include "base/fourier.hpp"
#include "contact/operators/surface_operator.hpp"
#include "fem/waves/condensed_q2.hpp"

#include <complex>
#include <memory>
#include <vector>

namespace asperity::fem {

/// Computes displacement = C pressure on all nodes of a Q2 surface with one
/// pair of transforms on the node grid: the amplitudes of the four node classes
/// at a cell wavevector q are the sums
///
///     p_k = sum_s (-1)^(s.k) F(q + s pi/h),   s, k in {0,1}^2,         (Q2.3)
///
/// over the four grid modes that alias to q; the inverse has an additional
/// factor 1/4.
class Q2Operator final : public contact::SurfaceOperator {
public:
  /// @param threads  used by each transform, >= 1
  explicit Q2Operator(Q2Compliance compliance, int threads = 1);

  std::unique_ptr<contact::SurfaceOperator> clone() const override;

  const Grid& grid() const override;

  /// The relative nodal areas: 4/9, 8/9, 8/9, 16/9 at vertices, edges and face
  /// centres.
  std::span<const double> nodal_weights() const override;

  void displacement(std::span<const double> pressure,
                    std::span<double> displacement) override;
  void displacement_change(std::span<const float> pressure_change,
                           std::span<float> displacement_change) override;
  void pressure_estimate(std::span<const float> gap, double local_compliance,
                         std::span<float> pressure) override;
  double short_wave_compliance() const override;
  int threads() const override;

  /// The operator on the vertices of the cells only, accurate for waves longer
  /// than a cell; null below 64 points per side or if the cells cannot be
  /// halved.
  std::unique_ptr<contact::SurfaceOperator> coarsened() const override;

private:
  struct Shared;
  explicit Q2Operator(std::shared_ptr<const Shared> shared);
  void apply(const std::vector<NodeClassBlock>& blocks,
             std::span<const double> field, std::span<double> result);
  void apply(const std::vector<NodeClassBlock>& blocks,
             std::span<const float> field, std::span<float> result);

  std::shared_ptr<const Shared> shared_;
  std::vector<std::complex<double>> spectrum_, product_;
  std::vector<double> field_;         ///< a change in double precision
  double inverted_compliance_ = -1.0; ///< local compliance of inverse_ [m/Pa]
  std::vector<NodeClassBlock> inverse_;
};

} // namespace asperity::fem
