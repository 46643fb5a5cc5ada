#include "fem/linear/lattice_preconditioner.hpp"

#include "base/require.hpp"
#include "fem/parallel/ranks.hpp"

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace asperity::fem {
namespace {

using dealii::Point;
using dealii::types::global_dof_index;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

/// Relative residual of the surface problem in each solve. It is far below the
/// tolerance of CG, so that the preconditioner is a fixed linear operator.
constexpr double face_tolerance = 1e-11;

std::vector<double> planes_of(const LayeredBlock& block, int degree) {
  std::vector<double> depths{0.0};
  for (const ElasticLayer& layer : block.layers) {
    const double below = depths.back();
    for (int k = 1; k <= degree; ++k)
      depths.push_back(below + layer.thickness * k / degree);
  }
  return depths;
}

std::vector<bool> held_components(mechanics::FarBoundary far_boundary) {
  switch (far_boundary) {
  case mechanics::FarBoundary::clamped:
    return {true, true, true};
  case mechanics::FarBoundary::sliding:
    return {false, false, true};
  case mechanics::FarBoundary::pressure:
    break;
  }
  return {false, false, false};
}

template <class Mail>
void deliver(const Mail& from, Mail& to) {
  MPI_Alltoallv(from.values.data(), from.counts.data(), from.starts.data(),
                MPI_DOUBLE, to.values.data(), to.counts.data(),
                to.starts.data(), MPI_DOUBLE, MPI_COMM_WORLD);
}

} // namespace

LatticePreconditioner::LatticePreconditioner(const BlockSystem& system,
                                             int degree,
                                             const LayeredBlock& uniform)
    : system_(system),
      solver_(system.grid(), degree, uniform, 1, Among::all_ranks),
      plane_depths_(planes_of(uniform, degree)) {
  number_unknowns(uniform);
  agree_on_numbers();
  lattice_values_.resize(solver_.lattice().size());
}

std::size_t LatticePreconditioner::lattice_index(const Point<3>& place,
                                                 std::size_t component) const {
  const Grid& grid = system_.grid();
  const double tolerance = system_.space().coordinate_tolerance();
  const auto plane = std::lower_bound(
      plane_depths_.begin(), plane_depths_.end(), place[2] - tolerance);
  if (plane == plane_depths_.end() || *plane > place[2] + tolerance)
    refuse_argument("depth of a node", place[2], "a plane of the node grid");
  const auto round = [](double steps, int points) {
    return static_cast<int>(std::lround(steps)) % points;
  };
  return solver_.lattice().index(
      static_cast<std::size_t>(plane - plane_depths_.begin()), component,
      grid.index(round(place[0] / grid.spacing_x(), grid.points_x),
                 round(place[1] / grid.spacing_y(), grid.points_y)));
}

/// Numbers the unknowns on the node grid. Constrained unknowns are set to
/// nowhere; those that only a pin constrains are recorded.
void LatticePreconditioner::number_unknowns(const LayeredBlock& uniform) {
  const BlockSpace& space = system_.space();
  std::map<global_dof_index, Point<3>> places;
  dealii::DoFTools::map_dofs_to_support_points(space.mapping(),
                                               space.dof_handler(), places);
  std::array<dealii::IndexSet, 3> of_component;
  for (unsigned int c = 0; c < 3; ++c) {
    dealii::ComponentMask mask(3, false);
    mask.set(c, true);
    of_component[c] = dealii::DoFTools::extract_dofs(space.dof_handler(), mask);
  }
  const std::vector<bool> held = held_components(uniform.far_boundary);
  std::array<std::uint64_t, 3> pins{}; // index plus one; 0: none
  own_numbers_.assign(space.owned().n_elements(), nowhere);
  for (const global_dof_index unknown : space.owned()) {
    const std::size_t component = of_component[0].is_element(unknown)   ? 0
                                  : of_component[1].is_element(unknown) ? 1
                                                                        : 2;
    const std::size_t number = lattice_index(places.at(unknown), component);
    const auto& constraints = space.constraints();
    if (!constraints.is_constrained(unknown))
      own_numbers_[space.owned().index_within_set(unknown)] = number;
    else if (!held[component] &&
             constraints.get_constraint_entries(unknown)->empty())
      pins[component] = number + 1;
  }
  for (std::size_t c = 0; c < 3; ++c)
    if (const std::uint64_t pin =
            dealii::Utilities::MPI::max(pins[c], MPI_COMM_WORLD);
        pin > 0)
      pins_[c] = pin - 1;
}

/// Determines which of the own unknowns go to which rank, and which nodes come
/// from it.
void LatticePreconditioner::agree_on_numbers() {
  const std::size_t nodes = solver_.lattice().grid.size();
  std::vector<std::vector<std::size_t>> numbers(solver_.share().n_ranks());
  std::vector<std::vector<std::size_t>> unknowns(numbers.size());
  for (std::size_t i = 0; i < own_numbers_.size(); ++i)
    if (own_numbers_[i] != nowhere) {
      const std::size_t to = solver_.share().owner_of(own_numbers_[i] / nodes);
      numbers[to].push_back(own_numbers_[i]);
      unknowns[to].push_back(i);
    }
  std::map<unsigned int, std::vector<std::size_t>> to_ranks;
  for (std::size_t rank = 0; rank < numbers.size(); ++rank)
    to_ranks[static_cast<unsigned int>(rank)] = std::move(numbers[rank]);
  auto from_ranks =
      dealii::Utilities::MPI::some_to_some(MPI_COMM_WORLD, to_ranks);
  const auto add = [](Mail& mail, const std::vector<std::size_t>& at) {
    constexpr const char* what = "unknowns that a rank exchanges";
    mail.starts.push_back(mpi_count(mail.at.size(), what));
    mail.counts.push_back(mpi_count(at.size(), what));
    mail.at.insert(mail.at.end(), at.begin(), at.end());
    mail.values.resize(mail.at.size());
  };
  for (std::size_t rank = 0; rank < unknowns.size(); ++rank) {
    add(unknowns_, unknowns[rank]);
    add(lattice_, from_ranks[static_cast<unsigned int>(rank)]);
  }
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

void LatticePreconditioner::send(const Vector& from) {
  for (std::size_t i = 0; i < unknowns_.at.size(); ++i)
    unknowns_.values[i] = *(from.begin() + unknowns_.at[i]);
  deliver(unknowns_, lattice_);
  std::fill(lattice_values_.begin(), lattice_values_.end(), 0.0);
  for (std::size_t i = 0; i < lattice_.at.size(); ++i)
    lattice_values_[lattice_.at[i]] = lattice_.values[i];
}

void LatticePreconditioner::send_back(Vector& to) {
  for (std::size_t i = 0; i < lattice_.at.size(); ++i)
    lattice_.values[i] = lattice_values_[lattice_.at[i]];
  deliver(lattice_, unknowns_);
  std::fill(to.begin(), to.end(), 0.0);
  for (std::size_t i = 0; i < unknowns_.at.size(); ++i)
    *(to.begin() + unknowns_.at[i]) = unknowns_.values[i];
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
  send(from);
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
  send_back(to);
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
