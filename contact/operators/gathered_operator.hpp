#pragma once

// Makes an operator of whole fields from one whose rows ranks share.

#include "contact/operators/surface_operator.hpp"

#include <memory>
#include <span>
#include <vector>

namespace asperity::contact {

/// The operator of a shared one on every rank, for fields of all nodes: each
/// application takes the own rows of its argument, which must be the same on
/// all ranks, and gathers the answers. It has the bits of one process. All
/// calls that transform fields are collective, also the construction. It needs
/// whole fields on each rank, and is meant for small parts of a solution that
/// are not shared.
class GatheredOperator final : public SurfaceOperator {
public:
  /// @param shared  its shared_rows() are not null
  explicit GatheredOperator(std::unique_ptr<SurfaceOperator> shared);

  std::unique_ptr<SurfaceOperator> clone() const override;

  const Grid& grid() const override { return shared_->grid(); }

  bool is_periodic() const override { return shared_->is_periodic(); }

  std::span<const double> nodal_weights() const override { return weights_; }

  void displacement(std::span<const double> pressure,
                    std::span<double> displacement) override;
  void displacement_change(std::span<const float> pressure_change,
                           std::span<float> displacement_change) override;
  void pressure_estimate(std::span<const float> gap, double local_compliance,
                         std::span<float> pressure) override;

  double short_wave_compliance() const override {
    return shared_->short_wave_compliance();
  }

  bool is_shift_invariant() const override {
    return shared_->is_shift_invariant();
  }

  int threads() const override { return shared_->threads(); }

private:
  std::unique_ptr<SurfaceOperator> shared_;
  std::vector<double> weights_; ///< of all nodes
};

} // namespace asperity::contact
