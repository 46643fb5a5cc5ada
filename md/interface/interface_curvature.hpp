#pragma once

// Represents the second derivatives of the interface energy for Newton's
// method. It limits negative eigenvalues and provides the scaling that
// equalises the atoms in the preconditioner.

#include "md/interface/interface.hpp"
#include "md/interface/symmetric_block.hpp"

#include <vector>

namespace asperity::md {

/// Stores a block H_i for each atom of the layer and the matrix function
///
///     S_i = [(k + k_c) / (k + max(H_i, 0))]^(1/2)
///
/// If the bulk resists the displacement of a single atom with the stiffness k,
/// then S^-1 (K + k_c) S^-1 has the diagonal of K + H, so that S (K + k_c)^-1 S
/// approximates (K + H)^-1. The scaling accounts for the orientation of the
/// surface: an atom on a slope is stiff along the local surface normal.
class InterfaceCurvature {
public:
  /// @param bulk_stiffness  k [N/m] > 0
  /// @param is_normal       only z is free; the other derivatives are dropped
  InterfaceCurvature(std::size_t atoms, double bulk_stiffness, bool is_normal);

  void take(const Interface& interface, const LayerView& atoms);

  /// Raises eigenvalues below -share k to this value. Each call starts from the
  /// blocks as computed by take().
  void limit_negative_curvature(double share);

  /// Returns k_c, the mean over all atoms of the positive part of the normal
  /// stiffness [N/m].
  double mean_stiffness() const { return mean_stiffness_; }

  /// Adds H step to `forces`.
  void add_product(const LayerView& step, const LayerForces& forces) const;

  /// Overwrites `planes` with S planes.
  void scale(const LayerForces& planes) const;

private:
  /// Eigenvalues and eigenvectors of H_i.
  struct Axes {
    double values[3] = {};     ///< ascending [N/m]
    double vectors[3][3] = {}; ///< [component][axis]

    template <class Function>
    SymmetricBlock of_values(const Function& function) const;
  };

  double bulk_stiffness_;
  bool is_normal_;
  double mean_stiffness_ = 0.0;
  std::vector<SymmetricBlock> taken_;
  std::vector<SymmetricBlock> blocks_; ///< after limit_negative_curvature()
  std::vector<SymmetricBlock> scales_;
  std::vector<Axes> axes_;
};

} // namespace asperity::md
