#pragma once

// The preconditioner of the contact iteration.

#include "contact/operators/surface_operator.hpp"
#include "contact/solvers/boundary_extension.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asperity::contact {

/// The map z = E^T (C + c)^-1 E r from a residual to a change of pressure on
/// the active nodes, with the extension E of boundary_extension.hpp. The
/// inverse is that on the periodic surface wide_grid(). Where this is larger
/// than the grid, the added nodes are inactive ones: E estimates the residual
/// there too, so that there is no jump of it at the border of the grid.
///
/// The calls are collective; fields have the nodes of this process.
class Preconditioner {
public:
  explicit Preconditioner(const SurfaceOperator& elasticity);

  /// Determines the extension E. Required before apply() and after every change
  /// of the active nodes.
  /// @param local_compliance  c [m/Pa] >= 0
  void build(const SurfaceOperator& elasticity, double local_compliance,
             const BoundaryExtension::Active& active);

  /// @param active    as in build()
  /// @param residual  r [m], 0 at the inactive nodes
  /// @param scratch   memory of scratch_size() values, the first n_nodes() of
  ///                  which become z [Pa]; without meaning at inactive nodes
  void apply(SurfaceOperator& elasticity, double local_compliance,
             const BoundaryExtension::Active& active,
             std::span<const float> residual, std::span<float> scratch);

  static std::size_t scratch_size(const SurfaceOperator& elasticity) {
    return std::max(elasticity.n_nodes(), elasticity.is_periodic()
                                              ? 0
                                              : elasticity.wide_grid().size());
  }

private:
  /// The active nodes of a wide grid that is larger than the grid.
  struct Wide {
    std::vector<std::uint8_t> freedom; ///< 0 at the added nodes
    BlockFlags blocks;
  };

  bool is_wide() const { return !wide_.freedom.empty(); }

  /// Copies a field of the grid into one of the wide grid, which is 0 at the
  /// added nodes.
  template <class Value>
  void widen(std::span<const Value> field, std::span<Value> wide) const;

  /// Moves the rows of the grid to the first part of a field of the wide grid.
  void narrow(std::span<float> wide) const;

  Grid grid_, wide_grid_;
  int threads_;
  BoundaryExtension extension_;
  Wide wide_;
};

} // namespace asperity::contact
