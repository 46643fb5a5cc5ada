#pragma once

// The state of the contact problem of a block: the unknowns of (F.1), and what
// follows from them.
// Include this header in .cpp files of fem/ only.

#include "fem/block/block_system.hpp"
#include "fem/block/material_points.hpp"
#include "fem/linear/block_solver.hpp"

#include <optional>
#include <span>
#include <vector>

namespace asperity::fem {

/// Whether a contact point of this rank is in contact.
using ContactSet = std::vector<bool>;

/// The points that carry a pressure [Pa].
ContactSet contact_set(std::span<const double> pressure);

/// Whether any rank has a point in the set.
bool is_any(const ContactSet& set);

/// The number of points of all ranks that are in one set only.
int n_changed(const ContactSet& a, const ContactSet& b);

/// The larger of two residuals, or infinity if the second is NaN: std::max
/// would ignore a NaN, and MPI's maximum may.
double larger_residual(double largest, double residual);

/// The unknowns of (F.1) in full_block.hpp. Points are those of this rank;
/// sums and maxima extend over the points of all ranks, so that the functions
/// are collective, except those of one point.
struct ContactState {
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// What a step of the iteration changes; the state of the material
  /// follows.
  struct Placement {
    Vector displacement, elastic;
    std::vector<double> face_displacement;
    double rigid_gap = 0.0;
  };

  /// Both must outlive the state; the solver multiplies by K.
  ContactState(const BlockSystem& system, const BlockSolver& solver);

  Vector displacement;            ///< u [m], with zeros at constrained unknowns
  double rigid_gap = 0.0;         ///< d minus the highest height [m]
  double far_pressure = 0.0;      ///< P [Pa]
  std::vector<double> pressure;   ///< p [Pa]
  std::vector<double> multiplier; ///< lambda [Pa]

  std::vector<double> heights; ///< minus the highest height [m]
  double highest = 0.0;        ///< height [m]

  std::vector<double> face_displacement; ///< B u [m]
  Vector elastic;   ///< of the stress, K u in an elastic block [N]
  Vector imbalance; ///< elastic + P g - B^T a p, of find_imbalance() [N]

  /// The state of the material at the displacement; null if it is linear.
  MaterialPoints* material() { return material_ ? &*material_ : nullptr; }

  const MaterialPoints* material() const {
    return material_ ? &*material_ : nullptr;
  }

  /// Whether the stiffness is K at this displacement.
  bool is_elastic() const { return !material_ || material_->is_elastic(); }

  const ContactPoints& points() const { return system_.contact(); }

  double area() const { return points().area(); } ///< [m^2]

  const Vector& far_load() const { return system_.far_load(); } ///< g [m^2]

  /// Shear modulus at the contact surface over the spacing of the grid [Pa/m].
  double stiffness_scale() const { return stiffness_scale_; }

  double gap(std::size_t i) const {
    return rigid_gap + face_displacement[i] - heights[i];
  }

  double mean_gap() const; ///< weighted by the area of all points [m]
  double borne() const;    ///< sum of a p [N]

  /// The mean gap [m] of the undeformed block at which its highest point
  /// touches. At a larger one there is no contact. A heterogeneous block may
  /// have such a mean gap under a load, too, by lifting more of the surface
  /// than it lowers, and Newton's method with full steps then finds neither.
  double touching_mean_gap() const;

  /// The rigid gap at which the block in its present deformation carries the
  /// nominal pressure [Pa] by springs k [Pa/m].
  double touching_gap(double nominal_pressure, double penalty) const;

  /// Stores heights relative to the highest at a contact point: the points that
  /// carry a small load lie near it, and the gap there is then not a difference
  /// of large numbers. The map may be higher between the points. The position
  /// of the block does not change.
  void take_heights(std::vector<double> absolute);

  /// Computes B u and the force of the stress.
  void follow_displacement();

  /// p = (lambda - k gap)+.
  void press_springs(double penalty);

  void leave_contact(); ///< sets p and lambda to zero

  /// Sets the solution without contact at a mean gap, which is known exactly.
  /// The iterations leave a part of the displacement before, against which no
  /// contact force measures.
  void lift_off(double mean_gap_target);

  Placement placement() const;
  void return_to(const Placement& placement);

  /// Goes back to a share of the way from a placement.
  void shorten_way(const Placement& before, double share);

  /// The work of the stress per share of a step [N m], at a share of the step.
  double stress_work(const Placement& before, const Vector& step, double share);

  void find_imbalance();

  double largest_force() const; ///< maximum of a p over the points [N]

  /// The unbalanced force relative to the largest contact force [1], as
  /// force_of() has it.
  double unbalanced();

  /// The force [N], as force_of() has it, by which displacements differ that
  /// differ by half a unit in the last place, with signs from the bits of their
  /// values. No solution in double precision is balanced much better.
  double rounding_force() const;

  /// The violation of the contact law [m]: the largest |gap + c p| in contact,
  /// and the largest penetration outside of contact.
  /// @param compliance  c [m/Pa] >= 0; 0 in hard contact
  double violation(double compliance) const;

private:
  double force_of(const Vector& nodal_forces) const;

  const BlockSystem& system_;
  const BlockSolver& solver_;
  std::optional<MaterialPoints> material_;
  double stiffness_scale_;
};

} // namespace asperity::fem
