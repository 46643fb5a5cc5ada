#pragma once

// The stiffness of a mesh of first-order boxes without a matrix, under linear
// constraints. This file does not depend on deal.II.

#include "fem/hexahedra/hexahedron_operator.hpp"
#include "fem/refined/box_kernel.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace asperity::fem {

/// The first unknown of each of the nodes of each cell, x fastest, filled up to
/// whole groups of cells by zeros.
using SharedNodes = std::shared_ptr<const std::vector<std::uint32_t>>;

SharedNodes shared_nodes(std::vector<std::uint32_t> nodes);

/// Boxes with edges along the axes, those of this rank if several share the
/// block; the three unknowns of a node are consecutive.
struct BoxMesh {
  SharedNodes nodes;
  std::vector<std::array<double, 3>> edges; ///< of each cell [m]
  std::vector<CellModuli> moduli;           ///< of each cell
  std::size_t unknowns = 0; ///< including copies of those of other ranks
  SharedConstraints constraints;
  /// The nodes of other ranks; null for a block on one process. It must outlive
  /// what is made from the mesh.
  const GhostValues* ghosts = nullptr;

  RankGroup* ranks() const {
    return ghosts == nullptr ? nullptr : &ghosts->ranks();
  }

  /// Measures lengths and moduli in other units.
  void rescale(double length, double modulus);
};

/// The shortest edge [m] and the largest shear modulus [Pa] on any rank.
struct BoxUnits {
  double length = 0.0, modulus = 0.0;

  double stiffness() const { return length * modulus; } ///< [N/m]
};

BoxUnits units_of(const BoxMesh& mesh);

/// The mesh in these units, so that its stiffness can be stored in single
/// precision.
/// @param unit  unit of the stiffness of the result [N/m]
BoxMesh normalised(const BoxMesh& mesh, double& unit);

/// K on vectors of all unknowns, with isotropic linear elasticity. The calls
/// are those of HexahedronOperator.
template <class Number>
class BoxOperator {
public:
  using Mesh = BoxMesh;

  explicit BoxOperator(const BoxMesh& mesh);

  std::size_t size() const { return size_; }

  /// Computes force = K displacement; zero at constrained unknowns.
  /// @param displacement  [m]; constrained values and those of other ranks are
  ///                      overwritten
  void apply(Number* displacement, Number* force) const {
    apply_own(displacement, force);
    collect(force);
  }

  /// The share of the cells of this rank, before collect().
  void apply_own(Number* displacement, Number* force) const {
    std::fill_n(force, size(), Number(0));
    add_own(displacement, force, Number(1));
  }

  /// Adds `factor` times this share to a force, which must be zero at
  /// constrained unknowns and those of other ranks.
  void add_own(Number* displacement, Number* force, Number factor) const;

  /// Moves forces on unknowns of other ranks to these.
  template <class Other>
  void collect(Other* force) const {
    if (ghosts_ != nullptr)
      ghosts_->add_to_owners(force);
  }

  /// Diagonal of K without the terms that couple two masters of one unknown;
  /// positive, and zero at constrained unknowns.
  /// @param mesh  of this operator
  std::vector<Number> diagonal(const BoxMesh& mesh) const;

  /// The nodes are counted in single precision only, because the operator in
  /// double precision shares them.
  std::size_t bytes() const;

private:
  std::size_t size_;
  const GhostValues* ghosts_;
  SharedConstraints constraints_;
  SharedNodes nodes_;
  std::vector<Number> boxes_;        ///< of the groups that differ
  std::vector<std::uint32_t> kinds_; ///< of each group, its place in boxes_
};

extern template class BoxOperator<float>;
extern template class BoxOperator<double>;

} // namespace asperity::fem
