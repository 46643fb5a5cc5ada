// Contact curves of small blocks of every type, printed by the first rank:
// ranks_test.py runs this program alone and under mpirun. With the argument
// "grid of boxes", only those whose ranks share the rows of a grid of boxes.
#include "fem/adaptive/adaptive_block.hpp"
#include "fem/material/j2_plasticity.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/counter_body.hpp"
#include "meshes/hanging_mesh.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace asperity;
using namespace asperity::fem;

const mechanics::BodyModuli body{soft_modulus, 0.3};
const Grid grid{8, 8, 1e-6, 1e-6};

bool is_first() {
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  return rank == nullptr || std::atoi(rank) == 0;
}

void print_curve(const char* name, const BlockProblem& problem,
                 mechanics::ContactLaw law) {
  std::vector<double> heights = random_field(problem.grid.size(), 3);
  for (double& height : heights)
    height *= 4e-9;
  const auto block = make_full_block(problem);
  for (const double load : {1e6, 8e6}) {
    const BlockSolution found =
        block->solve(heights, {mechanics::Control::nominal_pressure, load},
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

/// A block on a column with a mesh of its own, which overlaps no face of the
/// block exactly.
BlockProblem on_column(int degree) {
  BlockProblem problem = boxes_problem(grid, degree, body, 1e-6);
  problem.counter = mechanics::BodyModuli{2.0 * soft_modulus, 0.2};
  problem.counter_mesh =
      meshes::counter_body({.shape = mechanics::CounterShape::cylinder,
                            .radius = 0.35e-6,
                            .height = 0.5e-6,
                            .size_at_contact = degree * grid.spacing_x(),
                            .size_far = 0.3e-6,
                            .fine_radius = 0.35e-6,
                            .centre_x = 0.5e-6,
                            .centre_y = 0.52e-6});
  return problem;
}

void print_meshes() {
  const BlockProblem boxes = boxes_problem(grid, 1, body, 1e-6);
  BlockProblem problem = boxes;
  problem.linear_solver = LinearSolver::direct;
  print_curve("direct", problem, mechanics::ContactLaw::penalty);
  problem.linear_solver = LinearSolver::multigrid;
  print_curve("multigrid", problem, mechanics::ContactLaw::penalty);
  print_curve("hard", problem, mechanics::ContactLaw::hard);
  problem.far_boundary = mechanics::FarBoundary::pressure;
  problem.moduli.set_factor(random_factor(0.5, 1, grid.spacing_x()));
  print_curve("pressed", problem, mechanics::ContactLaw::augmented);
  problem = boxes;
  problem.counter = mechanics::BodyModuli{2.0 * soft_modulus, 0.2};
  print_curve("counter", problem, mechanics::ContactLaw::penalty);
  for (const int degree : {1, 2})
    print_curve(degree == 1 ? "column" : "column2", on_column(degree),
                mechanics::ContactLaw::penalty);
  problem = boxes_problem(grid, 2, body, 1e-6);
  problem.sides = mechanics::BlockSides::free;
  problem.far_boundary = mechanics::FarBoundary::sliding;
  print_curve("free", problem, mechanics::ContactLaw::penalty);
  problem = boxes;
  problem.mesh = tetrahedra_of(problem.mesh);
  print_curve("tetrahedra", problem, mechanics::ContactLaw::penalty);
  problem = boxes_problem({16, 16, 1e-6, 1e-6}, 1, body, 1e-6);
  problem.mesh = meshes::hanging_mesh(problem.grid, 1e-6, 4);
  problem.linear_solver = LinearSolver::multigrid;
  print_curve("hanging", problem, mechanics::ContactLaw::penalty);
}

/// Twelve rows of cells, which two and three ranks share.
void print_box_grids() {
  using mechanics::BlockSides;
  using mechanics::ContactLaw;
  for (const int degree : {1, 2})
    for (const BlockSides sides : {BlockSides::periodic, BlockSides::free})
      for (const ContactLaw law : {ContactLaw::hard, ContactLaw::penalty}) {
        const int points = 12 * degree;
        BlockProblem problem =
            boxes_problem({points, points, 1e-6, 1e-6}, degree, body, 1e-6);
        problem.sides = sides;
        problem.linear_solver = LinearSolver::multigrid;
        problem.moduli.set_factor(
            random_factor(0.5, 1, problem.grid.spacing_x()));
        std::string name = degree == 1 ? "first" : "second";
        name += sides == BlockSides::free ? "_free" : "_periodic";
        name += law == ContactLaw::hard ? "_hard" : "_penalty";
        print_curve(name.c_str(), problem, law);
      }
  for (const int degree : {1, 2}) {
    const int points = 12 * degree;
    BlockProblem problem =
        boxes_problem({points, points, 1e-6, 1e-6}, degree, body, 1e-6);
    problem.linear_solver = LinearSolver::multigrid;
    problem.far_boundary = mechanics::FarBoundary::pressure;
    print_curve("pressed", problem, ContactLaw::augmented);
  }
}

/// Second-order cells of two sizes, distorted if the sides are free.
BlockProblem hexahedra(mechanics::BlockSides sides) {
  BlockProblem problem = boxes_problem({16, 16, 1e-6, 1e-6}, 2, body, 1e-6);
  problem.mesh = meshes::hanging_mesh({8, 8, 1e-6, 1e-6}, 1e-6, 2);
  problem.moduli.add_layer(0.3e-6, moduli({5.0 * soft_modulus, 0.4}));
  problem.sides = sides;
  problem.linear_solver = LinearSolver::multigrid;
  if (sides == mechanics::BlockSides::free)
    shake(problem.mesh, 0.08e-6);
  return problem;
}

/// The stiffness of a contact whose nodes may slide, and that of nodes that
/// stick.
void print_stiffness(const BlockProblem& problem) {
  std::vector<double> heights = random_field(problem.grid.size(), 3);
  for (double& height : heights)
    height *= 4e-9;
  const auto block = make_full_block(problem);
  const BlockSolution found = block->solve(
      heights, {mechanics::Control::nominal_pressure, 1e6},
      {mechanics::ContactLaw::hard, 300.0 * soft_modulus / 1e-6, 1e-10, 400});
  const ContactStiffness stiffness = block->stiffness();
  if (is_first())
    std::printf("sticking %d %.16e %.16e %.16e %.16e\n",
                found.converged && stiffness.converged, stiffness.normal,
                stiffness.tangential, stiffness.normal / stiffness.tangential,
                found.area_by_points);
}

/// A mesh that follows the contact with a wave on a rough surface, under loads
/// that rise and fall.
void print_adaptive(const char* name, int degree, mechanics::BlockSides sides) {
  const Grid nodes{32, 32, 1e-6, 1e-6};
  const BlockProblem problem{
      .grid = nodes,
      .mesh = meshes::equal_boxes({8 / degree, 8 / degree, 1e-6, 1e-6}, 1e-6),
      .degree = degree,
      .moduli = ModuliField(moduli(body)),
      .sides = sides,
      .adaptive = AdaptiveMesh{2}};
  const std::vector<double> rough = random_field(nodes.size(), 5);
  std::vector<double> heights = wave_heights(nodes, 10e-9);
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] += 1e-9 * rough[i];
  const auto block = make_adaptive_block(problem);
  for (const double load : {2e5, 4e6, 2e5}) {
    const BlockSolution found = block->solve(
        heights, {mechanics::Control::nominal_pressure, load},
        {mechanics::ContactLaw::hard, 300.0 * soft_modulus / 1e-6, 1e-10, 400});
    if (is_first())
      std::printf("%s %d %zu %.16e %.16e %.16e\n", name, found.converged,
                  block->unknowns(), found.mean_gap, found.area_by_points,
                  largest_magnitude(found.pressure));
  }
}

/// Boxes with hanging nodes, in both orders.
void print_halved() {
  for (const int degree : {1, 2}) {
    BlockProblem problem =
        boxes_problem({16, 16, 1e-6, 1e-6}, degree, body, 1e-6);
    problem.mesh =
        meshes::hanging_mesh({16 / degree, 16 / degree, 1e-6, 1e-6}, 1e-6, 2);
    problem.linear_solver = LinearSolver::multigrid;
    print_curve(degree == 1 ? "halved" : "halved2", problem,
                mechanics::ContactLaw::augmented);
  }
}

/// Boxes that flow, the first ones of first order.
void print_flow() {
  for (const int degree : {1, 2}) {
    BlockProblem problem = boxes_problem(grid, degree, body, 1e-6);
    problem.law = j2_plasticity(3e6, 0.0);
    print_curve(degree == 1 ? "flow" : "flow2", problem,
                mechanics::ContactLaw::hard);
  }
}

/// A counter-body of second-order hexahedra.
void print_pairs() {
  BlockProblem problem = on_column(2);
  problem.linear_solver = LinearSolver::multigrid;
  print_curve("pair", problem, mechanics::ContactLaw::penalty);
}

void print_matrix_free() {
  print_curve("hexahedra", hexahedra(mechanics::BlockSides::periodic),
              mechanics::ContactLaw::hard);
  print_curve("distorted", hexahedra(mechanics::BlockSides::free),
              mechanics::ContactLaw::penalty);
  BlockProblem problem = hexahedra(mechanics::BlockSides::periodic);
  problem.far_boundary = mechanics::FarBoundary::pressure;
  print_curve("loaded", problem, mechanics::ContactLaw::augmented);
  problem = hexahedra(mechanics::BlockSides::free);
  problem.law = j2_plasticity(3e6, 0.1 * soft_modulus);
  print_curve("plastic", problem, mechanics::ContactLaw::hard);
  print_stiffness(hexahedra(mechanics::BlockSides::free));
  print_adaptive("adaptive", 2, mechanics::BlockSides::periodic);
  print_adaptive("first-order", 1, mechanics::BlockSides::free);
  print_halved();
  print_flow();
  print_pairs();
}

} // namespace

int main(int n_arguments, char** /*arguments*/) {
  start_mpi();
  const bool is_short = n_arguments > 1;
  if (!is_short)
    print_meshes();
  print_box_grids();
  if (!is_short)
    print_matrix_free();
}
