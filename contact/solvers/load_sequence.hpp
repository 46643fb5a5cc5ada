#pragma once

// Computes a loading path on one surface: it contains the contact laws, the
// initial guess of each step, its solution and the saved state of earlier
// steps.

#include "contact/solvers/contact_problem.hpp"
#include "contact/solvers/free_adhesion.hpp"
#include "mechanics/contact_law.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace asperity::contact {

/// Solves one load step after another. The initial guess of a step is
///
/// - after two earlier steps: their extrapolation to the new load, of the
///   pressures in contact and of the gaps elsewhere: where a gap closes, new
///   contact begins. It is linear in the logarithm of a prescribed pressure and
///   in a prescribed mean gap. If its residual is larger than five times the
///   rms of half the second differences of the heights, the coarse-to-fine
///   guess below is better and replaces it;
/// - after one step, or for a load too far away: the coarse-to-fine guess
///   below, or the last step, scaled, if there is no coarse operator;
/// - for the first step: the problem on every second node (recursively), solved
///   to 1e-3 of the rms height and interpolated.
///
/// The initial guess affects the number of iterations, not the solution.
///
/// With adhesion the solution depends on the path, and a step begins with the
/// gap of the last one. The first step begins with that of hard contact, which
/// is approached from outside, or from undeformed surfaces that touch if its
/// nominal pressure is not positive, or that are as near as a spring holds them
/// without a load. Where a step parts faces that touched, or
/// brings the first nodes together, it is halved six times for the last state
/// before that.
///
/// With a hardness, the surface keeps the imprint of each step that converged:
/// the next one begins with heights that are lower by it. Mean gaps, prescribed
/// or found, are those of the given heights.
class LoadSequence {
public:
  /// @param elasticity     C; owned by this object, its scratch is used
  /// @param heights        h [m], elasticity.n_nodes() values
  /// @param gap_tolerance  [m] > 0, see ContactProblem; for a soft penalty
  ///                       it is raised to the roundoff (8 + N/8) eps of the
  ///                       penetration c p_0, on N nodes
  /// @throws std::domain_error  a size or a number is outside its range
  LoadSequence(std::unique_ptr<SurfaceOperator> elasticity,
               std::vector<double> heights,
               const mechanics::ContactInterface& interface,
               double gap_tolerance, int max_iterations);

  ContactSolution solve(mechanics::LoadTarget target);

  /// The saved state of the last steps as numbers, from which another process
  /// can continue with identical results; empty before the first step.
  std::vector<double> memory() const;

  /// Restores the state saved by memory().
  /// @param memory  from a sequence on an equal grid, and on equal ranks
  /// @throws std::domain_error  its size or a value is invalid
  void recall(std::span<const double> memory);

  /// h [m] of the last step: as given, less the imprint of the steps before.
  std::span<const double> heights() const { return heights_; }

  /// The mean depth of that imprint [m].
  double mean_imprint() const { return mean_imprint_; }

  /// C, to apply it between two steps.
  SurfaceOperator& elasticity() { return *elasticity_; }

  /// Penalty compliance 1/k [m/Pa], which determines the penetration in the
  /// solution; 0 for laws that end at hard contact.
  double local_compliance() const;

private:
  struct Step {
    double amount;
    /// Pressure where > 0 [Pa], otherwise minus the gap [m]; with adhesion the
    /// gap, with free boundaries that of FreeAdhesion. Single precision is
    /// enough for an initial guess.
    std::vector<float> state;
  };

  ContactSolution solve_with_adhesion(const mechanics::LoadTarget& target);
  /// Prescribes the mean gap instead, with what the load moves the spring by.
  ContactSolution solve_with_stiff_spring(const mechanics::LoadTarget& target);
  /// One step with adhesion.
  /// @param state  that of Step, replaced
  ContactSolution step_with_adhesion(const mechanics::LoadTarget& target,
                                     std::vector<double>& state);
  /// Halves the way from the last step to one in which faces part or come
  /// together, and tells of the last state before that.
  void find_jump(const mechanics::LoadTarget& target, ContactSolution& found);
  /// Whether a gap of a state with adhesion is closed, or for a law without a
  /// wall at most that of its largest tension.
  bool touches(std::span<const float> state) const;
  /// A step that is not converged, because the surface yields everywhere.
  ContactSolution beyond_hardness(double nominal_pressure) const;
  /// Lowers the heights by the imprint of the last step.
  void lower_heights();
  /// Keeps the imprint of a step, whose gap and mean gap become those of the
  /// imprinted surface and of the given heights.
  void keep_imprint(ContactSolution& solution);
  ContactProblem problem_to(double gap_tolerance) const;
  /// Pressure and gap from which the first step with adhesion begins [m].
  ContactSolution first_contact(const mechanics::LoadTarget& target);

  /// Empty if there is none.
  std::vector<double>
  extrapolation_to(const mechanics::LoadTarget& target) const;
  std::vector<double> coarse_guess(const mechanics::LoadTarget& target);
  /// The residual from which on it is better than another guess [m].
  double error_of_coarse_guess();
  double rms_height();
  /// Of a load with adhesion, over <|p|>: that of gaps, over h_rms.
  double load_tolerance();
  void remember(const mechanics::LoadTarget& target,
                const ContactSolution& solution);
  /// Whether a pressure is positive at some node of any rank.
  bool has_load(std::span<const double> pressure) const;

  std::unique_ptr<SurfaceOperator> elasticity_;
  std::vector<double> heights_;
  std::optional<double> rms_height_;            ///< [m], once it was needed
  std::optional<double> error_of_coarse_guess_; ///< likewise
  std::optional<double> adhesive_scale_;        ///< [Pa/m], likewise
  std::optional<FreeAdhesion> free_adhesion_;   ///< with free boundaries
  mechanics::ContactInterface interface_;
  mechanics::SurfaceSolver solver_;
  double gap_tolerance_;
  int max_iterations_;
  mechanics::Control control_ = mechanics::Control::nominal_pressure;
  std::vector<Step> history_;    ///< the last two steps, oldest first
  std::vector<double> imprint_;  ///< of the last step [m]; empty: none
  double mean_of_imprint_ = 0.0; ///< its mean [m]
  double mean_imprint_ = 0.0;    ///< of all steps before the last one [m]
};

/// Pressure of the same problem on every second node, solved to
/// `coarse_tolerance` [m] and interpolated with the gap, so that the boundary
/// of the contact is found between the nodes; empty if the operator has no
/// coarse version or if the coarse residual is not finite.
std::vector<double> coarse_start(const SurfaceOperator& elasticity,
                                 const ContactProblem& problem,
                                 const mechanics::LoadTarget& target,
                                 double coarse_tolerance);

/// Hard contact by the augmented Lagrangian method: penalty problems on heights
/// raised by lambda/k, where lambda is the pressure of the previous problem,
/// until no node penetrates by more than problem.gap_tolerance.
/// problem.local_compliance is 1/k > 0. Each outer iteration reduces the
/// penetration of a Fourier mode by the factor 1/(1 + k C(q)). The solution
/// does not depend on k, so a penalty too small to converge is replaced by a
/// larger one.
ContactSolution solve_augmented(SurfaceOperator& elasticity,
                                const ContactProblem& problem,
                                const mechanics::LoadTarget& target,
                                std::span<const double> initial_pressure);

} // namespace asperity::contact
