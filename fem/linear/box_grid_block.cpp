#include "fem/linear/box_grid_block.hpp"

#include "fem/multigrid/box_grid_levels.hpp"
#include "fem/multigrid/rigid_modes.hpp"
#include "fem/parallel/mpi_group.hpp"
#include "fem/parallel/ranks.hpp"

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

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
                                           const BoxGridSlab& slab,
                                           std::span<const int> targets) {
  return slab.is_shared()
             ? std::make_unique<ValueExchange>(ranks, targets)
             : std::make_unique<ValueExchange>(ranks, targets.size());
}

/// The numbers 0..n-1 by increasing target.
std::vector<std::size_t> order_by(const std::vector<int>& targets) {
  std::vector<std::size_t> order(targets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return targets[i]; });
  return order;
}

} // namespace

UnknownExchange::UnknownExchange(
    RankGroup* ranks, std::span<const std::size_t> numbers,
    const std::function<int(std::size_t number)>& rank_of,
    const std::function<std::size_t(std::size_t number)>& place_of) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i] != nowhere)
      unknowns_.push_back(static_cast<std::uint32_t>(i));
  if (ranks != nullptr && rank_of) {
    std::vector<int> targets;
    targets.reserve(unknowns_.size());
    for (const std::uint32_t unknown : unknowns_)
      targets.push_back(rank_of(numbers[unknown]));
    std::vector<std::uint32_t> ordered;
    for (const std::size_t i : order_by(targets))
      ordered.push_back(unknowns_[i]);
    unknowns_ = std::move(ordered);
    std::ranges::sort(targets);
    values_.emplace(*ranks, targets);
  } else if (ranks != nullptr) {
    values_.emplace(*ranks, unknowns_.size());
  }
  std::vector<std::size_t> received;
  received.reserve(unknowns_.size());
  for (const std::uint32_t unknown : unknowns_)
    received.push_back(numbers[unknown]);
  if (values_)
    received = values_->sent(std::span<const std::size_t>(received));
  places_.reserve(received.size());
  for (const std::size_t number : received)
    places_.push_back(static_cast<std::uint32_t>(place_of(number)));
}

void UnknownExchange::send(const Vector& from, std::span<double> to) const {
  std::ranges::fill(to, 0.0);
  const double* const values = from.begin();
  if (!values_) {
    for (std::size_t i = 0; i < places_.size(); ++i)
      to[places_[i]] = values[unknowns_[i]];
    return;
  }
  std::vector<double> own;
  own.reserve(unknowns_.size());
  for (const std::uint32_t unknown : unknowns_)
    own.push_back(values[unknown]);
  const std::vector<double> all = values_->sent(std::span<const double>(own));
  for (std::size_t i = 0; i < places_.size(); ++i)
    to[places_[i]] = all[i];
}

void UnknownExchange::give_back(std::span<const double> from,
                                Vector& to) const {
  double* const values = to.begin();
  std::fill(to.begin(), to.end(), 0.0);
  if (!values_) {
    for (std::size_t i = 0; i < places_.size(); ++i)
      values[unknowns_[i]] = from[places_[i]];
    return;
  }
  std::vector<double> all;
  all.reserve(places_.size());
  for (const std::uint32_t place : places_)
    all.push_back(from[place]);
  const std::vector<double> own =
      values_->returned(std::span<const double>(all));
  for (std::size_t i = 0; i < own.size(); ++i)
    values[unknowns_[i]] = own[i];
}

BoxGridNumbering::BoxGridNumbering(const BlockSystem& system,
                                   const BoxGrid& box_grid)
    : nodes(system.space().owned().n_elements(), SlabPlaces::nowhere),
      layout_(box_grid),
      depths_(axes_of(box_grid)[2].sides) {
  if (!system.space().owned().is_contiguous())
    throw std::logic_error("the unknowns of a rank are not consecutive");
  if (!nodes.empty())
    first_owned_ = system.space().owned().nth_index_in_set(0);
  for (const auto& cell : system.space().dof_handler().active_cell_iterators())
    if (cell->is_locally_owned())
      add_cell(system, box_grid, cell);
}

/// Numbers the unknowns of a cell. The axes of a cell may be those of the
/// grid of boxes in any order and direction.
void BoxGridNumbering::add_cell(
    const BlockSystem& system, const BoxGrid& box_grid,
    const dealii::DoFHandler<3>::active_cell_iterator& cell) {
  const BlockSpace& space = system.space();
  const auto& support = space.element().get_unit_support_points();
  std::vector<global_dof_index> unknowns(space.element().n_dofs_per_cell());
  cell->get_dof_indices(unknowns);
  const Point<3> centre = cell->center();
  const auto layer = static_cast<std::size_t>(
      std::upper_bound(depths_.begin(), depths_.end(), centre[2]) -
      depths_.begin() - 1);
  const int degree = box_grid.degree;
  const auto wrapped = [&](double place, double width, int n) {
    const int node = static_cast<int>(std::lround(place / width * degree));
    return box_grid.is_periodic ? node % n : node;
  };
  for (unsigned int i = 0; i < unknowns.size(); ++i) {
    Point<3> place = cell->vertex(0);
    for (unsigned int axis = 0; axis < 3; ++axis)
      place += support[i][axis] * (cell->vertex(1U << axis) - cell->vertex(0));
    const double share =
        (place[2] - depths_[layer]) / (depths_[layer + 1] - depths_[layer]);
    const unsigned int component =
        space.element().system_to_component_index(i).first;
    take(space, box_grid, unknowns[i], component,
         layout_.index(wrapped(place[0], box_grid.width_x(), layout_.nodes_x()),
                       wrapped(place[1], box_grid.width_y(), layout_.nodes_y()),
                       degree * static_cast<int>(layer) +
                           static_cast<int>(std::lround(share * degree)),
                       static_cast<int>(component)));
  }
}

