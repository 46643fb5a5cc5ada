// The cost of multigrid as the preconditioner of a second-order block, set up
// for the block's own matrix and for that of first-order cells between the same
// nodes (fem/block/block_assembly.hpp): entries, set-up and solve in CPU
// seconds, iterations. The patch of nodes in contact with a sphere is displaced
// by one length; residual to 1e-8 of the load; the solutions are compared.
//
//     bench_second_order_block [points] [indentation|graded] [repeats]
//
// Nodes per side (32); gmsh's mesh that is fine under the sphere, or boxes
// whose layers grow by 1.5 to a depth of one side; pairs of runs (1).
#include "base/cpu_clock.hpp"
#include "fem/block/block_assembly.hpp"
#include "fem/linear/block_solver.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "meshes/gmsh_block.hpp"
#include "meshes/layered_mesh.hpp"
#include "meshes/layers/graded_layers.hpp"

#include <deal.II/lac/solver_cg.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace asperity::fem {
namespace {

using dealii::TrilinosWrappers::PreconditionAMG;
using Matrix = dealii::TrilinosWrappers::SparseMatrix;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr double side = 1e-3; // m

BlockProblem problem_of(int points, bool is_indentation) {
  const Grid grid{points, points, side, side};
  BlockProblem problem{
      grid, {}, 2, ModuliField(moduli(mechanics::BodyModuli{2e9, 0.3}))};
  if (is_indentation) {
    meshes::GmshBlock block;
    block.geometry = mechanics::MeshGeometry::indentation;
    block.length_x = block.length_y = block.depth = side;
    block.size_at_contact = 2.0 * grid.spacing_x();
    block.size_far = 0.125 * side;
    block.fine_radius = 0.15 * side;
    problem.mesh = meshes::gmsh_block(block);
  } else {
    const Grid cells{points / 2, points / 2, side, side};
    problem.mesh = meshes::layered_mesh(
        cells, meshes::graded_layers(cells.spacing_x(), 1.5, side));
  }
  return problem;
}

/// Springs that constrain the patch as hard contact would, and the load that
/// displaces it.
struct Patch {
  std::vector<double> springs; ///< [N/m]
  Vector load;                 ///< [N]

  explicit Patch(const BlockSystem& system)
      : springs(system.contact().size(), 0.0),
        load(system.space().make_vector()) {
    const double stiff = 1e3 * system.face_shear_modulus() * side;
    for (std::size_t i = 0; i < springs.size(); ++i) {
      const auto& place = system.contact()[i].place;
      if (std::hypot(place[0] - 0.5 * side, place[1] - 0.5 * side) < 0.1 * side)
        springs[i] = stiff;
    }
    system.contact().add_force(springs, load);
  }
};

/// One set-up and solve, printed; the solution is in `displacement`.
double solve(const char* name, const Matrix& matrix, const Matrix& stands_for,
             const PreconditionAMG::AdditionalData& settings,
             const Vector& load, Vector& displacement) {
  const CpuClock setting_up;
  PreconditionAMG multigrid;
  multigrid.initialize(stands_for, settings);
  const double set_up = setting_up.seconds();
  dealii::SolverControl control(1000, 1e-8 * load.l2_norm(), false, false);
  dealii::SolverCG<Vector> conjugate_gradients(control);
  displacement = 0.0;
  const CpuClock solving;
  conjugate_gradients.solve(matrix, displacement, load, multigrid);
  const double seconds = solving.seconds();
  std::printf("%-13s %10llu %8.2f %8.2f %5u\n", name,
              static_cast<unsigned long long>(stands_for.n_nonzero_elements()),
              set_up, seconds, control.last_step());
  std::fflush(stdout);
  return set_up + seconds;
}

void run(int points, bool is_indentation, int repeats) {
  const BlockSystem system(problem_of(points, is_indentation));
  const Patch patch(system);
  Matrix matrix, low_order;
  matrix.copy_from(system.stiffness());
  const CpuClock assembling;
  assemble_low_order(system, low_order);
  std::printf("%s%.2f s CPU to assemble first order\n", system.report().c_str(),
              assembling.seconds());
  system.contact().add_springs(patch.springs, matrix);
  system.contact().add_springs(patch.springs, low_order);
  std::printf("set up for       entries   set-up    solve  iter\n"
              "                          [s CPU]  [s CPU]\n");
  Vector by_own(patch.load), by_first(patch.load);
  for (int pair = 0; pair < repeats; ++pair) {
    const double own =
        solve("second order", matrix, matrix,
              multigrid_settings(system.space(), true), patch.load, by_own);
    const double first =
        solve("first order", matrix, low_order,
              multigrid_settings(system.space(), false), patch.load, by_first);
    const double size = by_own.linfty_norm();
    by_first -= by_own;
    std::printf("ratio %.2f, answers differ by %.1e\n", own / first,
                by_first.linfty_norm() / size);
  }
}

} // namespace
} // namespace asperity::fem

int main(int n_arguments, char** arguments) {
  asperity::fem::start_mpi();
  asperity::fem::run(n_arguments > 1 ? std::atoi(arguments[1]) : 32,
                     n_arguments > 2 &&
                         std::strcmp(arguments[2], "indentation") == 0,
                     n_arguments > 3 ? std::atoi(arguments[3]) : 1);
}
