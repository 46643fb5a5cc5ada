#pragma once

// Adhesive contact of a surface that equals its mirror images, on a quarter of
// it.

#include "contact/solvers/adhesive.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace asperity::contact {

/// The adhesive problems of a periodic surface whose heights equal their mirror
/// images about the middle lines of the cell, as those of a mirrored map do:
/// that of the map between frictionless walls. States are looked for, and
/// tested for a minimum, among those that equal their mirror images as well,
/// by solve_adhesive() on a quarter of the nodes.
class MirroredAdhesion {
public:
  /// None if the heights do not equal their mirror images to 1e-12 of the
  /// largest one, or the operator has no mirrored().
  static std::optional<MirroredAdhesion> of(const SurfaceOperator& elasticity,
                                            std::span<const double> heights);

  /// A step from the gap of all nodes [m], which it replaces.
  /// @param problem  of all nodes
  /// @param state    its first quarter is the start
  ContactSolution solve(AdhesiveProblem problem,
                        const mechanics::LoadTarget& target,
                        std::vector<double>& state);

private:
  explicit MirroredAdhesion(std::unique_ptr<SurfaceOperator> quarter,
                            std::span<const double> heights);

  /// The first quarter of a field.
  std::vector<double> quarter_of(std::span<const double> whole) const;
  /// A field of all nodes from its first quarter.
  std::vector<double> unfolded(std::span<const double> quarter) const;

  std::unique_ptr<SurfaceOperator> elasticity_; ///< of the quarter
  std::vector<double> heights_;                 ///< likewise [m]
};

} // namespace asperity::contact
