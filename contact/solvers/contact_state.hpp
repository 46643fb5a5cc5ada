#pragma once

// The fields of one contact problem in the preconditioned iteration: pressure
// and displacement in double precision, their changes in single precision.

#include "contact/solvers/iteration.hpp"
#include "contact/solvers/node_blocks.hpp"
#include "contact/solvers/node_kernels.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace asperity::contact {

/// Pressure, displacement and residual, kept consistent. Each operation passes
/// over the active blocks of nodes and accumulates the sums needed later; only
/// the gap is read and written at every node, once per change of pressure.
class ContactState : public Iteration {
public:
  /// Checks the arguments and sets the initial state.
  /// @throws std::domain_error  see solve_contact
  ContactState(SurfaceOperator& elasticity, const ContactProblem& problem,
               const mechanics::LoadTarget& target,
               std::vector<double> initial_pressure);

  /// Updates the residual, the separation u, the error and the node classes.
  /// The displacement is recomputed in double precision when the error has
  /// fallen so far that the single precision of the changes would matter, and
  /// before convergence is accepted.
  void update_residual();

  /// Sets p = max(0, p - step * direction) and updates C p. If a pressure was
  /// set to 0, a prescribed load is restored by scaling, and the change of C p
  /// is computed from that of p, which costs one application of C.
  /// @param compliance_direction  C direction; overwritten
  void advance(float step, std::span<float> direction,
               std::span<float> compliance_direction);

  /// Mean of a field over the active nodes under pressure control, otherwise 0.
  /// Subtracting it from a direction preserves the load.
  float free_mean(std::span<const float> field);

  /// Computes r . z and the part of it due to the change of the residual;
  /// z = field - mean, restricted to the changes allowed.
  TwoSums slopes(std::span<const float> field, float mean);

  /// The fields for the loops over nodes.
  NodeFields fields();

  /// The state as a solution; its note says if it did not converge.
  ContactSolution solution() &&;

  std::vector<double> raw_gap;       ///< C p - h [m]
  std::span<float> residual;         ///< gap + c p [m] on active nodes, else 0
  std::vector<std::uint8_t> freedom; ///< Freedom of each node
  double free_weight = 0.0;          ///< total weight of the active nodes
  Workers workers;
  /// Blocks with an active node. Residual and freedom are 0 in the others.
  BlockFlags active;
  double freed = 0.0; ///< cumulative number of changes of the active set

private:
  std::span<float> unset_part(std::size_t i);
  void compute_raw_gap();
  /// raw_gap += factor * field
  void add_to_gap(double factor, std::span<const float> field);
  void restore_load(double pressure_sum);
  float product_scale() const;
  void measure_residual();

  /// Memory of three fields of floats, which are written before they are read;
  /// their inactive blocks are set to 0 then.
  std::unique_ptr<float[]> unset_;
  double mean_height_ = 0.0;    ///< under gap control [m]
  double rigid_distance_ = 0.0; ///< u [m]
  double computed_error_ = 0.0; ///< gap_error when C p was last recomputed
  bool is_computed_ = false;    ///< C p was recomputed, not updated
  TwoSums contact_sums_;        ///< see change_gap()
  BlockFlags written_;          ///< blocks where `residual` may differ from 0
  BlockFlags previous_written_;
  std::vector<double> lowest_; ///< raw_gap of each block that is inactive [m]
  std::span<float> change_;    ///< of the pressure in the last iteration [Pa]
  BlockFlags change_written_;  ///< blocks where `change_` may differ from 0
  std::span<float> previous_residual_;
};

} // namespace asperity::contact
