#pragma once

// Which cells of an adaptive mesh are too coarse for the moduli inside of them.
// Include this header in .cpp files of fem/ only.

#include "fem/adaptive/mesh_change.hpp"

#include <deal.II/base/bounding_box.h>

#include <optional>
#include <vector>

namespace asperity::fem {

/// The rule for materials. A cell takes the moduli at its centre, so it is
/// halved while it is not of the finest size and
///
/// - a plane between two layers crosses it. The coarsest layers are such that
///   this ends with cells on both sides of the plane
///   (meshes/layers/halvable_layers.hpp);
/// - the surface of the inclusion crosses it, or the factor on E differs by
///   more than moduli_ratio between two of its points, and it is larger than
///   its place permits: an edge of a quarter of its depth, and of a quarter of
///   the radius of the inclusion, or interface_halvings halvings if that is
///   set. The displacement of the contact surface due to a difference in a
///   volume H^3 of depth z falls as (H/z)^3 at least.
///
/// The factor is compared at Gauss points, at least four per direction, and so
/// many that no box of a table and no cube of random factors lies between two
/// of them, up to 32. The rule looks at one cell only and so needs no other
/// rank.
class MaterialMarks {
public:
  using Cell = dealii::Triangulation<3>::cell_iterator;

  /// @param problem  with `adaptive`; must outlive this object
  /// @throws std::domain_error  a setting of `adaptive` is outside its range
  explicit MaterialMarks(const BlockProblem& problem);

  /// Whether the cell, which need not be active, is to be halved.
  bool is_too_coarse(const Cell& cell) const;

private:
  using Box = dealii::BoundingBox<3>;

  bool is_allowed(const Box& box, int level) const;
  bool is_crossed_by_interface(const Box& box) const;
  bool is_crossed_by_sphere(const Box& box) const;
  bool has_different_factors(const Box& box) const;

  const ModuliField& field_;
  const AdaptiveMesh& settings_;
  std::vector<double> interfaces_; ///< [m]
  double tolerance_;               ///< of a depth [m]
};

/// Halves the cells of the coarsest mesh that are too coarse for the moduli.
/// This call is collective.
void refine_for_materials(const BlockProblem& problem, MeshChange::Mesh& mesh);

} // namespace asperity::fem
