#include "fem/block/lattice_block.hpp"

#include "fem/multigrid/lattice_levels.hpp"
#include "fem/multigrid/rigid_modes.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace asperity::fem {
namespace {

using dealii::Point;
using dealii::types::global_dof_index;

constexpr std::size_t off_lattice = std::numeric_limits<std::size_t>::max();

} // namespace

LatticeBlock::LatticeBlock(const BlockSystem& system, const BoxLattice& lattice)
    : system_(system), multigrid_(lattice), depths_(axes_of(lattice)[2].sides) {
  number_unknowns();
  number_points();
  find_modes();
}

void LatticeBlock::number_unknowns() {
  places_.assign(system_.n_unknowns(), off_lattice);
  for (const auto& cell : system_.space().dof_handler().active_cell_iterators())
    number_cell(cell);
}

/// Numbers the unknowns of a cell. The axes of a cell may be those of the
/// lattice in any order and direction.
void LatticeBlock::number_cell(
    const dealii::DoFHandler<3>::active_cell_iterator& cell) {
  const BlockSpace& space = system_.space();
  const BoxLattice& lattice = multigrid_.lattice();
  const auto& support = space.element().get_unit_support_points();
  std::vector<global_dof_index> unknowns(space.element().n_dofs_per_cell());
  cell->get_dof_indices(unknowns);
  const Point<3> centre = cell->center();
  const auto layer = static_cast<std::size_t>(
      std::upper_bound(depths_.begin(), depths_.end(), centre[2]) -
      depths_.begin() - 1);
  const int degree = lattice.degree;
  const auto wrapped = [&](double place, double width, int nodes) {
    const int node = static_cast<int>(std::lround(place / width * degree));
    return lattice.is_periodic ? node % nodes : node;
  };
  for (unsigned int i = 0; i < unknowns.size(); ++i) {
    Point<3> place = cell->vertex(0);
    for (unsigned int axis = 0; axis < 3; ++axis)
      place += support[i][axis] * (cell->vertex(1U << axis) - cell->vertex(0));
    const double share =
        (place[2] - depths_[layer]) / (depths_[layer + 1] - depths_[layer]);
    const unsigned int component =
        space.element().system_to_component_index(i).first;
    const NodeLayout& layout = multigrid_.layout();
    take(unknowns[i], component,
         layout.index(wrapped(place[0], lattice.width_x(), layout.nodes_x()),
                      wrapped(place[1], lattice.width_y(), layout.nodes_y()),
                      degree * static_cast<int>(layer) +
                          static_cast<int>(std::lround(share * degree)),
                      static_cast<int>(component)));
  }
}

/// Notes the place of an unknown, unless it is constrained; of a constrained
/// one only whether it is a pin.
void LatticeBlock::take(global_dof_index unknown, unsigned int component,
                        std::size_t place) {
  const auto& constraints = system_.space().constraints();
  if (!constraints.is_constrained(unknown)) {
    places_[unknown] = place;
    return;
  }
  const bool is_far_held = component == 2 ? multigrid_.lattice().holds_normal
                                          : multigrid_.lattice().holds_lateral;
  const auto& entries = *constraints.get_constraint_entries(unknown);
  const bool is_zero =
      std::ranges::all_of(entries, [](const auto& e) { return e.second == 0; });
  const bool is_new = std::ranges::none_of(
      pins_, [&](const Pin& pin) { return pin.place == place; });
  if (!is_far_held && is_zero && is_new)
    pins_.push_back({place, component});
}

void LatticeBlock::number_points() {
  const std::vector<std::size_t> face = face_places(multigrid_.layout());
  std::vector<std::size_t> node_at(multigrid_.layout().plane_size(),
                                   off_lattice);
  for (std::size_t node = 0; node < face.size(); ++node)
    node_at[face[node]] = node;
  for (std::size_t i = 0; i < system_.contact().size(); ++i) {
    for (const auto& [unknown, value] : system_.contact()[i].row) {
      points_.column.push_back(node_at[places_[unknown]]);
      points_.weight.push_back(value);
    }
    points_.start.push_back(points_.column.size());
  }
}

void LatticeBlock::to_lattice(const Vector& from,
                              std::vector<double>& to) const {
  to.assign(multigrid_.layout().size(), 0.0);
  const double* const values = from.begin();
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (places_[i] != off_lattice)
      to[places_[i]] = values[i];
}

