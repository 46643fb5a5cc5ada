#pragma once

// The whole block's contact problem and the state its Newton iteration moves.
// Include from .cpp files of fem/ only.

#include "fem/block_solver.hpp"
#include "fem/block_system.hpp"
#include "fem/full_block.hpp"

#include <vector>

namespace asperity::fem {

/// (F.1) and its solver; newton_block.cpp has one Newton solve at fixed
/// multipliers, full_block.cpp what stands around it.
class NewtonBlock final : public FullBlock {
public:
  NewtonBlock(const Grid& grid, int degree, const LayeredBlock& block,
              LinearSolver linear_solver);

  const Grid& grid() const override { return system_.grid(); }

  std::size_t unknowns() const override { return system_.n_unknowns(); }

  std::span<const double> nodal_weights() const override { return weights_; }

  std::vector<double> displacement(std::span<const double> pressure) override;

  BlockSolution solve(std::span<const double> heights, const BlockLoad& load,
                      const BlockContact& contact) override;

private:
  double face_displacement(std::size_t i) const {
    return displacement_(system_.face_unknowns()[i]);
  }

  double gap(std::size_t i) const {
    return rigid_gap_ + face_displacement(i) - heights_[i];
  }

  double mean_gap() const;
  double touching_gap(double nominal_pressure, double penalty) const;
  void take_heights(std::span<const double> heights);
  double own_spring(const BlockContact& contact) const;
  void update_pressure(double penalty);
  std::vector<bool> contact_set() const;
  void find_imbalance();
  double unbalanced();
  bool newton_step(const BlockLoad& load, double penalty);
  bool newton(const BlockLoad& load, const BlockContact& contact,
              BlockSolution& answer);
  double violation(double compliance) const;
  void record(BlockSolution& answer);

  BlockSystem system_;
  BlockSolver solver_;
  std::vector<double> weights_;
  double stiffness_scale_; ///< shear modulus of the face over the spacing
  // The state (F.1) is solved for.
  dealii::Vector<double> displacement_; ///< u [m]
  double rigid_gap_ = 0.0;              ///< d less the highest height [m]
  double highest_ = 0.0;                ///< [m]
  double top_pressure_ = 0.0;           ///< P [Pa]
  std::vector<double> multiplier_;
  std::vector<double> pressure_;
  std::vector<double> heights_;      ///< less the highest [m]
  dealii::Vector<double> imbalance_; ///< K u + P g - sum a p e [N]
};

} // namespace asperity::fem
