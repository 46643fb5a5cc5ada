#include "fem/adaptive/material_marks.hpp"

#include "base/require.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace asperity::fem {
namespace {

/// Largest edge of a mixed cell over its depth and over the radius of the
/// inclusion.
constexpr double edge_per_depth = 0.25;
constexpr double edge_per_radius = 0.25;

/// Bounds of the number of samples of the factor per direction.
constexpr double fewest_samples = 4.0;
constexpr double most_samples = 32.0;

double longest_edge(const dealii::BoundingBox<3>& box) {
  return std::max({box.side_length(0), box.side_length(1), box.side_length(2)});
}

/// The number of Gauss points of which no two neighbours in a length are
/// farther apart than a feature: their distance is at most pi/2 lengths over
/// their number.
unsigned int n_samples(double length, double feature) {
  const double needed = feature > 0.0 ? std::ceil(1.6 * length / feature) : 0.0;
  return static_cast<unsigned int>(
      std::clamp(needed, fewest_samples, most_samples));
}

} // namespace

MaterialMarks::MaterialMarks(const BlockProblem& problem)
    : field_(problem.moduli),
      settings_(*problem.adaptive),
      interfaces_(field_.interfaces()),
      tolerance_(1e-9 * problem.mesh.depth) {
  require_between("moduli_ratio", settings_.moduli_ratio, 1.0, 1e6, "1");
  if (settings_.interface_halvings)
    require_between("interface_halvings", *settings_.interface_halvings, 0,
                    settings_.halvings, "1");
}

bool MaterialMarks::is_too_coarse(const Cell& cell) const {
  const int level = cell->level();
  if (level >= settings_.halvings)
    return false;
  const Box box = cell->bounding_box();
  if (is_crossed_by_interface(box))
    return true;
  return !is_allowed(box, level) &&
         (is_crossed_by_sphere(box) || has_different_factors(box));
}

/// Whether a cell of this size may hold several materials at its place.
bool MaterialMarks::is_allowed(const Box& box, int level) const {
  if (settings_.interface_halvings)
    return level >= *settings_.interface_halvings;
  double longest = edge_per_depth * box.lower_bound(2);
  if (field_.sphere() && is_crossed_by_sphere(box))
    longest = std::min(longest, edge_per_radius * field_.sphere()->radius);
  return longest_edge(box) <= longest;
}

bool MaterialMarks::is_crossed_by_interface(const Box& box) const {
  return std::ranges::any_of(interfaces_, [&](double depth) {
    return box.lower_bound(2) + tolerance_ < depth &&
           depth < box.upper_bound(2) - tolerance_;
  });
}

bool MaterialMarks::is_crossed_by_sphere(const Box& box) const {
  const auto& sphere = field_.sphere();
  if (!sphere)
    return false;
  double nearest = 0.0; // squared distances from the centre
  double farthest = 0.0;
  for (unsigned int axis = 0; axis < 3; ++axis) {
    const double centre = sphere->centre.at(axis);
    const double below = box.lower_bound(axis) - centre;
    const double above = box.upper_bound(axis) - centre;
    nearest += std::pow(std::max({below, -above, 0.0}), 2);
    farthest += std::pow(std::max(-below, above), 2);
  }
  const double square = sphere->radius * sphere->radius;
  return nearest < square && square < farthest;
}

bool MaterialMarks::has_different_factors(const Box& box) const {
  if (!field_.has_factor())
    return false;
  const dealii::QGauss<3> samples(
      n_samples(longest_edge(box), field_.feature()));
  const dealii::Point<3> centre = box.center();
  double least = field_.factor({centre[0], centre[1], centre[2]});
  double largest = least;
  for (const dealii::Point<3>& unit : samples.get_points()) {
    const dealii::Point<3> place = box.unit_to_real(unit);
    const double factor = field_.factor({place[0], place[1], place[2]});
    least = std::min(least, factor);
    largest = std::max(largest, factor);
    if (largest > settings_.moduli_ratio * least)
      return true;
  }
  return false;
}

void refine_for_materials(const BlockProblem& problem, MeshChange::Mesh& mesh) {
  const MaterialMarks marks(problem);
  for (int pass = 0; pass < problem.adaptive->halvings; ++pass) {
    std::vector<CellChange> changes(mesh.n_active_cells(), CellChange::none);
    unsigned int n_marked = 0;
    for (const auto& cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned() && marks.is_too_coarse(cell)) {
        changes[cell->active_cell_index()] = CellChange::refine;
        ++n_marked;
      }
    if (dealii::Utilities::MPI::sum(n_marked, MPI_COMM_WORLD) == 0)
      return;
    const MeshChange change(problem, mesh, changes);
    mesh.execute_coarsening_and_refinement();
  }
}

} // namespace asperity::fem
