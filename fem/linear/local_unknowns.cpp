#include "fem/linear/local_unknowns.hpp"

#include "fem/linear/block_solver.hpp"
#include "fem/parallel/mpi_group.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace asperity::fem {
namespace {

constexpr unsigned int in_node = 3; // unknowns

/// Appends the node of a contact point, the first of its row, and the face of
/// the other body, which the row subtracts.
void append_pair(const FaceRow& row, double spring,
                 const LocalUnknowns& unknowns, ContactPairs& pairs) {
  pairs.nodes.push_back(unknowns.of(row.front().first));
  pairs.springs.push_back(spring);
  for (std::size_t entry = 1; entry < row.size(); ++entry) {
    pairs.faces.column.push_back(unknowns.of(row[entry].first));
    pairs.faces.weight.push_back(-row[entry].second);
  }
  pairs.faces.start.push_back(pairs.faces.column.size());
}

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
    ghosts_ = std::make_unique<GhostValues>(ranks, owned() / in_node,
                                            ghost_nodes_, in_node);
  }
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
  if (ghosts_) {
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
  constraints_ = std::make_shared<const UnknownConstraints>(std::move(found));
}

std::size_t LocalUnknowns::bytes() const {
  return cell_nodes_.size() * sizeof(std::uint32_t) +
         ghost_nodes_.size() * sizeof(std::size_t) + constraints_->bytes() +
         (ghosts_ ? ghosts_->bytes() : 0);
}

MeshContact mesh_contact(const BlockSystem& system,
                         const LocalUnknowns& unknowns,
                         std::span<const double> springs,
                         const std::vector<bool>& held, bool is_sticking,
                         const std::vector<bool>& is_pair) {
  MeshContact contact;
  SparseRows points; // by number of an unknown in contact.unknowns
  std::vector<std::size_t> number(unknowns.size(), 0);
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const auto& row = system.contact()[i].row;
    if (held[i])
      append_held(static_cast<dealii::types::global_dof_index>(
                      unknowns.of(row.front().first)),
                  is_sticking, contact.held);
    if (springs[i] == 0.0)
      continue;
    if (!is_pair.empty() && is_pair[i]) {
      append_pair(row, springs[i], unknowns, contact.pairs);
      continue;
    }
    for (const auto& [global, value] : row) {
      const std::size_t unknown = unknowns.of(global);
      if (number[unknown] == 0) {
        contact.unknowns.push_back(unknown);
        number[unknown] = contact.unknowns.size();
      }
      points.column.push_back(number[unknown] - 1);
      points.weight.push_back(value * std::sqrt(springs[i]));
    }
    points.start.push_back(points.column.size());
  }
  const std::size_t size = contact.unknowns.size();
  if (size > 0)
    contact.springs = product(transposed(points, size), points, size);
  contact.has_springs =
      dealii::Utilities::MPI::max(size > 0 ? 1 : 0, MPI_COMM_WORLD) == 1;
  contact.pairs.exist =
      dealii::Utilities::MPI::max(contact.pairs.nodes.empty() ? 0 : 1,
                                  MPI_COMM_WORLD) == 1;
  contact.pairs.ghosts = unknowns.ghosts();
  return contact;
}

} // namespace asperity::fem
