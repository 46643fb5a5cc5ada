// Contact curves of small blocks of every kind, printed by the first rank: what
// ranks_test.py runs once alone and once under mpirun.
#include "fem/mpi_session.hpp"
#include "meshes/hanging_mesh.hpp"

#include <cstdio>
#include <cstdlib>

#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

namespace {

using namespace asperity;
using namespace asperity::fem;

const cases::BodyModuli body{soft_modulus, 0.3};

bool is_first() {
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  return rank == nullptr || std::atoi(rank) == 0;
}

void print_curve(const char* name, const BlockProblem& problem,
                 cases::ContactLaw law) {
  std::vector<double> heights = random_field(problem.grid.size(), 3);
  for (double& height : heights)
    height *= 4e-9;
  const auto block = make_full_block(problem);
  for (const double load : {1e6, 8e6}) {
    const BlockSolution found =
        block->solve(heights, {cases::Control::nominal_pressure, load},
                     {law, 300.0 * soft_modulus / 1e-6, 1e-10, 400});
    if (is_first())
      std::printf("%s %d %.16e %.16e %.16e %.16e\n", name, found.converged,
                  found.nominal_pressure, found.mean_gap, found.area_by_points,
                  largest_magnitude(found.pressure));
  }
  const std::string report = block->report(); // of all ranks
  if (is_first())
    std::printf("# %s", report.c_str());
}

} // namespace

int main() {
  start_mpi();
  const Grid grid{8, 8, 1e-6, 1e-6};
  const BlockProblem boxes = boxes_problem(grid, 1, body, 1e-6);
  print_curve("direct", boxes, cases::ContactLaw::penalty);
  BlockProblem problem = boxes;
  problem.linear_solver = LinearSolver::multigrid;
  print_curve("multigrid", problem, cases::ContactLaw::penalty);
  print_curve("wall", problem, cases::ContactLaw::hard);
  problem.top = cases::TopFace::pressure;
  problem.contact_at = cases::ContactPoints::gauss;
  problem.moduli.set_factor(random_factor(0.5, 1, grid.spacing_x()));
  print_curve("gauss", problem, cases::ContactLaw::augmented);
  problem = boxes;
  problem.counter = cases::BodyModuli{2.0 * soft_modulus, 0.2};
  print_curve("counter", problem, cases::ContactLaw::penalty);
  problem = boxes_problem(grid, 2, body, 1e-6);
  problem.sides = cases::BlockSides::free;
  problem.top = cases::TopFace::sliding;
  print_curve("free", problem, cases::ContactLaw::penalty);
  problem = boxes;
  problem.mesh = tetrahedra_of(problem.mesh);
  print_curve("tetrahedra", problem, cases::ContactLaw::penalty);
  problem = boxes_problem({16, 16, 1e-6, 1e-6}, 1, body, 1e-6);
  problem.mesh = meshes::hanging_mesh(problem.grid, 1e-6, 4);
  print_curve("hanging", problem, cases::ContactLaw::penalty);
}
