#include "fem/refined/node_interpolation.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace asperity::fem {
namespace {

/// The rows of the contact surface in unknowns that are not constrained, which
/// are numbered as they appear.
class FaceInterpolation {
public:
  explicit FaceInterpolation(const UnknownConstraints& constraints)
      : constraints_(constraints) {}

  /// Adds an unknown of the level to the present row.
  void add(std::size_t unknown, double weight) {
    const std::size_t own = constraints_.row_of(unknown);
    if (own == constraints_.rows()) {
      add_free(unknown, weight);
      return;
    }
    const std::size_t component = unknown - constraints_.unknowns[own];
    for (std::uint32_t i = constraints_.start[own];
         i < constraints_.start[own + 1]; ++i)
      add_free(constraints_.masters[i] + component,
               weight * constraints_.weights[i]);
  }

  void end_row() { rows_.start.push_back(rows_.column.size()); }

  const SparseRows& rows() const { return rows_; }

  const std::vector<std::size_t>& unknowns() const { return unknowns_; }

private:
  void add_free(std::size_t unknown, double weight) {
    const auto [place, is_new] = numbers_.emplace(unknown, unknowns_.size());
    if (is_new)
      unknowns_.push_back(unknown);
    rows_.column.push_back(place->second);
    rows_.weight.push_back(weight);
  }

  const UnknownConstraints& constraints_;
  SparseRows rows_;
  std::vector<std::size_t> unknowns_;
  std::unordered_map<std::size_t, std::size_t> numbers_;
};

} // namespace

NodeInterpolation::NodeInterpolation(const NodesOfCells& fine,
                                     const BoxLevel& coarse,
                                     std::span<const std::uint32_t> coarse_of,
                                     std::vector<bool> is_wanted) {
  const std::size_t line = fine.in_line;
  for (std::size_t i = 0; i < fine.cells.size(); ++i) {
    const BoxCell& cell = fine.cells[i];
    const BoxCell& above = coarse.boxes.cells[coarse_of[i]];
    const double size = 1.0 / (1 << (cell.level - above.level));
    for (std::size_t n = 0; n < fine.in_cell(); ++n) {
      const std::uint32_t node = fine.nodes[i * fine.in_cell() + n];
      if (!is_wanted[node / 3])
        continue;
      is_wanted[node / 3] = false;
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
      add_row(node, at,
              coarse.mesh.nodes->data() + coarse_of[i] * nodes_in_box);
    }
  }
  std::ranges::sort(surface_);
  if (fine.ghosts != nullptr)
    add_surface_of_others(*fine.ghosts, is_wanted.size());
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

void NodeInterpolation::restrict_force(const std::vector<float>& fine,
                                       float factor,
                                       std::vector<float>& coarse) const {
  for (std::size_t row = 0; row < nodes_.size(); ++row) {
    const float* const from = fine.data() + nodes_[row];
    const float weight = factor * static_cast<float>(weight_of(row));
    for (std::uint32_t k = start_[row]; k < start_[row + 1]; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        coarse[column_[k] + c] += weight * from[c];
  }
}

void NodeInterpolation::interpolate(const std::vector<float>& coarse,
                                    std::vector<float>& fine) const {
  for (std::size_t row = 0; row < nodes_.size(); ++row) {
    float* const to = fine.data() + nodes_[row];
    const auto weight = static_cast<float>(weight_of(row));
    for (std::uint32_t k = start_[row]; k < start_[row + 1]; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        to[c] += weight * coarse[column_[k] + c];
  }
}

/// The row of a node of the contact surface; the number of rows if it is not
/// interpolated.
std::size_t NodeInterpolation::row_of(std::size_t unknown) const {
  const auto node = static_cast<std::uint32_t>(unknown - unknown % 3);
  const auto found = std::ranges::lower_bound(
      surface_, std::pair<std::uint32_t, std::uint32_t>(node, 0));
  return found == surface_.end() || found->first != node ? rows()
                                                         : found->second;
}

MeshContact NodeInterpolation::coarse(const MeshContact& fine,
                                      const BoxLevel& level) const {
  MeshContact found;
  found.has_springs = fine.has_springs;
  for (const std::size_t unknown : fine.held) {
    const std::size_t row = row_of(unknown);
    if (row == rows() || start_[row + 1] != start_[row] + 1)
      continue;
    const std::size_t at_place = column_[start_[row]] + unknown % 3;
    if (!level.is_constrained(at_place))
      found.held.push_back(at_place);
  }
  FaceInterpolation face(*level.mesh.constraints);
  for (const std::size_t unknown : fine.unknowns) {
    const std::size_t row = row_of(unknown);
    if (row < rows())
      for (std::uint32_t k = start_[row]; k < start_[row + 1]; ++k)
        face.add(column_[k] + unknown % 3, weight_of(row));
    face.end_row();
  }
  found.unknowns = face.unknowns();
  const std::size_t size = found.unknowns.size();
  if (size > 0)
    found.springs = product(transposed(face.rows(), size),
                            product(fine.springs, face.rows(), size), size);
  return found;
}

} // namespace asperity::fem