void LatticeBlock::from_lattice(const std::vector<double>& from,
                                Vector& to) const {
  double* const values = to.begin();
  for (std::size_t i = 0; i < places_.size(); ++i)
    values[i] = places_[i] != off_lattice ? from[places_[i]] : 0.0;
}

void LatticeBlock::vmult(Vector& to, const Vector& from) const {
  to_lattice(from, from_);
  multigrid_.apply(from_, to_);
  from_lattice(to_, to);
}

/// Separates the pins that prevent a rigid motion from those that are held.
void LatticeBlock::find_modes() {
  loose_.clear();
  std::vector<std::size_t> held;
  for (const Pin& pin : pins_)
    if (pin.component == 2 && has_contact_)
      held.push_back(pin.place);
    else
      loose_.push_back(pin);
  modes_ = rigid_modes(multigrid_.lattice(), multigrid_.layout(), has_contact_);
  if (modes_.size() != loose_.size())
    throw std::logic_error("the pins of a lattice do not match its motions");
  multigrid_.pin(std::move(held));
}

void LatticeBlock::prepare(std::span<const double> springs,
                           const std::vector<bool>& held, bool is_sticking) {
  FaceContact contact;
  contact.is_sticking = is_sticking;
  const std::size_t nodes = face_places(multigrid_.layout()).size();
  SparseRows scaled = points_;
  bool has_springs = false;
  for (std::size_t point = 0; point < springs.size(); ++point) {
    has_springs = has_springs || springs[point] != 0.0;
    for (std::size_t i = points_.start[point]; i < points_.start[point + 1];
         ++i) {
      scaled.weight[i] *= springs[point];
      if (!held[point])
        continue;
      contact.held.resize(nodes, false);
      contact.held[points_.column[i]] = true;
    }
  }
  if (has_springs)
    contact.springs = product(transposed(scaled, nodes), points_, nodes);
  if (has_contact_ == contact.is_free()) {
    has_contact_ = !has_contact_;
    find_modes();
  }
  multigrid_.set_contact(std::move(contact));
}

/// Solves M x = right_sides for the matrix M of the motions (rows) at the loose
/// pins (columns), or for its transpose.
std::vector<double>
LatticeBlock::at_pins(const std::vector<double>& right_sides,
                      bool is_transposed) const {
  const auto size = static_cast<unsigned int>(loose_.size());
  dealii::FullMatrix<double> matrix(size);
  dealii::Vector<double> right(size), found(size);
  for (unsigned int mode = 0; mode < size; ++mode) {
    right[mode] = right_sides[mode];
    for (unsigned int pin = 0; pin < size; ++pin)
      (is_transposed ? matrix(pin, mode) : matrix(mode, pin)) =
          modes_[mode][loose_[pin].place];
  }
  matrix.gauss_jordan();
  matrix.vmult(found, right);
  return {found.begin(), found.end()};
}

LinearSolution LatticeBlock::solve(Vector& unknowns, const Vector& forces,
                                   double tolerance, int most_iterations) {
  to_lattice(forces, to_);
  to_lattice(unknowns, from_);
  std::vector<double> sums(modes_.size(), 0.0);
  if (!modes_.empty()) {
    for (std::size_t mode = 0; mode < modes_.size(); ++mode)
      for (std::size_t i = 0; i < to_.size(); ++i)
        sums[mode] -= modes_[mode][i] * to_[i];
    sums = at_pins(sums, false);
    for (std::size_t pin = 0; pin < loose_.size(); ++pin)
      to_[loose_[pin].place] += sums[pin];
  }
  const LinearSolution solution =
      multigrid_.solve(to_, from_, tolerance, most_iterations);
  if (!modes_.empty()) {
    for (std::size_t pin = 0; pin < loose_.size(); ++pin)
      sums[pin] = from_[loose_[pin].place];
    sums = at_pins(sums, true);
    for (std::size_t mode = 0; mode < modes_.size(); ++mode)
      for (std::size_t i = 0; i < from_.size(); ++i)
        from_[i] -= sums[mode] * modes_[mode][i];
  }
  from_lattice(from_, unknowns);
  return solution;
}

std::string LatticeBlock::name() const {
  return "CG, multigrid on the lattice (" + std::to_string(levels()) +
         " levels)";
}

std::size_t LatticeBlock::bytes() const {
  std::size_t numbers = from_.size() + to_.size() + places_.size();
  for (const auto& mode : modes_)
    numbers += mode.size();
  return multigrid_.bytes() + points_.bytes() + 8 * numbers;
}

} // namespace asperity::fem
