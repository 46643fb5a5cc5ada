#pragma once

// The linear step that all iterations on contact sets take.
// Include this header in .cpp files of fem/ only.

#include "fem/newton/contact_state.hpp"

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// How a step is taken.
struct StepAccuracy {
  double tolerance = 0.0;  ///< of the balance of forces, relative [1]
  int refinements = 0;     ///< steps before on the same contact set
  bool is_careful = false; ///< as ContactIteration says
};

/// Solves (F.1) for the changes of u, d and P on a fixed contact set, on which
/// it is linear:
///
///     (K + B^T s B) du_0 = -r,    (K + B^T s B) du_d = -B^T s,
///     (K + B^T s B) du_P = -g,    du = du_0 + du_d dd + du_P dP,
///
/// where r is the imbalance and s are springs, k a in contact; held points,
/// with infinite springs, move as the rigid surface does. dd and dP follow from
/// two scalar equations, the balance of all forces and the prescribed load or
/// mean gap. The responses to a unit of approach and of pressure are the same
/// in every step on one contact set, so their accuracy grows with the number of
/// refinements.
class LinearStep {
public:
  using Vector = ContactState::Vector;

  /// All arguments must outlive this object.
  LinearStep(const BlockSystem& system, BlockSolver& solver,
             ContactState& state);

  /// Begins a load step, whose progress is told to a watch.
  void begin(BlockWatch watch);

  /// Tells the progress after an iteration, as BlockProgress has it.
  void tell(int iterations, double imbalance, int changed_points);

  /// Takes the step. All ranks call it.
  /// @param springs  [N/m] >= 0
  /// @param held     points that are held at the surface
  /// @return         false if the linear solver failed; the state is then as
  ///                 before, except P under a prescribed load
  bool take(const mechanics::LoadTarget& load, std::span<const double> springs,
            const ContactSet& held, const StepAccuracy& accuracy);

  /// As ContactNewton::response_to_approach().
  const Vector& response_to_approach() const { return by_approach_; }

  /// The same, from which the next step starts to find its own.
  Vector& response_to_approach() { return by_approach_; }

  double approach_stiffness() const { return approach_stiffness_; }

private:
  /// Bounds on the residual of a linear solve.
  struct Range {
    double finest = 0.0;
    double coarsest = std::numeric_limits<double>::infinity();
    double share = 1.0; ///< fraction of the usual relative tolerance
  };

  void tell_linear();
  double relative_tolerance(bool has_wall) const;
  double stiffness_of(std::span<const double> springs) const;
  bool solve_for(Vector& answer, const Vector& forces,
                 std::span<const double> held_displacement, const Range& range);
  bool solve(const mechanics::LoadTarget& load, std::span<const double> springs,
             const ContactSet& held, const StepAccuracy& accuracy);
  bool solve_scalars(const mechanics::LoadTarget& load,
                     std::span<const double> springs, const ContactSet& held);

  const BlockSystem& system_;
  BlockSolver& solver_;
  ContactState& state_;
  BlockWatch watch_;
  BlockProgress progress_;
  int iterations_before_ = 0; ///< CG iterations of earlier load steps
  bool is_careful_ = false;
  // Responses in the last step, used as initial guesses in the next one.
  Vector by_imbalance_, by_approach_, by_far_pressure_;
  double approach_stiffness_ = 0.0; ///< the force of by_approach_ [N/m]
};

} // namespace asperity::fem
