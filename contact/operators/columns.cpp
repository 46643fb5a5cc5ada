#include "contact/operators/columns.hpp"

#include <utility>

namespace asperity::contact {

Columns::Columns(const Grid& grid, bool is_homogeneous, Take take)
    : grid_(grid),
      is_homogeneous_(is_homogeneous),
      take_(std::move(take)),
      columns_(is_homogeneous ? 1 : grid.size()) {}

double Columns::between(std::size_t node, std::size_t other) {
  if (!is_homogeneous_)
    return column(other)[node];
  const auto nx = static_cast<std::size_t>(grid_.points_x);
  const auto ny = static_cast<std::size_t>(grid_.points_y);
  const std::size_t dx = (node % nx + nx - other % nx) % nx;
  const std::size_t dy = (node / nx + ny - other / nx) % ny;
  return column(0)[dy * nx + dx];
}

const std::vector<double>& Columns::column(std::size_t node) {
  std::vector<double>& column = columns_[node];
  if (column.empty()) {
    column.resize(grid_.size());
    take_(node, column);
  }
  return column;
}

} // namespace asperity::contact
