#pragma once

// Entries of a linear map of the face, for dense matrices of a few nodes.

#include "base/grid.hpp"

#include <functional>
#include <vector>

namespace asperity::contact {

/// A linear map of the face between pairs of nodes, from columns that are
/// taken when first asked for. One that is the same at every node has one.
class Columns {
public:
  /// column = the map of 1 at the node and 0 elsewhere
  using Take =
      std::function<void(std::size_t node, std::vector<double>& column)>;

  Columns(const Grid& grid, bool is_homogeneous, Take take);

  /// The value at one node of the map of 1 at the other.
  double between(std::size_t node, std::size_t other);

private:
  const std::vector<double>& column(std::size_t node);

  Grid grid_;
  bool is_homogeneous_;
  Take take_;
  std::vector<std::vector<double>> columns_;
};

} // namespace asperity::contact
