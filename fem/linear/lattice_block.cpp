#include "fem/linear/lattice_block.hpp"

#include "fem/multigrid/rigid_modes.hpp"
#include "fem/parallel/mpi_group.hpp"
#include "fem/parallel/ranks.hpp"

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace asperity::fem {

LatticeBlock::LatticeBlock(const BlockSystem& system, const BoxLattice& lattice)
    : LatticeBlock(system, lattice, LatticeNumbering(system, lattice)) {}

LatticeBlock::LatticeBlock(const BlockSystem& system, const BoxLattice& lattice,
                           const LatticeNumbering& numbering)
    : ranks_(n_ranks() > 1 ? &mpi_group() : nullptr),
      multigrid_(lattice, ranks_),
      exchange_(system, lattice, multigrid_.slab(), ranks_, numbering) {
  take_pins(numbering);
  find_modes();
}

/// Takes the pins of all ranks, each once.
void LatticeBlock::take_pins(const LatticeNumbering& numbering) {
  std::vector<LatticeNumbering::Pin> pins = numbering.pins;
  if (ranks_ != nullptr)
    pins = ValueExchange(*ranks_, pins.size())
               .sent(std::span<const LatticeNumbering::Pin>(pins));
  const SlabPlaces places(multigrid_.lattice(), multigrid_.slab());
  for (const LatticeNumbering::Pin& pin : pins)
    if (std::ranges::none_of(
            pins_, [&](const Pin& own) { return own.node == pin.node; }))
      pins_.push_back({pin.node, places.of(pin.node), pin.component});
}

void LatticeBlock::vmult(Vector& to, const Vector& from) const {
  exchange_.to_lattice(from, from_);
  multigrid_.apply(from_, to_);
  exchange_.from_lattice(to_, to);
}

/// Separates the pins that prevent a rigid motion from those that are held.
void LatticeBlock::find_modes() {
  loose_.clear();
  held_pins_.clear();
  for (const Pin& pin : pins_)
    if (pin.component != 2 || !has_contact_)
      loose_.push_back(pin);
    else if (pin.place != SlabPlaces::nowhere)
      held_pins_.push_back(pin.place);
  modes_ = rigid_modes(multigrid_.lattice(), multigrid_.slab(), has_contact_);
  if (modes_.size() != loose_.size())
    throw std::logic_error("the pins of a lattice do not match its motions");
  at_loose_.clear();
  for (const auto& mode : modes_)
    for (const Pin& pin : loose_)
      at_loose_.push_back(multigrid_.slab().sum(
          pin.place != SlabPlaces::nowhere ? mode[pin.place] : 0.0));
}

void LatticeBlock::prepare(std::span<const double> springs,
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
LatticeBlock::at_pins(const std::vector<double>& right_sides,
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
void LatticeBlock::balance_forces() {
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
void LatticeBlock::remove_motions() {
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

LinearSolution LatticeBlock::solve(Vector& unknowns, const Vector& forces,
                                   double tolerance, int most_iterations) {
  exchange_.to_lattice(forces, to_);
  exchange_.to_lattice(unknowns, from_);
  if (!modes_.empty())
    balance_forces();
  multigrid_.force() = to_;
  const LinearSolution solution =
      multigrid_.solve(from_, tolerance, most_iterations);
  if (!modes_.empty())
    remove_motions();
  exchange_.from_lattice(from_, unknowns);
  return solution;
}

std::string LatticeBlock::name() const {
  return "CG, multigrid on the lattice (" + std::to_string(levels()) +
         " levels)";
}

std::size_t LatticeBlock::bytes() const {
  std::size_t numbers = from_.size() + to_.size();
  for (const auto& mode : modes_)
    numbers += mode.size();
  return multigrid_.bytes() + exchange_.bytes() + sizeof(double) * numbers;
}

} // namespace asperity::fem
