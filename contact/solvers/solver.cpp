#include "contact/solvers/solver.hpp"

#include "contact/solvers/iteration.hpp"
#include "contact/solvers/tile_start.hpp"

#include <utility>

// A tour: load_sequence.hpp and coarse_start.cpp choose what pressure a
// solution starts from. tile_start.hpp finds that of a light contact on the
// tiles that have some, and iteration.cpp is the iteration on all nodes.

namespace asperity::contact {

ContactSolution solve_contact(SurfaceOperator& elasticity,
                              const ContactProblem& problem,
                              const mechanics::LoadTarget& target,
                              std::span<const double> initial_pressure) {
  return solve_contact_from({initial_pressure.begin(), initial_pressure.end()},
                            elasticity, problem, target);
}

ContactSolution solve_contact_from(std::vector<double> initial_pressure,
                                   SurfaceOperator& elasticity,
                                   const ContactProblem& problem,
                                   const mechanics::LoadTarget& target,
                                   const OtherGuess& other) {
  ContactState state(elasticity, problem, target, std::move(initial_pressure));
  state.update_residual();
  if (other.make && state.gap_error > other.above)
    if (std::vector<double> guess = other.make(); !guess.empty()) {
      state.set_pressure(std::move(guess));
      state.update_residual();
    }
  approach_on_tiles(state);
  return iterated(std::move(state));
}

} // namespace asperity::contact