/// Notes the node of an unknown, unless it is constrained; of a constrained one
/// only whether it is a pin or the image of a node of the contact surface.
void BoxGridNumbering::take(const BlockSpace& space, const BoxGrid& box_grid,
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
      component == 2 ? box_grid.holds_normal : box_grid.holds_lateral;
  const auto& entries = *constraints.get_constraint_entries(unknown);
  const bool is_zero =
      std::ranges::all_of(entries, [](const auto& e) { return e.second == 0; });
  if (is_zero && !is_far_held)
    pins.push_back({node, component});
  if (!is_zero && is_on_face)
    face[entries.front().first] = node;
}

BoxGridExchange::BoxGridExchange(const BlockSystem& system,
                                 const BoxGrid& box_grid,
                                 const BoxGridSlab& slab, RankGroup* ranks,
                                 const BoxGridNumbering& numbering)
    : ranks_(ranks),
      sharing_(slab.ranks()),
      size_(slab.layout(box_grid).size()),
      unknowns_(unknowns_of(box_grid, slab, ranks, numbering)) {
  number_points(system, box_grid, slab, numbering);
}

UnknownExchange
BoxGridExchange::unknowns_of(const BoxGrid& box_grid, const BoxGridSlab& slab,
                             RankGroup* ranks,
                             const BoxGridNumbering& numbering) {
  const SlabPlaces places(box_grid, slab);
  std::function<int(std::size_t)> rank_of;
  if (slab.is_shared())
    rank_of = [&](std::size_t node) {
      return slab.rank_of(places.slice_of(node), box_grid.degree);
    };
  return {ranks, numbering.nodes, rank_of,
          [&](std::size_t node) { return places.of(node); }};
}

