#include "fem/block/all_ranks.hpp"
#include "fem/block/block_space.hpp"
#include "fem/block/place_map.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace asperity::fem {
namespace {

using dealii::Point;
using dealii::types::global_dof_index;
using meshes::FaceGroup;

/// Shifts the second body away from the first. The bodies touch at z = 0; the
/// shift keeps a node of one from being taken for a node of the other.
Point<3> apart(Point<3> place, bool is_counter, double depth) {
  if (is_counter)
    place[2] -= depth;
  return place;
}

/// Gathers the nodes of all ranks as numbers: the place and the unknowns, six
/// numbers per node.
std::vector<double> gathered(const std::vector<FaceNode>& nodes, double depth) {
  std::vector<double> mine;
  mine.reserve(6 * nodes.size());
  for (const FaceNode& node : nodes) {
    const Point<3> place = apart(node.place, node.is_counter, depth);
    for (unsigned int i = 0; i < 3; ++i)
      mine.push_back(place[i]);
    for (const global_dof_index unknown : node.unknowns)
      mine.push_back(static_cast<double>(unknown));
  }
  return of_all_ranks(mine);
}

/// The place with the smallest badness over all ranks. Ties are broken by the
/// smallest x, then y, so the result does not depend on the distribution of
/// cells.
Point<3> best_place(const std::vector<FaceNode>& nodes, double tolerance,
                    const std::function<double(const Point<3>&)>& badness) {
  std::array<double, 4> best{1e300, 0.0, 0.0, 0.0};
  const auto take = [&](const std::array<double, 4>& other) {
    const double difference = other[0] - best[0];
    const bool is_equal = std::abs(difference) < tolerance;
    const bool is_first =
        other[1] < best[1] - tolerance ||
        (std::abs(other[1] - best[1]) < tolerance && other[2] < best[2]);
    if (is_equal ? is_first : difference < 0.0)
      best = other;
  };
  for (const FaceNode& node : nodes)
    take({badness(node.place), node.place[0], node.place[1], node.place[2]});
  for (const auto& other : of_all_ranks(std::vector{best}))
    take(other);
  return Point<3>(best[1], best[2], best[3]);
}

} // namespace

void BlockSpace::constrain(const BlockProblem& problem) {
  if (problem.far_boundary == mechanics::FarBoundary::pressure &&
      problem.sides == mechanics::BlockSides::free)
    throw std::domain_error(
        "top = pressure with sides = free: the block can tilt as a rigid body; "
        "choose top = clamped or sliding");
  if (problem.far_boundary == mechanics::FarBoundary::pressure &&
      problem.counter_mesh)
    throw std::domain_error(
        "top = pressure with a counter-body of finite size: this body can tilt "
        "as a rigid body; choose top = clamped or sliding");
  constraints_.reinit(relevant_);
  dealii::DoFTools::make_hanging_node_constraints(dof_handler_, constraints_);
  hold_far_boundary(problem);
  if (problem.sides == mechanics::BlockSides::periodic)
    identify_sides();
  constraints_.close();
}

void BlockSpace::hold_far_boundary(const BlockProblem& problem) {
  const std::vector<FaceNode> nodes = face_nodes(FaceGroup::far_boundary);
  if (dealii::Utilities::MPI::sum(nodes.size(), MPI_COMM_WORLD) == 0)
    throw std::domain_error("the mesh has no face in the group fixed");
  for (const FaceNode& node : nodes)
    for (unsigned int i = 0; i < 3; ++i)
      if (problem.far_boundary == mechanics::FarBoundary::clamped ||
          (problem.far_boundary == mechanics::FarBoundary::sliding && i == 2))
        constraints_.add_line(node.unknowns[i]);
  if (problem.far_boundary == mechanics::FarBoundary::clamped)
    return;
  pin(problem, nodes, false);
  if (problem.counter)
    pin(problem, nodes, true);
}

