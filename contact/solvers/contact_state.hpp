#pragma once

// The state of one contact problem: pressure and gap in double precision,
// residual and changes in single precision.

#include "contact/solvers/contact_problem.hpp"
#include "contact/solvers/node_blocks.hpp"
#include "contact/solvers/node_kernels.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace asperity::contact {

/// Pressure, displacement and residual, kept consistent, the error that is left
/// and the counts. Each operation passes over the active blocks of nodes and
/// accumulates the sums needed later; only the gap is read and written at every
/// node, once per change of pressure.
class ContactState {
public:
  /// Checks the arguments and sets the initial state.
  /// @throws std::domain_error  see solve_contact
  ContactState(SurfaceOperator& elasticity, const ContactProblem& problem,
               const mechanics::LoadTarget& target,
               std::vector<double> initial_pressure);

  bool by_pressure() const {
    return target.control == mechanics::Control::nominal_pressure;
  }

  bool is_converged() const { return gap_error <= problem.gap_tolerance; }

  /// True if the tolerance is met, if the iteration limit is reached, or if the
  /// error is not finite.
  bool is_at_end() const;

  /// Updates the residual gap + c p, the separation u (under pressure control
  /// it makes the mean residual over the contact vanish), the error and the
  /// node classes. The displacement is recomputed in double precision when the
  /// error has fallen so far that the single precision of the changes would
  /// matter, and before convergence is accepted.
  void update_residual();

  /// Sets p = max(0, p - step * direction) and updates C p. If a pressure was
  /// set to 0, a prescribed load is restored by scaling, and the change of C p
  /// is computed from that of p, which costs one application of C. C direction
  /// is in compliance_direction(), and is overwritten. With a
  /// hardness the scaled pressures are cut off there, and the factor is such
  /// that the load is restored then.
  void advance(float step, std::span<float> direction);

  /// Replaces the pressure by another one at the load of the target.
  void set_pressure(std::vector<double> other);

  /// The fields for the loops over nodes.
  NodeFields fields();

  /// Memory for the preconditioner, of change() and compliance_direction(). An
  /// application of C in double precision overwrites it.
  std::span<float> work() { return unset_part(2, work_size_); }

  /// The last change of the pressure [Pa], which advance() sets: before, the
  /// preconditioned residual.
  std::span<float> change() { return unset_part(2, pressure.size()); }

  std::span<float> compliance_direction() {
    return unset_part(3, pressure.size());
  }

  /// Sets compliance_direction() to C of a direction, or of change(), which is
  /// lost.
  void displace(std::span<const float> pressure_change);

  /// Adds loop(range) -> Sums over the active blocks.
  template <class Sums, class Loop>
  Sums sum(const Loop& loop) const {
    return flagged_sum<Sums>(active, pressure.size(), workers, loop);
  }

  /// The state as a solution; its note says if it did not converge.
  ContactSolution solution() &&;

  SurfaceOperator& elasticity;
  ContactProblem problem;
  mechanics::LoadTarget target;
  Workers workers;
  std::vector<double> pressure; ///< p [Pa]
  std::vector<double> raw_gap;  ///< C p - h [m]
  double rigid_distance = 0.0;  ///< u [m]
  double gap_error = 0.0;       ///< [m]
  int iterations = 0;
  int transforms = 0;

  std::span<float> residual;         ///< gap + c p [m] on active nodes, else 0
  std::vector<std::uint8_t> freedom; ///< Freedom of each node
  double free_weight = 0.0;          ///< total weight of the active nodes
  /// Blocks with an active node. Residual and freedom are 0 in the others.
  BlockFlags active;
  double freed = 0.0; ///< cumulative number of changes of the active set

protected:
  /// Computes raw_gap from the pressure by one application of C.
  void compute_gap();
  /// Sets raw_gap, which contains an updated C p, to C p - h.
  void subtract_heights_from_gap();

private:
  std::span<float> unset_part(std::size_t i, std::size_t size);
  void add_to_gap(double factor, std::span<const float> field);
  void restore_load(double pressure_sum);
  AdvancedLoad load_after(const NodeFields& all, const Advance& way) const;
  bool stays_below(const NodeFields& all, const Advance& way) const;
  double load_factor(const NodeFields& all, double step) const;
  void press_more_nodes();
  double separation_at_bounds() const;
  float product_scale() const;
  void measure_residual();

  std::size_t work_size_;
  /// Memory of the residuals and of work(), which are written before they are
  /// read; the inactive blocks of the residuals and of the change are set to 0
  /// then.
  std::unique_ptr<float[]> unset_;
  double mean_height_ = 0.0;    ///< under gap control [m]
  double computed_error_ = 0.0; ///< gap_error when C p was last recomputed
  bool is_computed_ = false;    ///< C p was recomputed, not updated
  TwoSums contact_sums_;        ///< see change_gap()
  BlockFlags written_;          ///< blocks where `residual` may differ from 0
  BlockFlags previous_written_;
  std::vector<double> lowest_; ///< raw_gap of each block that is inactive [m]
  std::span<float> previous_residual_;
};

} // namespace asperity::contact
