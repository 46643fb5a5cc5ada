#include "fem/lattice_preconditioner.hpp"

#include "base/require.hpp"

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace asperity::fem {
namespace {

using dealii::Point;
using dealii::types::global_dof_index;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

/// Left of the surface problem of each solve: far below what CG asks of a
/// residual it started from, so that the preconditioner is one linear operator.
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

std::vector<bool> held_components(cases::TopFace top) {
  switch (top) {
  case cases::TopFace::clamped:
    return {true, true, true};
  case cases::TopFace::sliding:
    return {false, false, true};
  case cases::TopFace::pressure:
    break;
  }
  return {false, false, false};
}

} // namespace

LatticePreconditioner::LatticePreconditioner(const BlockSystem& system,
                                             int degree,
                                             const LayeredBlock& uniform)
    : system_(system),
      solver_(system.grid(), degree, uniform),
      plane_depths_(planes_of(uniform, degree)) {
  number_unknowns(uniform);
  share_numbers();
  lattice_values_.resize(solver_.lattice().size());
  own_values_.resize(own_numbers_.size());
  all_values_.resize(all_numbers_.size());
}

std::size_t LatticePreconditioner::lattice_index(const Point<3>& place,
                                                 std::size_t component) const {
  const Grid& grid = system_.grid();
  const double tolerance = system_.space().coordinate_tolerance();
  const auto plane = std::lower_bound(
      plane_depths_.begin(), plane_depths_.end(), place[2] - tolerance);
  if (plane == plane_depths_.end() || *plane > place[2] + tolerance)
    refuse_argument("depth of a node", place[2], "a plane of the lattice");
  const auto round = [](double steps, int points) {
    return static_cast<int>(std::lround(steps)) % points;
  };
  return solver_.lattice().index(
      static_cast<std::size_t>(plane - plane_depths_.begin()), component,
      grid.index(round(place[0] / grid.spacing_x(), grid.points_x),
                 round(place[1] / grid.spacing_y(), grid.points_y)));
}

/// Constrained unknowns are nowhere; those that nothing but a pin constrains
/// are remembered.
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
  const std::vector<bool> held = held_components(uniform.top);
  std::array<std::uint64_t, 3> pins{}; // one more than the index; 0: none
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

void LatticePreconditioner::share_numbers() {
  const auto of_ranks =
      dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, own_numbers_);
  for (const std::vector<std::size_t>& numbers : of_ranks) {
    starts_.push_back(static_cast<int>(all_numbers_.size()));
    counts_.push_back(static_cast<int>(numbers.size()));
    all_numbers_.insert(all_numbers_.end(), numbers.begin(), numbers.end());
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
    spring = std::max(spring, 0.0); // quadratic shape values may be negative
  has_springs_ = std::ranges::any_of(at_nodes, [](double s) { return s > 0; });
  solver_.set_springs(at_nodes);
}

void LatticePreconditioner::gather(const Vector& from) {
  std::copy(from.begin(), from.end(), own_values_.begin());
  MPI_Allgatherv(own_values_.data(), static_cast<int>(own_values_.size()),
                 MPI_DOUBLE, all_values_.data(), counts_.data(), starts_.data(),
                 MPI_DOUBLE, MPI_COMM_WORLD);
  std::fill(lattice_values_.begin(), lattice_values_.end(), 0.0);
  for (std::size_t i = 0; i < all_numbers_.size(); ++i)
    if (all_numbers_[i] != nowhere)
      lattice_values_[all_numbers_[i]] = all_values_[i];
}

/// The pin bears what the forces of its component sum up to.
void LatticePreconditioner::balance() {
  const NodeLattice& lattice = solver_.lattice();
  const std::size_t nodes = lattice.grid.size();
  for (std::size_t c = 0; c < (has_springs_ ? 2U : 3U); ++c) {
    if (!pins_[c])
      continue;
    double sum = 0.0;
    for (std::size_t plane = 0; plane < lattice.planes; ++plane)
      for (std::size_t node = 0; node < nodes; ++node)
        sum += lattice_values_[lattice.index(plane, c, node)];
    lattice_values_[*pins_[c]] -= sum;
  }
}

/// The shift that leaves the pin where it is.
void LatticePreconditioner::rest() {
  const NodeLattice& lattice = solver_.lattice();
  for (std::size_t c = 0; c < (has_springs_ ? 2U : 3U); ++c) {
    if (!pins_[c])
      continue;
    const double shift = lattice_values_[*pins_[c]];
    for (std::size_t plane = 0; plane < lattice.planes; ++plane)
      for (std::size_t node = 0; node < lattice.grid.size(); ++node)
        lattice_values_[lattice.index(plane, c, node)] -= shift;
  }
}

void LatticePreconditioner::vmult(Vector& to, const Vector& from) {
  gather(from);
  balance();
  if (has_springs_)
    static_cast<void>(solver_.solve_with_springs(
        lattice_values_, lattice_values_, face_tolerance));
  else
    solver_.solve(lattice_values_, lattice_values_);
  rest();
  auto value = to.begin();
  for (const std::size_t number : own_numbers_)
    *value++ = number == nowhere ? 0.0 : lattice_values_[number];
}

std::string LatticePreconditioner::name() const {
  return "the condensed block (Fourier)";
}

} // namespace asperity::fem
