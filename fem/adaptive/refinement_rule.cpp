#include "fem/adaptive/refinement_rule.hpp"

#include "fem/block/block_triangulation.hpp"
#include "fem/solution/stress_indicator.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace asperity::fem {
namespace {

/// Indicator over that of cells in contact, above which a cell refines and
/// below which it merges. Halving a second-order cell divides the indicator by
/// some 2^(2 + 3/2) = 11 where the stress is smooth.
constexpr double refine_above = 2.0;
constexpr double merge_below = 0.05;

/// Share of the mean contact pressure that heights between the nodes of a cell
/// may change.
constexpr double pressure_share = 0.05;

/// E* over the shear modulus, 2 / (1 - nu) at nu = 1/3.
constexpr double modulus_ratio = 3.0;

SurfaceFields fields_of(const BlockProblem& problem, const BlockSystem& system,
                        const FoundContact& found, double contact_pressure) {
  return {problem.grid,
          problem.degree,
          found.pressure,
          found.gap,
          modulus_ratio * system.face_shear_modulus(),
          pressure_share * contact_pressure,
          found.gap_tolerance};
}

/// Gives every rank the marks of all.
void unite_ranks(ContactMarks& marks) {
  std::vector<int> numbers(marks.marks().begin(), marks.marks().end());
  dealii::Utilities::MPI::max(numbers, MPI_COMM_WORLD, numbers);
  std::ranges::transform(numbers, marks.marks().begin(),
                         [](int number) { return static_cast<char>(number); });
}

/// The range with a margin of its own width on all sides, which contains the
/// parent of the cell.
CellRange around(const CellRange& range) {
  const int width_x = range.last_x - range.first_x;
  const int width_y = range.last_y - range.first_y;
  return {range.first_x - width_x, range.last_x + width_x,
          range.first_y - width_y, range.last_y + width_y};
}

} // namespace

RefinementRule::RefinementRule(const BlockProblem& problem,
                               const MeshedBlock& block,
                               const FoundContact& found,
                               double contact_pressure)
    : system_(block.system()),
      finest_level_(problem.adaptive->halvings),
      marks_(fields_of(problem, system_, found, contact_pressure)),
      materials_(problem),
      indicator_(stress_indicator(system_, block.newton().state().displacement,
                                  problem.adaptive->moduli_ratio)) {
  for (const auto& cell :
       system_.space().triangulation().active_cell_iterators())
    if (cell->is_locally_owned())
      if (const auto face = contact_face(cell))
        marks_.examine(*face);
  unite_ranks(marks_);
  find_reference();
}

/// The finest cells on the contact surface that the face of a cell covers.
std::optional<CellRange> RefinementRule::contact_face(const Cell& cell) const {
  for (const auto& face : cell->face_iterators()) {
    if (!face->at_boundary() ||
        face->boundary_id() != boundary_of(meshes::FaceGroup::contact))
      continue;
    const dealii::BoundingBox<3> box = face->bounding_box();
    const auto count = [&](double place, double spacing) {
      return static_cast<int>(std::lround(place / spacing));
    };
    const Grid& cells = marks_.cells();
    return CellRange{count(box.lower_bound(0), cells.spacing_x()),
                     count(box.upper_bound(0), cells.spacing_x()),
                     count(box.lower_bound(1), cells.spacing_y()),
                     count(box.upper_bound(1), cells.spacing_y())};
  }
  return {};
}

void RefinementRule::find_reference() {
  double squares = 0.0;
  double cells = 0.0;
  for (const auto& cell :
       system_.space().triangulation().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const auto face = contact_face(cell);
    if (!face || !marks_.is_touched(*face))
      continue;
    squares += std::pow(indicator_[cell->active_cell_index()], 2);
    cells += 1.0;
  }
  squares = dealii::Utilities::MPI::sum(squares, MPI_COMM_WORLD);
  cells = dealii::Utilities::MPI::sum(cells, MPI_COMM_WORLD);
  reference_ = cells > 0.0 ? std::sqrt(squares / cells) : 0.0;
}

CellChange RefinementRule::change_of(const Cell& cell, bool may_coarsen) const {
  const auto face = contact_face(cell);
  const double indicator = indicator_[cell->active_cell_index()];
  const bool is_marked = face && marks_.is_marked_near(*face);
  if (cell->level() < finest_level_ &&
      (is_marked || indicator > refine_above * reference_ ||
       materials_.is_too_coarse(cell)))
    return CellChange::refine;
  const bool is_far = !face || !marks_.is_touched(around(*face));
  return may_coarsen && cell->level() > 0 && !is_marked && is_far &&
                 indicator <= merge_below * reference_ &&
                 !materials_.is_too_coarse(cell->parent())
             ? CellChange::coarsen
             : CellChange::none;
}

std::vector<CellChange> RefinementRule::changes(bool may_coarsen) const {
  std::vector<CellChange> changes;
  for (const auto& cell :
       system_.space().triangulation().active_cell_iterators())
    changes.push_back(cell->is_locally_owned() ? change_of(cell, may_coarsen)
                                               : CellChange::none);
  return changes;
}

} // namespace asperity::fem
