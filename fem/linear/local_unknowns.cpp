#include "fem/linear/local_unknowns.hpp"

#include "fem/parallel/mpi_group.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace asperity::fem {
namespace {

constexpr unsigned int in_node = 3; // unknowns

} // namespace

LocalUnknowns::LocalUnknowns(const BlockSpace& space,
                             const dealii::IndexSet& needed)
    : owned_(space.owned()),
      first_(owned_.n_elements() > 0 ? owned_.nth_index_in_set(0) : 0),
      cell_nodes_(space.cell_nodes()) {
  if (!owned_.is_contiguous())
    throw std::logic_error("the unknowns of a rank are not consecutive");
  RankGroup& ranks = mpi_group();
  if (ranks.size() > 1) {
    find_ghosts(space, needed);
    layout_.ghosts = std::make_shared<const GhostValues>(
        ranks, owned() / in_node, ghost_nodes_, in_node);
  }
  layout_.size = owned() + in_node * ghost_nodes_.size();
  take_constraints(space);
  for (std::uint32_t& node : cell_nodes_)
    node = static_cast<std::uint32_t>(of(node));
}

/// Collects the nodes of other ranks. Constraints matter at the nodes of cells
/// only, and no master is constrained itself.
void LocalUnknowns::find_ghosts(const BlockSpace& space,
                                const dealii::IndexSet& needed) {
  const auto take = [&](Unknown unknown) {
    if (!owned_.is_element(unknown))
      ghost_nodes_.push_back(unknown / in_node);
  };
  for (const std::uint32_t node : cell_nodes_) {
    take(node);
    for (Unknown unknown = node; unknown < node + in_node; ++unknown)
      if (const auto* const entries =
              space.constraints().get_constraint_entries(unknown))
        for (const auto& entry : *entries)
          take(entry.first);
  }
  for (const Unknown unknown : needed)
    take(unknown);
  std::ranges::sort(ghost_nodes_);
  ghost_nodes_.erase(std::unique(ghost_nodes_.begin(), ghost_nodes_.end()),
                     ghost_nodes_.end());
}

std::size_t LocalUnknowns::of(Unknown unknown) const {
  if (owned_.is_element(unknown))
    return unknown - first_;
  const auto node = std::ranges::lower_bound(ghost_nodes_, unknown / in_node);
  if (node == ghost_nodes_.end() || *node != unknown / in_node)
    throw std::logic_error("an unknown is not known to this rank");
  return owned() +
         in_node * static_cast<std::size_t>(node - ghost_nodes_.begin()) +
         unknown % in_node;
}

std::vector<LocalUnknowns::Unknown> LocalUnknowns::global() const {
  std::vector<Unknown> numbers;
  numbers.reserve(size());
  for (const Unknown unknown : owned_)
    numbers.push_back(unknown);
  for (const std::size_t node : ghost_nodes_)
    for (unsigned int i = 0; i < in_node; ++i)
      numbers.push_back(static_cast<Unknown>(in_node * node + i));
  return numbers;
}

/// Takes the constraints of the unknowns of cells, whose numbers must still be
/// the global ones.
void LocalUnknowns::take_constraints(const BlockSpace& space) {
  dealii::IndexSet of_cells = owned_;
  if (layout_.ghosts) {
    std::vector<Unknown> unknowns;
    for (const std::uint32_t node : cell_nodes_)
      for (Unknown unknown = node; unknown < node + in_node; ++unknown)
        if (!owned_.is_element(unknown))
          unknowns.push_back(unknown);
    std::ranges::sort(unknowns);
    of_cells.add_indices(unknowns.begin(), unknowns.end());
    of_cells.compress();
  }
  UnknownConstraints found;
  for (const auto& line : space.constraints().get_lines()) {
    if (!of_cells.is_element(line.index))
      continue;
    for (const auto& [master, weight] : line.entries)
      found.add_master(of(master), weight);
    found.add(of(line.index));
  }
  layout_.constraints =
      std::make_shared<const UnknownConstraints>(std::move(found));
}

std::size_t LocalUnknowns::bytes() const {
  return cell_nodes_.size() * sizeof(std::uint32_t) +
         ghost_nodes_.size() * sizeof(std::size_t) +
         layout_.constraints->bytes() +
         (layout_.ghosts ? layout_.ghosts->bytes() : 0);
}

SparseRows contact_rows(const BlockSystem& system,
                        const LocalUnknowns& unknowns) {
  SparseRows rows;
  const ContactPoints& points = system.contact();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const auto& [global, value] : points[i].row) {
      rows.column.push_back(unknowns.of(global));
      rows.weight.push_back(value);
    }
    rows.start.push_back(rows.column.size());
  }
  return rows;
}

} // namespace asperity::fem
