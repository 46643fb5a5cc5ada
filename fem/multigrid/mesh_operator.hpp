#pragma once

// The product of the stiffness of a mesh with a vector, without a matrix.

#include "fem/multigrid/unknown_layout.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace asperity::fem {

/// K on vectors of all unknowns. A derived class owns the loop over the cells
/// and the data that it reads: BoxGridOperator for equal columns of boxes,
/// BoxOperator for boxes of any size, HexahedronOperator for second-order
/// hexahedra of any shape. Each rank has the cells of its own. Forces are zero
/// at constrained unknowns and those of other ranks. Calls are collective.
/// @tparam Number  float or double
template <class Number>
class MeshOperator {
public:
  explicit MeshOperator(UnknownLayout layout) : layout_(std::move(layout)) {}

  virtual ~MeshOperator() = default;

  const UnknownLayout& layout() const { return layout_; }

  std::size_t size() const { return layout_.size; }

  /// Computes force = K displacement.
  /// @param displacement  [m]; constrained values and those of other ranks are
  ///                      overwritten
  void apply(Number* displacement, Number* force) const {
    apply_own(displacement, force);
    layout_.collect(force);
  }

  /// The share of the cells of this rank, before UnknownLayout::collect().
  void apply_own(Number* displacement, Number* force) const {
    std::fill_n(force, size(), Number(0));
    add_own(displacement, force, Number(1));
  }

  /// Adds `factor` times this share to a force, which must be zero at
  /// constrained unknowns and those of other ranks.
  void add_own(Number* displacement, Number* force, Number factor) const {
    layout_.complete(displacement);
    add_cells(displacement, force, factor);
    layout_.constraints->condense(force);
  }

  virtual std::size_t bytes() const = 0;

private:
  /// Adds `factor` K displacement, the sum over the cells of this rank, without
  /// regard to constraints.
  virtual void add_cells(const Number* displacement, Number* force,
                         Number factor) const = 0;

  UnknownLayout layout_;
};

} // namespace asperity::fem
