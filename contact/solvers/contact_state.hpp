#pragma once

// The fields of one contact problem under the preconditioned iteration:
// pressure and displacement in double precision, what changes them in single.

#include "contact/solvers/solver.hpp"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace asperity::contact {

/// What the iteration may do with a node.
enum Freedom : std::uint8_t {
  fixed = 0,     ///< no pressure, no overlap
  gains = 1,     ///< overlaps without pressure: it may gain some
  may_shift = 2, ///< carries pressure
};

/// A direction's value at a node as its freedom allows.
inline float allowed(float value, std::uint8_t freedom) {
  const float gain = value < 0.0F ? value : 0.0F;
  const float limited = freedom > gains ? value : gain;
  return freedom > fixed ? limited : 0.0F;
}

/// Pressure, displacement and residual, kept consistent. Each operation is one
/// pass over the nodes with all the sums that it can take along.
class ContactState {
public:
  /// Checks the arguments and takes the start.
  /// @throws std::domain_error  see solve_contact
  ContactState(SurfaceOperator& elasticity, const ContactProblem& problem,
               const LoadTarget& target,
               std::span<const double> initial_pressure);

  /// Residual, rigid distance, error and kinds of nodes. Computes the
  /// displacement anew in double precision when the error has fallen so far
  /// that the single precision of the changes would show, and before the
  /// tolerance is believed.
  void update_residual();

  /// p = max(0, p - step * direction), C p to match. Where a pressure was cut
  /// the load is restored by scaling, at the cost of a transform pair.
  /// @param compliance_direction  C direction; overwritten
  void advance(float step, std::span<const float> direction,
               std::span<float> compliance_direction);

  /// Under pressure control the mean of a field over the free nodes: taken
  /// away from a direction it keeps the load. Else 0.
  float free_mean(std::span<const float> field) const;

  struct Slopes {
    double now = 0.0, change = 0.0;

    Slopes& operator+=(const Slopes& other) {
      now += other.now;
      change += other.change;
      return *this;
    }
  };

  /// r . z, and its part that is new since the last residual; z = field - mean
  /// as far as the nodes allow.
  Slopes slopes(std::span<const float> field, float mean) const;

  bool is_converged() const { return gap_error <= problem.gap_tolerance; }

  /// True at the tolerance, after the iterations allowed, or where an error
  /// that is not finite leaves nothing to go on from.
  bool is_at_end() const {
    return is_converged() || !std::isfinite(gap_error) ||
           iterations >= problem.max_iterations;
  }

  bool by_pressure() const {
    return target.kind == LoadTarget::Kind::nominal_pressure;
  }

  /// The state as the answer; says if it did not converge.
  ContactSolution solution() &&;

  SurfaceOperator& elasticity;
  ContactProblem problem;
  LoadTarget target;
  std::vector<double> pressure;      ///< p [Pa]
  std::vector<double> raw_gap;       ///< C p - h [m]
  std::vector<float> residual;       ///< gap + c p [m] on free nodes, else 0
  std::vector<std::uint8_t> freedom; ///< of each node
  double free_weight = 0.0;          ///< of the free nodes
  double gap_error = 0.0;            ///< [m]
  int iterations = 0;
  int transforms = 0;
  int threads = 1;
  double freed = 0.0; ///< nodes whose being free has changed, in all

private:
  struct ContactSums {
    double residual = 0.0, weight = 0.0;

    ContactSums& operator+=(const ContactSums& other) {
      residual += other.residual;
      weight += other.weight;
      return *this;
    }
  };

  void compute_raw_gap();
  void correct_cuts(std::span<float> change, double pressure_sum);
  ContactSums contact_sums() const;
  void measure_residual();

  double mean_height_ = 0.0;
  double rigid_distance_ = 0.0; ///< u [m]
  double computed_error_ = 0.0; ///< gap_error when C p was last computed
  bool is_computed_ = false;    ///< the raw gap holds no recurrence
  ContactSums contact_sums_;    ///< of raw_gap + c p where p > 0
  std::vector<float> previous_residual_;
};

} // namespace asperity::contact
