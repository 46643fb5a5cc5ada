#include "fem/refined/node_interpolation.hpp"

#include "base/array_memory.hpp"
#include "fem/refined/box_kernel.hpp"

#include <algorithm>
#include <stdexcept>

namespace asperity::fem {

NodeInterpolation::NodeInterpolation(Fine fine, const NodesOfCells& coarse,
                                     const UnknownLayout& unknowns)
    : LevelTransfer(fine.ghosts == nullptr ? nullptr : &fine.ghosts->ranks()),
      step_(unknowns.step) {
  const NodesOfCells& own = fine.cells;
  const std::size_t line = own.in_line;
  for (std::size_t i = 0; i < own.cells.size(); ++i) {
    const BoxCell& cell = own.cells[i];
    const BoxCell& above = coarse.cells[fine.coarse_of[i]];
    const double size = 1.0 / (1 << (cell.level - above.level));
    for (std::size_t n = 0; n < own.in_cell(); ++n) {
      const std::uint32_t node = own.nodes[i * own.in_cell() + n];
      if (!fine.is_wanted[node / 3])
        continue;
      fine.is_wanted[node / 3] = false;
      const std::array<std::uint32_t, 3> step{
          static_cast<std::uint32_t>(n % line),
          static_cast<std::uint32_t>(n / line % line),
          static_cast<std::uint32_t>(n / line / line)};
      std::array<double, 3> at{};
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = size * (cell.place[k] + static_cast<double>(step[k]) /
                                            static_cast<double>(line - 1)) -
                above.place[k];
      if (cell.place[2] == 0 && step[2] == 0)
        surface_.emplace_back(node, static_cast<std::uint32_t>(nodes_.size()));
      add_row(node, at, &coarse.nodes[fine.coarse_of[i] * nodes_in_box]);
    }
  }
  if (fine.ghosts != nullptr)
    add_surface_of_others(*fine.ghosts, fine.is_wanted.size());
  add_contact(*unknowns.constraints);
}

/// Takes the rows of the contact surface's nodes that other ranks own from
/// these ranks, whose coarse functions have the same numbers. A node lies on
/// one face of a coarse cell, so that a row has at most four entries.
void NodeInterpolation::add_surface_of_others(const GhostValues& ghosts,
                                              std::size_t nodes) {
  constexpr std::size_t most_entries = 4, in_node = 3;
  constexpr double absent = -1.0;
  const std::size_t own_nodes = ghosts.owned();
  std::vector<std::array<double, most_entries>> others(nodes - own_nodes);
  std::vector<double> values(in_node * nodes);
  for (std::size_t k = 0; k < most_entries; ++k) {
    std::ranges::fill(values, absent);
    for (const auto& [node, row] : surface_)
      if (start_[row] + k < start_[row + 1])
        values[node] = static_cast<double>(column_[start_[row] + k]);
    ghosts.fill_ghosts(values.data());
    for (std::size_t i = 0; i < others.size(); ++i)
      others[i][k] = values[in_node * (own_nodes + i)];
  }
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (others[i][0] == absent)
      continue;
    surface_.emplace_back(static_cast<std::uint32_t>(in_node * (own_nodes + i)),
                          static_cast<std::uint32_t>(rows()));
    for (const double column : others[i])
      if (column != absent)
        column_.push_back(static_cast<std::uint32_t>(column));
    start_.push_back(static_cast<std::uint32_t>(column_.size()));
  }
}

/// Passes on what the contact surface needs, with constraints resolved.
void NodeInterpolation::add_contact(const UnknownConstraints& constraints) {
  for (const auto& [node, row] : surface_) {
    const std::size_t normal = node + 2;
    contact().add_node(normal);
    for (std::uint32_t k = start_[row]; k < start_[row + 1]; ++k) {
      const std::size_t coarse = column_[k] + 2 * step_;
      const std::size_t own = constraints.row_of(coarse);
      if (own == constraints.rows()) {
        contact().add_master(coarse, weight_of(row));
        if (start_[row + 1] == start_[row] + 1)
          contact().add_held(normal, coarse);
        continue;
      }
      const std::size_t component = coarse - constraints.unknowns[own];
      for (std::uint32_t i = constraints.start[own];
           i < constraints.start[own + 1]; ++i)
        contact().add_master(constraints.masters[i] + component,
                             weight_of(row) * constraints.weights[i]);
    }
  }
  contact().finish();
  free_memory(surface_);
}

/// @param at  in the coarse cell, 0..1 along each axis
void NodeInterpolation::add_row(std::uint32_t node,
                                const std::array<double, 3>& at,
                                const std::uint32_t* corners) {
  double sum = 0.0;
  for (std::size_t v = 0; v < nodes_in_box; ++v) {
    double weight = 1.0;
    for (std::size_t k = 0; k < 3; ++k)
      weight *= (v >> k & 1U) == 1 ? at[k] : 1.0 - at[k];
    if (weight == 0.0)
      continue;
    column_.push_back(corners[v]);
    sum += weight * weight;
  }
  nodes_.push_back(node);
  start_.push_back(static_cast<std::uint32_t>(column_.size()));
  // The sum of squares of equal weights of sum 1 is their value.
  if (sum != weight_of(rows() - 1))
    throw std::logic_error("the weights of a node in a coarser box differ");
}

void NodeInterpolation::add_restricted(const std::vector<float>& fine,
                                       std::vector<float>& coarse) {
  for (std::size_t row = 0; row < nodes_.size(); ++row) {
    const float* const from = fine.data() + nodes_[row];
    const auto weight = static_cast<float>(weight_of(row));
    for (std::uint32_t k = start_[row]; k < start_[row + 1]; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        coarse[column_[k] + c * step_] += weight * from[c];
  }
}

void NodeInterpolation::add_interpolated(const std::vector<float>& coarse,
                                         std::vector<float>& fine) {
  for (std::size_t row = 0; row < nodes_.size(); ++row) {
    float* const to = fine.data() + nodes_[row];
    const auto weight = static_cast<float>(weight_of(row));
    for (std::uint32_t k = start_[row]; k < start_[row + 1]; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        to[c] += weight * coarse[column_[k] + c * step_];
  }
}

} // namespace asperity::fem
