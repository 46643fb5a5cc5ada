#pragma once

// Entries of a linear operator on the contact surface, for dense matrices of a
// few nodes.

#include "base/grid.hpp"

#include <functional>
#include <vector>

namespace asperity::contact {

/// Entries of a linear operator on the contact surface. Each column is computed
/// when it is first needed and then cached. A translation-invariant operator
/// has a single column.
class Columns {
public:
  /// Writes the column of the operator for a unit value at the node.
  using Take =
      std::function<void(std::size_t node, std::vector<double>& column)>;

  Columns(const Grid& grid, bool is_homogeneous, Take take);

  /// Value at `node` that results from a unit value at `other`.
  double between(std::size_t node, std::size_t other);

private:
  const std::vector<double>& column(std::size_t node);

  Grid grid_;
  bool is_homogeneous_;
  Take take_;
  std::vector<std::vector<double>> columns_;
};

} // namespace asperity::contact
