#include "fem/linear/mesh_block.hpp"

#include "fem/parallel/mpi_group.hpp"

#include <algorithm>
#include <cmath>
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

MeshBlock::MeshBlock(const BlockSystem& system,
                     std::shared_ptr<LocalUnknowns> unknowns,
                     MeshStiffness stiffness,
                     std::unique_ptr<MeshCorrection> correction)
    : system_(system),
      unknowns_(std::move(unknowns)),
      points_(contact_rows(system, *unknowns_)),
      multigrid_(std::move(stiffness)),
      correction_(std::move(correction)) {
  unknowns_->forget_cells();
  multigrid_.set_correction([this](const auto& residual, auto& displacement) {
    correction_->add(residual, displacement, multigrid_.unit());
  });
}

void MeshBlock::vmult(Vector& to, const Vector& from) const {
  copy_owned(from, displacement_);
  std::vector<double>& force = multigrid_.force();
  multigrid_.apply(displacement_, force);
  std::copy_n(force.begin(), unknowns_->owned(), to.begin());
}

void MeshBlock::prepare(std::span<const double> springs,
                        const std::vector<bool>& held, bool is_sticking) {
  std::vector<double> softened(springs.begin(), springs.end());
  const std::vector<bool> is_pair = soften_pairs(softened);
  const UnknownLayout& layout = unknowns_->layout();
  MeshContact contact =
      contact_of_points(points_, {springs, held, is_sticking, &is_pair},
                        layout.size, layout.ranks());
  contact.pairs.ghosts = layout.ghosts;
  correction_->prepare(softened, held, is_sticking, contact);
  multigrid_.set_contact(std::move(contact));
}

LinearSolution MeshBlock::solve(Vector& unknowns, const Vector& forces,
                                double tolerance, int most_iterations) {
  copy_owned(forces, multigrid_.force());
  copy_owned(unknowns, displacement_);
  // A correction of another contact state may be useless for this one.
  constexpr int most_with_old = 50;
  const bool is_old = !correction_->is_current();
  LinearSolution solution = multigrid_.solve(
      displacement_, tolerance,
      is_old ? std::min(most_with_old, most_iterations) : most_iterations);
  if (solution.has_converged || !is_old) {
    correction_->check_efficiency(
        solution.iterations,
        std::log10(solution.first_residual / solution.last_residual));
  } else {
    const int before = solution.iterations;
    correction_->renew();
    copy_owned(forces, multigrid_.force());
    solution = multigrid_.solve(displacement_, tolerance, most_iterations);
    solution.iterations += before;
  }
  multigrid_.clear_held(displacement_);
  std::copy_n(displacement_.begin(), unknowns_->owned(), unknowns.begin());
  return solution;
}

std::size_t MeshBlock::bytes() const {
  return unknowns_->bytes() + points_.bytes() + multigrid_.bytes() +
         correction_->bytes() + displacement_.size() * sizeof(double);
}

/// Finds the points whose springs make a contact pair, those that are stiffer
/// than the node of the first body, and softens them for the correction. Its
/// functions have no relative displacement there: the node follows the face of
/// the other body. Moving it by e from where the function would have it costs
/// at most k e^2/2, with the bound k on the stiffness of the node, and a spring
/// of this kind is what the correction has for that. With 3 k, the stiffness of
/// the correction is at least 3/4 of that of its functions.
/// @return  of each point, or empty if no points can be pairs
std::vector<bool> MeshBlock::soften_pairs(std::vector<double>& springs) const {
  constexpr double stiff = 2.0;
  constexpr double kept = 3.0;
  std::vector<bool> is_pair;
  if (!system_.has_counter())
    return is_pair;
  is_pair.resize(springs.size());
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const double own =
        multigrid_.stiffness_bound(points_.column[points_.start[i]]);
    is_pair[i] = springs[i] > stiff * own;
    if (is_pair[i])
      springs[i] = std::min(springs[i], kept * own);
  }
  return is_pair;
}

/// Copies the own unknowns; those of other ranks are zero.
void MeshBlock::copy_owned(const Vector& from, std::vector<double>& to) const {
  to.assign(from.begin(), from.end());
  to.resize(unknowns_->size(), 0.0);
}

} // namespace asperity::fem
