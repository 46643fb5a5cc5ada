#pragma once

// The rules of the iterations that search a contact set: Newton's method with
// springs and the active-set method.
// Include this header in .cpp files of fem/ only.

#include "fem/newton/linear_step.hpp"

#include <limits>

namespace asperity::fem {

/// Counts the steps of an iteration on contact sets, of which each solves
/// (F.1) on a fixed set, and follows three rules.
///
/// 1. The iteration ends when the set is unchanged and the forces balance. A
///    step on an unchanged set reduces the error that the linear solver, or the
///    roundoff of a large step, has left; eight of them gain all accuracy that
///    there is.
/// 2. Full steps find a contact set within some ten, or cycle. After twelve
///    that changed the set, Newton's method shortens its steps under a
///    prescribed load, as it always does where the material flows, and
///    approaches a prescribed mean gap, which minimises no energy, by loads.
///    The active-set method ends after thirty.
/// 3. In strongly heterogeneous blocks, and with much softer counter-bodies,
///    the error of a linear solution may be a pressure of many times the load.
///    Linear systems are therefore solved with care after the fourth step of
///    Newton's method that changed the set, and after twelve steps of the
///    active-set method, whose constraints amplify no error.
/// 4. Where the material is not elastic, an imbalance on an unchanged set is
///    also that of its linearised law. A step counts as one that changed the
///    set unless it halves the smallest imbalance so far; thirty of them in a
///    row end the iteration.
class ContactIteration {
public:
  static constexpr int most_refinements = 8;
  static constexpr int most_full_steps = 12;
  static constexpr int most_loose_steps = 4;
  static constexpr int most_active_sets = 30;
  static constexpr int most_idle_steps = 30;

  /// @param tolerance  of the balance of forces, relative [1] > 0
  explicit ContactIteration(double tolerance) : tolerance_(tolerance) {}

  /// Whether full steps do not find the contact set.
  bool is_cycling() const { return changes_ >= most_full_steps; }

  /// Takes full steps again, or those of a set that is hard to find.
  void take_full_steps() { changes_ = 0; }

  void expect_cycles() { changes_ = most_full_steps; }

  /// How the next step of Newton's method is taken.
  StepAccuracy accuracy_on_springs() const {
    return {tolerance_, refinements_, changes_ >= most_loose_steps};
  }

  /// How the next step of the active-set method is taken, after so many.
  StepAccuracy accuracy_on_wall(int steps) const {
    return {tolerance_, refinements_, steps >= most_full_steps};
  }

  /// Counts a step that changed so many points of the contact set and left
  /// this imbalance, and after which the material may be elastic. Returns
  /// whether it was the last one.
  bool has_ended(int changed, double imbalance, bool is_elastic) {
    if (changed != 0) {
      refinements_ = 0;
      ++changes_;
      return false;
    }
    if (!is_elastic)
      return has_settled(imbalance);
    return imbalance <= tolerance_ || refinements_++ == most_refinements;
  }

private:
  /// Counts a step on an unchanged set where the material is not elastic.
  bool has_settled(double imbalance) {
    if (imbalance <= 0.5 * least_imbalance_) {
      least_imbalance_ = imbalance;
      idle_ = 0;
    } else {
      ++idle_;
      ++changes_;
    }
    return imbalance <= tolerance_ || idle_ == most_idle_steps;
  }

  double tolerance_;
  double least_imbalance_ = std::numeric_limits<double>::infinity();
  int idle_ = 0;        ///< steps that did not halve it
  int changes_ = 0;     ///< steps that changed the set
  int refinements_ = 0; ///< steps since then
};

} // namespace asperity::fem
