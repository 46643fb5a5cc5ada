#pragma once

// The contact law at the contact points of the block and the state of its
// Newton iteration.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/block/full_block.hpp"
#include "fem/linear/block_solver.hpp"

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace asperity::fem {

/// Maximum number of refinement steps on an unchanged contact set; further
/// steps gain no accuracy.
constexpr int most_refinements = 8;

/// Number of full steps on changing contact sets before steps are taken more
/// carefully. A contact set that full steps find is found within some ten.
constexpr int most_full_steps = 12;

/// Number of full steps on changing contact sets before linear systems are
/// solved more accurately. In strongly heterogeneous blocks, and with much
/// softer counter-bodies, the error of a less accurate step may be a pressure
/// of many times the load.
constexpr int most_loose_steps = 4;

/// The larger of two residuals, or infinity if the second is NaN: std::max
/// would ignore a NaN, and MPI's maximum may.
double larger_residual(double largest, double residual);

/// Which contact points carry a pressure [Pa].
std::vector<bool> contact_set(const std::vector<double>& pressure);

/// The state of the contact problem from which another mesh starts.
struct ContactStart {
  dealii::TrilinosWrappers::MPI::Vector displacement; ///< u [m], with zeros at
                                                      ///< constrained unknowns
  std::vector<double> pressure; ///< of this rank's points [Pa] >= 0
  double rigid_gap = 0.0;       ///< as ContactNewton::rigid_gap [m]
  double highest = 0.0;         ///< [m]
  double far_pressure = 0.0;    ///< on the far boundary [Pa]
};

/// Solves (F.1) of full_block.hpp over the points of all ranks.
/// contact_newton.cpp implements a load step, contact_springs.cpp Newton's
/// method for springs at fixed multipliers, contact_globalisation.cpp what it
/// does if it cycles, contact_augmented.cpp penalty and augmented Lagrangian
/// contact, contact_active_set.cpp hard contact, contact_step.cpp the linear
/// step of all of these, and contact_stiffness.cpp the stiffness of a contact.
class ContactNewton {
public:
  /// @param system must outlive this object
  ContactNewton(const BlockSystem& system, LinearSolver linear_solver,
                std::unique_ptr<BlockPreconditioner> own = {},
                std::unique_ptr<MatrixFreeBlock> matrix_free = {});

  /// Solves, starting from the state at the end of the last call, and writes
  /// all results that are not fields into the answer.
  /// @param heights       heights of this rank's points [m]
  /// @param height_scale  the tolerance of a gap is relative to this scale [m]
  ///                      > 0
  void solve(std::vector<double> heights, double height_scale,
             const mechanics::LoadTarget& load, const BlockContact& contact,
             BlockSolution& answer);

  /// Replaces the state from which the next solution starts.
  void start_from(ContactStart start);

  /// Computes u under given pressures [Pa] at this rank's points, balanced by
  /// the load on the far boundary. The state does not change. Returns false if
  /// CG did not converge.
  [[nodiscard]] bool
  solve_linear(std::span<const double> pressure,
               dealii::TrilinosWrappers::MPI::Vector& displacement);

  /// As FullBlock::stiffness().
  ContactStiffness stiffness();

  /// The displacement u [m], with zeros at constrained unknowns.
  const dealii::TrilinosWrappers::MPI::Vector& displacement() const {
    return displacement_;
  }

  const std::vector<double>& pressure() const { return pressure_; } ///< [Pa]

  /// The rigid gap in gap = rigid gap + w - (height - highest), all in [m].
  double rigid_gap() const { return rigid_gap_; }

  double highest() const { return highest_; }

  double far_pressure() const { return far_pressure_; } ///< [Pa]

  double gap(std::size_t i) const {
    return rigid_gap_ + face_displacement_[i] - heights_[i];
  }

  /// The response of the block to a unit of approach, for the points in contact
  /// in the last step [1], with zeros at constrained unknowns, and the force
  /// that it takes [N/m]; zero before the first step.
  const dealii::TrilinosWrappers::MPI::Vector& response_to_approach() const {
    return by_approach_;
  }

  double approach_stiffness() const { return approach_stiffness_; }

  double mean_gap() const; ///< weighted by the area of all points [m]

private:
  /// Bounds on the residual of a linear solve.
  struct Range {
    double finest = 0.0;
    double coarsest = std::numeric_limits<double>::infinity();
    double share = 1.0; ///< fraction of the usual relative tolerance
  };

  /// What a step changes.
  struct State {
    dealii::TrilinosWrappers::MPI::Vector displacement, elastic;
    std::vector<double> face_displacement;
    double rigid_gap = 0.0;
  };

  double area() const { return system_.contact().area(); }

  double borne() const; ///< sum of a p [N]
  double touching_gap(double nominal_pressure, double penalty) const;
  void take_heights(std::vector<double> heights);
  double touching_mean_gap() const;
  void leave_contact(BlockSolution& answer);
  void lift_off(double mean_gap_target);
  double own_spring(const BlockContact& contact) const;
  double stiffest_penalty(double tolerance) const;
  double stiffer_penalty(const BlockContact& working,
                         const BlockContact& contact) const;
  double softer_penalty(const BlockContact& working);
  void update_pressure(double penalty);
  bool any(const std::vector<bool>& set) const;
  int n_changed(const std::vector<bool>& a, const std::vector<bool>& b) const;
  void report_step(int iterations, double residual, int changed_points);
  void report();
  void add_up(const BlockContact& contact, BlockSolution& answer) const;
  void find_imbalance();
  double largest_force() const; ///< maximum over the points [N]
  double unbalanced();
  double rounding_force() const;
  std::string why_unbalanced(double tolerance, double residual) const;
  double violation(double compliance) const;
  void solve_springs(const mechanics::LoadTarget& load,
                     const BlockContact& contact, double height_scale,
                     BlockSolution& answer);
  double missing_pressure(const mechanics::LoadTarget& load,
                          double compliance) const;
  bool can_bear(double missing, double gap_tolerance,
                BlockSolution& answer) const;
  bool newton(const mechanics::LoadTarget& load, const BlockContact& contact,
              BlockSolution& answer, bool is_hard_to_find = false);
  bool approach_by_load(double mean_gap_target, const BlockContact& contact,
                        BlockSolution& answer);
  void solve_wall(const mechanics::LoadTarget& load,
                  const BlockContact& contact, double height_scale,
                  BlockSolution& answer);
  bool active_set(const mechanics::LoadTarget& load,
                  const BlockContact& contact, double gap_tolerance,
                  BlockSolution& answer);
  std::vector<bool> next_active(const std::vector<bool>& active,
                                const BlockContact& contact,
                                double gap_tolerance) const;
  void take_wall_pressure(const std::vector<bool>& active);
  bool step(const mechanics::LoadTarget& load, std::span<const double> springs,
            const std::vector<bool>& held, double tolerance, int refinements);
  double relative_tolerance(bool has_wall) const;
  bool solve_for(dealii::TrilinosWrappers::MPI::Vector& answer,
                 const dealii::TrilinosWrappers::MPI::Vector& forces,
                 std::span<const double> held_displacement, const Range& range);
  bool reaction_to(unsigned int component, const std::vector<bool>& touching,
                   bool is_sticking, double& reaction);
  double stiffness_of(std::span<const double> springs) const;
  State state() const;
  void return_to(const State& state, double penalty);
  double contact_work(const State& before, double share, double penalty) const;
  void shorten_step(const State& before, double penalty);
  bool border(const mechanics::LoadTarget& load,
              std::span<const double> springs, const std::vector<bool>& held);

  const BlockSystem& system_;
  BlockSolver solver_;
  BlockWatch watch_; ///< of the load step
  BlockProgress progress_;
  int iterations_before_ = 0; ///< CG iterations of earlier load steps
  double stiffness_scale_;    ///< shear modulus at the contact surface over
                              ///< spacing
  // The state in (F.1).
  dealii::TrilinosWrappers::MPI::Vector displacement_; ///< u [m]
  double rigid_gap_ = 0.0;    ///< d minus the highest height [m]
  double highest_ = 0.0;      ///< [m]
  double far_pressure_ = 0.0; ///< P [Pa]
  std::vector<double> multiplier_;
  std::vector<double> pressure_;
  std::vector<double> heights_;                     ///< minus the highest
                                                    ///< height [m]
  std::vector<double> face_displacement_;           ///< B u [m]
  dealii::TrilinosWrappers::MPI::Vector elastic_;   ///< K u [N]
  dealii::TrilinosWrappers::MPI::Vector imbalance_; ///< K u + P g - B^T a p
  /// The last state that was a solution, or that of the beginning of the load
  /// step. Full steps on changing contact sets may lead far from it.
  State settled_;
  /// Whether full steps have not found the contact set, so that linear systems
  /// are solved more accurately.
  bool is_careful_ = false;
  /// Whether the load step has ended because of the linear solver.
  bool has_linear_failure_ = false;
  // Responses in the last step, used as initial guesses in the next one.
  dealii::TrilinosWrappers::MPI::Vector by_imbalance_, by_approach_,
      by_far_pressure_;
  double approach_stiffness_ = 0.0; ///< the force of by_approach_ [N/m]
};

} // namespace asperity::fem
