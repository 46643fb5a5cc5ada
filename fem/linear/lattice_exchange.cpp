#include "fem/linear/lattice_exchange.hpp"

#include "fem/multigrid/lattice_levels.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asperity::fem {
namespace {

using dealii::Point;
using dealii::types::global_dof_index;

/// A node in the row of a contact point.
struct FaceEntry {
  std::uint64_t node;
  double value;
};

/// The rank for each value, or nothing if every rank receives all.
std::unique_ptr<ValueExchange> exchange_of(RankGroup& ranks,
                                           const LatticeSlab& slab,
                                           std::span<const int> targets) {
  return slab.is_shared()
             ? std::make_unique<ValueExchange>(ranks, targets)
             : std::make_unique<ValueExchange>(ranks, targets.size());
}

} // namespace

LatticeNumbering::LatticeNumbering(const BlockSystem& system,
                                   const BoxLattice& lattice)
    : nodes(system.space().owned().n_elements(), SlabPlaces::nowhere),
      layout_(lattice),
      depths_(axes_of(lattice)[2].sides) {
  if (!system.space().owned().is_contiguous())
    throw std::logic_error("the unknowns of a rank are not consecutive");
  if (!nodes.empty())
    first_owned_ = system.space().owned().nth_index_in_set(0);
  for (const auto& cell : system.space().dof_handler().active_cell_iterators())
    if (cell->is_locally_owned())
      add_cell(system, lattice, cell);
}

/// Numbers the unknowns of a cell. The axes of a cell may be those of the
/// lattice in any order and direction.
void LatticeNumbering::add_cell(
    const BlockSystem& system, const BoxLattice& lattice,
    const dealii::DoFHandler<3>::active_cell_iterator& cell) {
  const BlockSpace& space = system.space();
  const auto& support = space.element().get_unit_support_points();
  std::vector<global_dof_index> unknowns(space.element().n_dofs_per_cell());
  cell->get_dof_indices(unknowns);
  const Point<3> centre = cell->center();
  const auto layer = static_cast<std::size_t>(
      std::upper_bound(depths_.begin(), depths_.end(), centre[2]) -
      depths_.begin() - 1);
  const int degree = lattice.degree;
  const auto wrapped = [&](double place, double width, int n) {
    const int node = static_cast<int>(std::lround(place / width * degree));
    return lattice.is_periodic ? node % n : node;
  };
  for (unsigned int i = 0; i < unknowns.size(); ++i) {
    Point<3> place = cell->vertex(0);
    for (unsigned int axis = 0; axis < 3; ++axis)
      place += support[i][axis] * (cell->vertex(1U << axis) - cell->vertex(0));
    const double share =
        (place[2] - depths_[layer]) / (depths_[layer + 1] - depths_[layer]);
    const unsigned int component =
        space.element().system_to_component_index(i).first;
    take(space, lattice, unknowns[i], component,
         layout_.index(wrapped(place[0], lattice.width_x(), layout_.nodes_x()),
                       wrapped(place[1], lattice.width_y(), layout_.nodes_y()),
                       degree * static_cast<int>(layer) +
                           static_cast<int>(std::lround(share * degree)),
                       static_cast<int>(component)));
  }
}

/// Notes the node of an unknown, unless it is constrained; of a constrained one
/// only whether it is a pin or the image of a node of the contact surface.
void LatticeNumbering::take(const BlockSpace& space, const BoxLattice& lattice,
                            global_dof_index unknown, unsigned int component,
                            std::size_t node) {
  const auto& constraints = space.constraints();
  const bool is_on_face =
      component == 2 && node % layout_.slice_size() < layout_.row_size();
  if (!constraints.is_constrained(unknown)) {
    // Searching the set of owned unknowns would take longer than all else.
    if (unknown >= first_owned_ && unknown - first_owned_ < nodes.size())
      nodes[unknown - first_owned_] = node;
    if (is_on_face)
      face[unknown] = node;
    return;
  }
  const bool is_far_held =
      component == 2 ? lattice.holds_normal : lattice.holds_lateral;
  const auto& entries = *constraints.get_constraint_entries(unknown);
  const bool is_zero =
      std::ranges::all_of(entries, [](const auto& e) { return e.second == 0; });
  if (is_zero && !is_far_held)
    pins.push_back({node, component});
  if (!is_zero && is_on_face)
    face[entries.front().first] = node;
}