/// A contact point belongs to the rank that has the row of cells in which it
/// lies.
void BoxGridExchange::number_points(const BlockSystem& system,
                                    const BoxGrid& box_grid,
                                    const BoxGridSlab& slab,
                                    const BoxGridNumbering& numbering) {
  const ContactPoints& points = system.contact();
  std::vector<int> targets;
  for (std::size_t i = 0; i < points.size(); ++i) {
    constexpr double rounding = 1e-6;
    const int row = static_cast<int>(
        std::floor(points[i].place[1] / box_grid.width_y() + rounding));
    targets.push_back(slab.rank_of(row * box_grid.degree, box_grid.degree));
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
  const SlabPlaces places(box_grid, slab);
  for (const FaceEntry& entry : entries) {
    points_.column.push_back(places.with_images(entry.node));
    points_.weight.push_back(entry.value);
  }
  for (const std::uint32_t size : sizes)
    points_.start.push_back(points_.start.back() + size);
}

void BoxGridExchange::to_box_grid(const Vector& from,
                                  std::vector<double>& to) const {
  to.resize(size_);
  unknowns_.send(from, to);
}

void BoxGridExchange::from_box_grid(const std::vector<double>& from,
                                    Vector& to) const {
  unknowns_.give_back(from, to);
}

MeshContact BoxGridExchange::contact(std::span<const double> springs,
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

std::size_t BoxGridExchange::bytes() const {
  return unknowns_.bytes() + order_.size() * sizeof(std::size_t) +
         points_.bytes();
}

BoxGridBlock::BoxGridBlock(const BlockSystem& system, const BoxGrid& box_grid)
    : BoxGridBlock(system, box_grid, BoxGridNumbering(system, box_grid)) {}

BoxGridBlock::BoxGridBlock(const BlockSystem& system, const BoxGrid& box_grid,
                           const BoxGridNumbering& numbering)
    : ranks_(n_ranks() > 1 ? &mpi_group() : nullptr),
      multigrid_(box_grid, ranks_),
      exchange_(system, box_grid, multigrid_.slab(), ranks_, numbering) {
  take_pins(numbering);
  find_modes();
}

/// Takes the pins of all ranks, each once.
void BoxGridBlock::take_pins(const BoxGridNumbering& numbering) {
  std::vector<BoxGridNumbering::Pin> pins = numbering.pins;
  if (ranks_ != nullptr)
    pins = ValueExchange(*ranks_, pins.size())
               .sent(std::span<const BoxGridNumbering::Pin>(pins));
  const SlabPlaces places(multigrid_.box_grid(), multigrid_.slab());
  for (const BoxGridNumbering::Pin& pin : pins)
    if (std::ranges::none_of(
            pins_, [&](const Pin& own) { return own.node == pin.node; }))
      pins_.push_back({pin.node, places.of(pin.node), pin.component});
}

void BoxGridBlock::vmult(Vector& to, const Vector& from) const {
  exchange_.to_box_grid(from, from_);
  multigrid_.apply(from_, to_);
  exchange_.from_box_grid(to_, to);
}

/// Separates the pins that prevent a rigid motion from those that are held.
void BoxGridBlock::find_modes() {
  loose_.clear();
  held_pins_.clear();
  for (const Pin& pin : pins_)
    if (pin.component != 2 || !has_contact_)
      loose_.push_back(pin);
    else if (pin.place != SlabPlaces::nowhere)
      held_pins_.push_back(pin.place);
  modes_ = rigid_modes(multigrid_.box_grid(), multigrid_.slab(), has_contact_);
  if (modes_.size() != loose_.size())
    throw std::logic_error(
        "the pins of a grid of boxes do not match its motions");
  at_loose_.clear();
  for (const auto& mode : modes_)
    for (const Pin& pin : loose_)
      at_loose_.push_back(multigrid_.slab().sum(
          pin.place != SlabPlaces::nowhere ? mode[pin.place] : 0.0));
}

void BoxGridBlock::prepare(std::span<const double> springs,
                           const std::vector<bool>& held, bool is_sticking) {
  MeshContact contact = exchange_.contact(springs, held, is_sticking);
  if (has_contact_ ==
      (multigrid_.slab().sum(contact.is_free() ? 0.0 : 1.0) == 0.0)) {
    has_contact_ = !has_contact_;
    find_modes();
  }
  contact.pinned = held_pins_;
  multigrid_.set_contact(std::move(contact));
}

/// Solves M x = right_sides for the matrix M of the motions (rows) at the loose
/// pins (columns), or for its transpose.
std::vector<double>
BoxGridBlock::at_pins(const std::vector<double>& right_sides,
                      bool is_transposed) const {
  const auto size = static_cast<unsigned int>(loose_.size());
  dealii::FullMatrix<double> matrix(size);
  dealii::Vector<double> right(size), found(size);
  for (unsigned int mode = 0; mode < size; ++mode) {
    right[mode] = right_sides[mode];
    for (unsigned int pin = 0; pin < size; ++pin)
      (is_transposed ? matrix(pin, mode) : matrix(mode, pin)) =
          at_loose_[mode * size + pin];
  }
  matrix.gauss_jordan();
  matrix.vmult(found, right);
  return {found.begin(), found.end()};
}

/// Lets the loose pins carry the sums of the forces.
void BoxGridBlock::balance_forces() {
  std::vector<double> sums(modes_.size(), 0.0);
  for (std::size_t mode = 0; mode < modes_.size(); ++mode)
    for (std::size_t i = 0; i < to_.size(); ++i)
      sums[mode] -= modes_[mode][i] * to_[i];
  for (double& sum : sums)
    sum = multigrid_.slab().sum(sum);
  sums = at_pins(sums, false);
  for (std::size_t pin = 0; pin < loose_.size(); ++pin)
    if (loose_[pin].place != SlabPlaces::nowhere)
      to_[loose_[pin].place] += sums[pin];
}

/// Subtracts the motions that the loose pins show.
void BoxGridBlock::remove_motions() {
  std::vector<double> sums(modes_.size(), 0.0);
  for (std::size_t pin = 0; pin < loose_.size(); ++pin)
    if (loose_[pin].place != SlabPlaces::nowhere)
      sums[pin] = from_[loose_[pin].place];
  for (double& sum : sums)
    sum = multigrid_.slab().sum(sum);
  sums = at_pins(sums, true);
  for (std::size_t mode = 0; mode < modes_.size(); ++mode)
    for (std::size_t i = 0; i < from_.size(); ++i)
      from_[i] -= sums[mode] * modes_[mode][i];
}

LinearSolution BoxGridBlock::solve(Vector& unknowns, const Vector& forces,
                                   double tolerance, int most_iterations) {
  exchange_.to_box_grid(forces, to_);
  exchange_.to_box_grid(unknowns, from_);
  if (!modes_.empty())
    balance_forces();
  multigrid_.force() = to_;
  const LinearSolution solution =
      multigrid_.solve(from_, tolerance, most_iterations);
  if (!modes_.empty())
    remove_motions();
  exchange_.from_box_grid(from_, unknowns);
  return solution;
}

std::string BoxGridBlock::name() const {
  return "CG, multigrid on the grid of boxes (" + std::to_string(levels()) +
         " levels)";
}

std::size_t BoxGridBlock::bytes() const {
  std::size_t numbers = from_.size() + to_.size();
  for (const auto& mode : modes_)
    numbers += mode.size();
  return multigrid_.bytes() + exchange_.bytes() + sizeof(double) * numbers;
}

} // namespace asperity::fem