/// Removes the rigid-body motions that the far boundary leaves to one body.
void BlockSpace::pin(const BlockProblem& problem,
                     const std::vector<FaceNode>& nodes, bool is_counter) {
  std::vector<FaceNode> own;
  for (const FaceNode& node : nodes)
    if (node.is_counter == is_counter &&
        node.place[0] < lengths_[0] - tolerance_ &&
        node.place[1] < lengths_[1] - tolerance_)
      own.push_back(node);
  const auto hold = [&](const Point<3>& place, unsigned int component) {
    for (const FaceNode& node : own)
      if (node.place.distance(place) < tolerance_ &&
          !constraints_.is_constrained(node.unknowns[component]))
        constraints_.add_line(node.unknowns[component]);
  };
  const Point<3> middle(lengths_[0] / 2.0, lengths_[1] / 2.0,
                        is_counter ? -counter_depth_ : lengths_[2]);
  const Point<3> pinned = best_place(
      own, tolerance_, [&](const Point<3>& p) { return p.distance(middle); });
  for (unsigned int i = 0; i < 3; ++i)
    hold(pinned, i);
  if (problem.sides == mechanics::BlockSides::periodic &&
      !(is_counter && problem.counter_mesh))
    return;
  // The second node may move towards the first and away from it, but not
  // sideways.
  const Point<3> second = best_place(own, tolerance_, [&](const Point<3>& p) {
    return std::abs(p[1] - pinned[1]) - std::abs(p[0] - pinned[0]);
  });
  for (const FaceNode& node : own)
    if (node.place.distance(second) < tolerance_ &&
        !constraints_.is_constrained(node.unknowns[1])) {
      constraints_.add_line(node.unknowns[1]);
      constraints_.add_entry(node.unknowns[1], node.unknowns[0],
                             (second[1] - pinned[1]) / (second[0] - pinned[0]));
    }
}

/// Constrains each node at x = length_x or y = length_y to its root, the node
/// that it is the periodic image of. The roots are few compared with the
/// unknowns and are made known to all ranks, so that no chain of images ends at
/// a rank beyond the neighbour. A second-order cell may have a node at the
/// place of a hanging one of smaller cells, which depends on it: then the
/// former is the root, because its image's rank need not know what the latter
/// depends on.
void BlockSpace::identify_sides() {
  const auto root_place = [&](Point<3> place) {
    for (unsigned int i = 0; i < 2; ++i)
      if (std::abs(place[i] - lengths_[i]) < tolerance_)
        place[i] = 0.0;
    return place;
  };
  const auto is_root = [&](const Point<3>& place) {
    return root_place(place).distance(place) < tolerance_;
  };
  const auto is_hanging = [&](const FaceNode& node) {
    const auto* const entries =
        constraints_.get_constraint_entries(node.unknowns[2]);
    return entries != nullptr && !entries->empty();
  };
  std::vector<FaceNode> roots, hanging_roots;
  for (const FaceGroup side : {FaceGroup::left, FaceGroup::front})
    for (const FaceNode& node : face_nodes(side))
      if (owned_.is_element(node.unknowns[2]) && is_root(node.place))
        (is_hanging(node) ? hanging_roots : roots).push_back(node);
  std::vector<double> all = gathered(roots, lengths_[2]);
  const std::vector<double> others = gathered(hanging_roots, lengths_[2]);
  all.insert(all.end(), others.begin(), others.end());
  PlaceMap where(tolerance_);
  for (std::size_t i = 0; i < all.size(); i += 6) {
    const Point<3> place(all[i], all[i + 1], all[i + 2]);
    if (!where.find(place))
      where.insert(place, i);
  }

  int lost = 0;
  Point<3> first_lost;
  for (const FaceGroup side : {FaceGroup::right, FaceGroup::back})
    for (const FaceNode& node : face_nodes(side)) {
      const auto root = where.find(
          apart(root_place(node.place), node.is_counter, lengths_[2]));
      if (!root) {
        first_lost = lost++ == 0 ? node.place : first_lost;
        continue;
      }
      for (unsigned int i = 0; i < 3; ++i) {
        const auto unknown = static_cast<global_dof_index>(all[*root + 3 + i]);
        if (constraints_.is_constrained(node.unknowns[i]))
          continue;
        constraints_.add_line(node.unknowns[i]);
        constraints_.add_entry(node.unknowns[i], unknown, 1.0);
      }
    }
  if (dealii::Utilities::MPI::max(lost, MPI_COMM_WORLD) == 0)
    return;
  throw std::domain_error(fmt::format(
      "the periodic sides do not match: {} nodes of this rank have no partner"
      "{}",
      lost,
      lost == 0 ? ""
                : fmt::format(", the first at x = {:.6g} m, y = {:.6g} m, z = "
                              "{:.6g} m",
                              first_lost[0], first_lost[1], first_lost[2])));
}

} // namespace asperity::fem
