#include "fem/linear/solver_choice.hpp"

#include "fem/parallel/ranks.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace asperity::fem {

Choice choice_of(const SolverNeeds& needs, LinearSolver requested,
                 unsigned int unknowns) {
  const bool is_requested = requested == needs.kind;
  if (!is_requested && requested != LinearSolver::automatic)
    return Choice::other_requested;
  if (!is_requested && unknowns < needs.fewest_unknowns)
    return Choice::small_block;
  if (!needs.fits_mesh())
    return Choice::unsuitable_mesh;
  const bool needs_moduli =
      needs.fits_moduli && !(is_requested && needs.ignores_moduli_if_requested);
  if (needs_moduli && !needs.fits_moduli())
    return Choice::nearly_incompressible;
  return is_requested ? Choice::requested : Choice::preferred;
}

bool has_mumps() {
  return n_ranks() == 1;
}

bool is_small(const BlockSystem& system) {
  const auto n_unknowns = system.n_unknowns();
  const auto most_stiff = has_mumps() ? most_direct_stiff_unknowns
                                      : most_direct_stiff_unknowns_on_ranks;
  return n_unknowns <= most_direct_unknowns ||
         (n_unknowns <= most_stiff && !is_compressible(system));
}

bool is_compressible(const BlockSystem& system) {
  double largest = 0.0;
  for (const auto& cell :
       system.space().dof_handler().active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const Moduli own = system.moduli_of(cell);
    largest = std::max(largest, own.lame_modulus / own.shear_modulus);
  }
  return dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD) <=
         largest_lame_ratio;
}

} // namespace asperity::fem
