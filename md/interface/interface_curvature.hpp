#pragma once

// The second derivatives of the interface as Newton's method takes them. Owns
// how soft an atom may be, and the scaling that makes all atoms alike.

#include "md/interface/interface.hpp"
#include "md/interface/symmetric_block.hpp"

#include <vector>

namespace asperity::md {

/// A block H_i for each atom of the layer, and with it
///
///     S_i = [(k + k_c) / (k + max(H_i, 0))]^(1/2)
///
/// a function of the matrix. For a bulk that sets k against an atom that moves
/// alone, S^-1 (K + k_c) S^-1 has the diagonal of K + H, so
/// S (K + k_c)^-1 S is near (K + H)^-1: an atom on a slope is stiff along the
/// substrate's normal, whichever way that points.
class InterfaceCurvature {
public:
  /// @param bulk_stiffness  k [N/m] > 0
  /// @param is_normal       only z moves: the other derivatives are dropped
  InterfaceCurvature(std::size_t atoms, double bulk_stiffness, bool is_normal);

  void take(const Interface& interface, const LayerView& atoms);

  /// Raises what is below -share k to that. Goes back to what was taken first.
  void limit_softness(double share);

  /// k_c: mean over all atoms of the positive part of the normal one [N/m].
  double mean_stiffness() const { return mean_stiffness_; }

  /// forces += H step.
  void add_product(const LayerView& step, const LayerForces& forces) const;

  /// planes = S planes.
  void scale(const LayerForces& planes) const;

private:
  /// H_i = sum of values times the squares of the axes.
  struct Axes {
    double values[3] = {};     ///< rising [N/m]
    double vectors[3][3] = {}; ///< [component][axis]

    template <class Function>
    SymmetricBlock of_values(const Function& function) const;
  };

  double bulk_stiffness_;
  bool is_normal_;
  double mean_stiffness_ = 0.0;
  std::vector<SymmetricBlock> taken_;
  std::vector<SymmetricBlock> blocks_; ///< with the softness limited
  std::vector<SymmetricBlock> scales_;
  std::vector<Axes> axes_;
};

} // namespace asperity::md