LatticeExchange::LatticeExchange(const BlockSystem& system,
                                 const BoxLattice& lattice,
                                 const LatticeSlab& slab, RankGroup* ranks,
                                 const LatticeNumbering& numbering)
    : ranks_(ranks),
      sharing_(slab.ranks()),
      size_(slab.layout(lattice).size()),
      unknowns_(unknowns_of(lattice, slab, ranks, numbering)) {
  number_points(system, lattice, slab, numbering);
}

UnknownExchange
LatticeExchange::unknowns_of(const BoxLattice& lattice, const LatticeSlab& slab,
                             RankGroup* ranks,
                             const LatticeNumbering& numbering) {
  const SlabPlaces places(lattice, slab);
  std::function<int(std::size_t)> rank_of;
  if (slab.is_shared())
    rank_of = [&](std::size_t node) {
      return slab.rank_of(places.slice_of(node), lattice.degree);
    };
  return {ranks, numbering.nodes, rank_of,
          [&](std::size_t node) { return places.of(node); }};
}

/// A contact point belongs to the rank that has the row of cells in which it
/// lies.
void LatticeExchange::number_points(const BlockSystem& system,
                                    const BoxLattice& lattice,
                                    const LatticeSlab& slab,
                                    const LatticeNumbering& numbering) {
  const ContactPoints& points = system.contact();
  std::vector<int> targets;
  for (std::size_t i = 0; i < points.size(); ++i) {
    constexpr double rounding = 1e-6;
    const int row = static_cast<int>(
        std::floor(points[i].place[1] / lattice.width_y() + rounding));
    targets.push_back(slab.rank_of(row * lattice.degree, lattice.degree));
  }
  order_ = order_by(targets);
  std::vector<std::uint32_t> sizes;
  std::vector<FaceEntry> entries;
  std::vector<int> entry_targets;
  for (const std::size_t i : order_) {
    sizes.push_back(static_cast<std::uint32_t>(points[i].row.size()));
    for (const auto& [unknown, value] : points[i].row) {
      entries.push_back({numbering.face.at(unknown), value});
      entry_targets.push_back(targets[i]);
    }
  }
  if (ranks_ != nullptr) {
    std::ranges::sort(targets);
    point_values_ = exchange_of(*ranks_, slab, targets);
    sizes = point_values_->sent(std::span<const std::uint32_t>(sizes));
    entries = exchange_of(*ranks_, slab, entry_targets)
                  ->sent(std::span<const FaceEntry>(entries));
  }
  const SlabPlaces places(lattice, slab);
  for (const FaceEntry& entry : entries) {
    points_.column.push_back(places.with_images(entry.node));
    points_.weight.push_back(entry.value);
  }
  for (const std::uint32_t size : sizes)
    points_.start.push_back(points_.start.back() + size);
}

void LatticeExchange::to_lattice(const Vector& from,
                                 std::vector<double>& to) const {
  to.resize(size_);
  unknowns_.send(from, to);
}

void LatticeExchange::from_lattice(const std::vector<double>& from,
                                   Vector& to) const {
  unknowns_.give_back(from, to);
}

MeshContact LatticeExchange::contact(std::span<const double> springs,
                                     const std::vector<bool>& held,
                                     bool is_sticking) const {
  std::vector<double> stiffness;
  std::vector<std::uint8_t> flags;
  for (const std::size_t i : order_) {
    stiffness.push_back(springs[i]);
    flags.push_back(held[i] ? 1 : 0);
  }
  if (ranks_ != nullptr) {
    stiffness = point_values_->sent(std::span<const double>(stiffness));
    flags = point_values_->sent(std::span<const std::uint8_t>(flags));
  }
  const std::vector<bool> is_held(flags.begin(), flags.end());
  return contact_of_points(points_, {stiffness, is_held, is_sticking}, size_,
                           sharing_);
}

std::size_t LatticeExchange::bytes() const {
  return unknowns_.bytes() + order_.size() * sizeof(std::size_t) +
         points_.bytes();
}

} // namespace asperity::fem
