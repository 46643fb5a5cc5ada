#include "fem/linear/lattice_preconditioner.hpp"

#include "base/require.hpp"
#include "fem/parallel/mpi_group.hpp"
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

constexpr std::size_t nowhere = UnknownExchange::nowhere;

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

} // namespace

LatticePreconditioner::LatticePreconditioner(const BlockSystem& system,
                                             int degree,
                                             const LayeredBlock& uniform)
    : system_(system),
      solver_(system.grid(), degree, uniform, 1, Among::all_ranks),
      plane_depths_(planes_of(uniform, degree)) {
  number_unknowns(uniform);
  distribute_unknowns();
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

/// Sends each unknown to the rank that solves for its field.
void LatticePreconditioner::distribute_unknowns() {
  const std::size_t nodes = solver_.lattice().grid.size();
  unknowns_.emplace(
      n_ranks() > 1 ? &mpi_group() : nullptr, own_numbers_,
      [&](std::size_t number) {
        return static_cast<int>(solver_.share().owner_of(number / nodes));
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
