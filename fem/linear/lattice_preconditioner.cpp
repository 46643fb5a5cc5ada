#include "fem/linear/lattice_preconditioner.hpp"

#include "fem/linear/lattice_exchange.hpp"
#include "fem/parallel/mpi_group.hpp"
#include "fem/parallel/ranks.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace asperity::fem {
namespace {

using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr std::size_t nowhere = UnknownExchange::nowhere;

/// Relative residual of the surface problem in each solve. It is far below the
/// tolerance of CG, so that the preconditioner is a fixed linear operator.
constexpr double face_tolerance = 1e-11;

} // namespace

LatticePreconditioner::LatticePreconditioner(const BlockSystem& system,
                                             const BoxLattice& lattice,
                                             const LayeredBlock& uniform)
    : system_(system),
      solver_(system.grid(), lattice.degree, uniform, 1, Among::all_ranks) {
  number_unknowns(lattice);
  lattice_values_.resize(solver_.lattice().size());
}

/// Numbers the unknowns and the pins on the node grid, and sends each unknown
/// to the rank that solves for its field.
void LatticePreconditioner::number_unknowns(const BoxLattice& lattice) {
  const LatticeNumbering numbering(system_, lattice);
  const NodeLayout layout(lattice);
  const NodeLattice& nodes = solver_.lattice();
  const auto number_of = [&](std::size_t index) {
    const NodeLayout::Node node = layout.node(index);
    return nodes.index(static_cast<std::size_t>(node.plane),
                       static_cast<std::size_t>(node.component),
                       nodes.grid.index(node.x, node.y));
  };
  for (const std::size_t index : numbering.nodes)
    own_numbers_.push_back(index == nowhere ? nowhere : number_of(index));
  std::array<std::uint64_t, 3> pins{}; // number plus one; 0: none
  for (const LatticeNumbering::Pin& pin : numbering.pins)
    pins.at(pin.component) = number_of(pin.node) + 1;
  for (std::size_t c = 0; c < 3; ++c)
    if (const std::uint64_t pin =
            dealii::Utilities::MPI::max(pins[c], MPI_COMM_WORLD);
        pin > 0)
      pins_[c] = pin - 1;
  const std::size_t field = nodes.grid.size();
  unknowns_.emplace(
      n_ranks() > 1 ? &mpi_group() : nullptr, own_numbers_,
      [&](std::size_t number) {
        return static_cast<int>(solver_.share().owner_of(number / field));
      },
      [](std::size_t number) { return number; });
}

void LatticePreconditioner::prepare(std::span<const double> springs,
                                    const std::vector<bool>& held) {
  const Grid& grid = system_.grid();
  const dealii::IndexSet& owned = system_.space().owned();
  std::vector<double> at_nodes(grid.size(), 0.0);
  const std::size_t first = solver_.lattice().index(0, 2, 0);
  for (std::size_t i = 0; i < springs.size(); ++i) {
    if (springs[i] == 0.0 && !held[i])
      continue;
    const ContactPoint& point = system_.contact()[i];
    for (const auto& [unknown, value] : point.row) {
      const std::size_t node =
          owned.is_element(unknown)
              ? own_numbers_[owned.index_within_set(unknown)] - first
              : grid.size();
      if (node < grid.size())
        at_nodes[node] += held[i] ? std::numeric_limits<double>::infinity()
                                  : value * springs[i];
    }
  }
  dealii::Utilities::MPI::sum(at_nodes, MPI_COMM_WORLD, at_nodes);
  for (double& spring : at_nodes)
    spring = std::max(spring, 0.0); // quadratic shape functions may be negative
  has_springs_ = std::ranges::any_of(at_nodes, [](double s) { return s > 0; });
  solver_.set_springs(at_nodes);
  has_converged_ = true;
}

/// Calls do_pin(fields, node) for each component that only a pin constrains,
/// with the fields of the component on this rank and the index of the pin among
/// all values. If there are springs, they constrain u_z themselves.
template <class DoPin>
void LatticePreconditioner::each_pin(const DoPin& do_pin) {
  const Range own = solver_.share().fields();
  const std::size_t nodes = solver_.lattice().grid.size();
  for (std::size_t c = 0; c < (has_springs_ ? 2U : 3U); ++c) {
    if (!pins_[c])
      continue;
    std::vector<std::span<double>> fields;
    for (std::size_t field = own.begin; field < own.end; ++field)
      if (field % 3 == c)
        fields.push_back(
            std::span(lattice_values_).subspan(field * nodes, nodes));
    do_pin(fields, *pins_[c]);
  }
}

/// Subtracts the sum of the forces of each component at its pin.
void LatticePreconditioner::balance() {
  each_pin([&](const auto& fields, std::size_t pin) {
    double sum = 0.0;
    for (const std::span<double> field : fields)
      sum = std::accumulate(field.begin(), field.end(), sum);
    solver_.share().add_up({&sum, 1});
    lattice_values_[pin] -= sum;
  });
}

/// Subtracts the shift of each component so that its pin does not move.
void LatticePreconditioner::rest() {
  const std::size_t nodes = solver_.lattice().grid.size();
  each_pin([&](const auto& fields, std::size_t pin) {
    double shift = solver_.share().fields().contains(pin / nodes)
                       ? lattice_values_[pin]
                       : 0.0;
    solver_.share().add_up({&shift, 1});
    for (const std::span<double> field : fields)
      for (double& value : field)
        value -= shift;
  });
}

void LatticePreconditioner::vmult(Vector& to, const Vector& from) {
  unknowns_->send(from, lattice_values_);
  balance();
  // The residual in CG is correct whatever this operator does, so a surface
  // problem that did not converge costs only iterations. It is reported if CG
  // then fails to converge.
  if (has_springs_)
    has_converged_ = solver_
                         .solve_with_springs(lattice_values_, lattice_values_,
                                             face_tolerance)
                         .converged &&
                     has_converged_;
  else
    solver_.solve(lattice_values_, lattice_values_);
  rest();
  unknowns_->give_back(lattice_values_, to);
}

std::string LatticePreconditioner::failure() const {
  return has_converged_ ? ""
                        : "the surface problem of the Fourier preconditioner "
                          "did not converge";
}

std::string LatticePreconditioner::name() const {
  return "Fourier solver of the laterally uniform block";
}

} // namespace asperity::fem
