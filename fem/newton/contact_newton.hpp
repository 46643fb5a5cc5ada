#pragma once

// The contact problem of a block, one load step after another.
// Include this header in .cpp files of fem/ only.

#include "fem/newton/contact_iteration.hpp"
#include "fem/newton/contact_state.hpp"
#include "fem/newton/spring_newton.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// Solves hard contact at nodes:
///
///     (u, d, P) = the linear step with the points of A held at gap = 0,
///     p = constraint force per area on A, 0 elsewhere,
///     A <- {c in A : p_c >= 0} + {c not in A : gap_c < 0},
///
/// until A does not change and the forces balance. Points of a perfectly
/// plastic block that are too few for the load have no such step: the approach
/// grows without bound. Where the material flows, a step therefore ends where
/// so many other points touch that A grows by a quarter.
class ActiveSet {
public:
  /// Both must outlive this object.
  ActiveSet(ContactState& state, LinearStep& step)
      : state_(state), step_(step) {}

  /// Iterates, and counts the iterations of the answer. Returns whether the
  /// active set was found; if not, the note of the answer gives the reason. The
  /// pressure is not negative.
  /// @param gap_tolerance  [m] > 0
  bool solve(const mechanics::LoadTarget& load, const BlockContact& contact,
             double gap_tolerance, BlockSolution& answer);

private:
  bool iterate(const mechanics::LoadTarget& load, const BlockContact& contact,
               double gap_tolerance, BlockSolution& answer);
  void take_pressure(const ContactSet& active);
  void shorten_step(const ContactState::Placement& before,
                    const ContactSet& active);
  ContactSet next_active(const ContactSet& active, const BlockContact& contact,
                         double gap_tolerance) const;

  ContactState& state_;
  LinearStep& step_;
};

/// As FullBlock::stiffness(), of nodes that touch. Collective.
ContactStiffness contact_stiffness(const BlockSystem& system,
                                   BlockSolver& solver,
                                   const ContactSet& touching);

/// The state of the contact problem from which another mesh starts.
struct ContactStart {
  ContactState::Vector displacement; ///< u [m], with zeros at constrained
                                     ///< unknowns
  std::vector<double> pressure;      ///< of this rank's points [Pa] >= 0
  double rigid_gap = 0.0;            ///< as ContactState::rigid_gap [m]
  double highest = 0.0;              ///< [m]
  double far_pressure = 0.0;         ///< on the far boundary [Pa]
};

/// Solves (F.1) of full_block.hpp over the points of all ranks:
///
/// - ContactState has the unknowns and what follows from them: gaps, forces,
///   their imbalance, the violation of the contact law.
/// - LinearStep solves the equations on a fixed contact set.
/// - ContactIteration has the rules by which a contact set is searched.
/// - SpringNewton finds the contact set of springs, also where full steps
///   cycle.
/// - AugmentedLagrangian makes penalties beyond the precision of a double, and
///   hard contact, of such springs.
/// - ActiveSet finds hard contact at nodes by constraints. If it does not, the
///   augmented Lagrangian continues: its solution is the same.
///
/// A load step at a mean gap at which nothing touches needs none of them.
class ContactNewton {
public:
  using Vector = ContactState::Vector;

  /// @param system must outlive this object
  ContactNewton(const BlockSystem& system, LinearSolver linear_solver,
                std::unique_ptr<BlockInverse> inverse = {});

  ContactNewton(const ContactNewton&) = delete; // its parts refer to each other
  ContactNewton& operator=(const ContactNewton&) = delete;

  /// Solves, starting from the state at the end of the last call, and writes
  /// all results that are not fields into the answer.
  /// @param heights       heights of this rank's points [m]
  /// @param height_scale  the tolerance of a gap is relative to this scale [m]
  ///                      > 0
  void solve(std::vector<double> heights, double height_scale,
             const mechanics::LoadTarget& load, const BlockContact& contact,
             BlockSolution& answer);

  /// What the next load step starts from if the material has a law, as
  /// numbers of this rank; empty for a linear block, which has no history.
  std::vector<double> memory() const;

  /// Continues from the memory of an equal block with the same results, bit for
  /// bit. Returns false, and changes nothing, if it is that of other ranks.
  bool recall(std::span<const double> memory);

  /// Replaces the state from which the next solution starts.
  void start_from(ContactStart start);

  /// Computes u under given pressures [Pa] at this rank's points, balanced by
  /// the load on the far boundary. The state does not change. Returns false if
  /// CG did not converge.
  [[nodiscard]] bool solve_linear(std::span<const double> pressure,
                                  Vector& displacement);

  /// As FullBlock::stiffness().
  ContactStiffness stiffness() {
    return contact_stiffness(system_, solver_, contact_set(state_.pressure));
  }

  const ContactState& state() const { return state_; }

  /// The response of the block to a unit of approach, for the points in contact
  /// in the last step [1], with zeros at constrained unknowns, and the force
  /// that it takes [N/m]; zero before the first step.
  const Vector& response_to_approach() const {
    return step_.response_to_approach();
  }

  double approach_stiffness() const { return step_.approach_stiffness(); }

private:
  void search(double height_scale, const mechanics::LoadTarget& load,
              const BlockContact& contact, BlockSolution& answer);
  void search_material(double height_scale, const mechanics::LoadTarget& load,
                       const BlockContact& contact, BlockSolution& answer);
  bool search_part(double height_scale, double nominal_pressure,
                   const BlockContact& contact, BlockSolution& answer);
  void search_wall(double height_scale, const mechanics::LoadTarget& load,
                   const BlockContact& contact, BlockSolution& answer);
  void add_up(const BlockContact& contact, BlockSolution& answer) const;
  void judge(double tolerance, BlockSolution& answer);
  std::string why_unbalanced(double tolerance, double residual) const;

  const BlockSystem& system_;
  BlockSolver solver_;
  ContactState state_;
  LinearStep step_;
  SpringNewton newton_;
  AugmentedLagrangian augmented_;
  ActiveSet active_set_;
  double carried_ = 0.0; ///< the load whose state of the material is known [Pa]
};

} // namespace asperity::fem
