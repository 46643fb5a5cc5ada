// Tests of the multigrid of fem/multigrid on rows of cells that ranks share:
// stiffness, solution, iterations and memory compared with one process. The
// ranks are threads.
#include "fem/multigrid/lattice_multigrid.hpp"
#include "fem/multigrid/rigid_modes.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <mutex>
#include <numbers>

namespace asperity::fem::shared_lattice_test {

enum class Moduli { layers, heterogeneous, heterogeneous_ratios };
enum class Contact { none, held, sticking, springs };

struct SharedCase {
  int degree = 1;
  int rows = 16; ///< of cells
  bool is_periodic = true;
  Moduli moduli = Moduli::layers;
  bool holds_lateral = true, holds_normal = true;
};

BoxLattice lattice_of(const SharedCase& own) {
  BoxLattice lattice;
  lattice.degree = own.degree;
  lattice.cells_x = 8;
  lattice.cells_y = own.rows;
  lattice.length_x = 1.0;
  lattice.length_y = 1.0 / 8.0 * own.rows;
  lattice.thickness = meshes::graded_layers(0.125, 1.3, 0.8);
  lattice.is_periodic = own.is_periodic;
  lattice.holds_lateral = own.holds_lateral;
  lattice.holds_normal = own.holds_normal;
  lattice.moduli.assign(lattice.thickness.size(), {1.5, 1.0});
  if (own.moduli == Moduli::layers)
    return lattice;
  const std::size_t cells =
      8U * static_cast<std::size_t>(own.rows) * lattice.thickness.size();
  lattice.moduli.clear();
  for (const double chance : random_field(cells, 4)) {
    const double ratio =
        own.moduli == Moduli::heterogeneous ? 1.5 : 1.0 + chance;
    lattice.moduli.push_back({ratio * (0.5 + chance), 0.5 + chance});
  }
  return lattice;
}

/// The part of a vector of all nodes that a rank holds, without images.
std::vector<double> part_of(const std::vector<double>& whole,
                            const BoxLattice& lattice,
                            const LatticeSlab& slab) {
  const NodeLayout all(lattice), own = slab.layout(lattice);
  std::vector<double> part(own.size(), 0.0);
  for (int k = 0; k < static_cast<int>(own.planes()); ++k)
    for (int y = 0; y < own.nodes_y(); ++y)
      for (int x = 0; x < own.nodes_x(); ++x)
        for (int c = 0; c < 3; ++c)
          part[own.index(x, y, k, c)] =
              whole[all.index(x, y + lattice.degree * slab.first(), k, c)];
  return part;
}

/// The largest difference of a rank's part from the whole, over the largest
/// value.
double difference(const std::vector<double>& part,
                  const std::vector<double>& whole, const BoxLattice& lattice,
                  const LatticeSlab& slab) {
  const std::vector<double> expected = part_of(whole, lattice, slab);
  const NodeLayout own = slab.layout(lattice);
  double largest = 0.0, size = 0.0;
  for (const double value : whole)
    size = std::max(size, std::abs(value));
  for (int k = 0; k < static_cast<int>(own.planes()); ++k)
    for (int y = 0; y < own.nodes_y(); ++y)
      for (int x = 0; x < own.nodes_x(); ++x)
        for (int c = 0; c < 3; ++c) {
          const std::size_t at = own.index(x, y, k, c);
          largest = std::max(largest, std::abs(part[at] - expected[at]));
        }
  return largest / size;
}

std::vector<double> random_vector(const BoxLattice& lattice) {
  const NodeLayout layout(lattice);
  std::vector<double> vector(layout.size(), 0.0);
  const std::vector<double> numbers = random_field(layout.size(), 6);
  for (int k = 0; k < static_cast<int>(layout.planes()); ++k)
    for (int y = 0; y < layout.nodes_y(); ++y)
      for (int x = 0; x < layout.nodes_x(); ++x)
        for (int c = 0; c < 3; ++c) {
          const std::size_t at = layout.index(x, y, k, c);
          vector[at] = numbers[at] - 0.5;
        }
  return vector;
}

/// Sets the supported unknowns of a vector of all nodes to zero.
void clear_far_boundary(const BoxLattice& lattice,
                        std::vector<double>& vector) {
  unknowns_of(lattice, LatticeSlab(lattice))
      .constraints->visit([&](std::size_t place) { vector[place] = 0.0; });
}

/// Whether the cell or node at a place in [0, 1)^2 is in contact.
bool is_touched(double x, double y) {
  const double turn = 2.0 * std::numbers::pi;
  return std::cos(turn * x) + std::cos(turn * (2.0 * y + 0.1)) > 0.5;
}

/// The contact of a rank's rows. Springs couple all nodes of a cell's face.
MeshContact contact_of(Contact kind, const BoxLattice& lattice,
                       const LatticeSlab& slab) {
  MeshContact contact;
  const NodeLayout layout = slab.layout(lattice);
  const int nodes_x = layout.nodes_x(), nodes_y = layout.nodes_y();
  const int degree = lattice.degree;
  contact.is_sticking = kind == Contact::sticking;
  if (kind == Contact::held || kind == Contact::sticking)
    for (int y = 0; y < nodes_y; ++y)
      for (int x = 0; x < nodes_x; ++x)
        if (is_touched(1.0 * x / nodes_x, 1.0 * (y + degree * slab.first()) /
                                              (degree * lattice.cells_y)))
          contact.held.push_back(layout.index(x, y, 0, 2));
  if (kind != Contact::springs)
    return contact;
  const int rows =
      slab.is_shared() ? static_cast<int>(layout.slices()) : nodes_y;
  SparseRows shapes; // a cell's mean displacement, weighted unevenly
  for (int y = 0; y < slab.count(); ++y)
    for (int x = 0; x < lattice.cells_x; ++x) {
      if (!is_touched((x + 0.5) / lattice.cells_x,
                      (y + slab.first() + 0.5) / lattice.cells_y))
        continue;
      for (int j = 0; j <= degree; ++j)
        for (int i = 0; i <= degree; ++i) {
          shapes.column.push_back(layout.index((degree * x + i) % nodes_x,
                                               (degree * y + j) % rows, 0, 2));
          shapes.weight.push_back(0.2 + 0.1 * i + 0.03 * j);
        }
      shapes.start.push_back(shapes.column.size());
    }
  const std::vector<double> springs(shapes.rows(), 1.0);
  const std::vector<bool> held(shapes.rows(), false);
  return contact_of_points(shapes, {springs, held, false}, layout.size(),
                           slab.ranks());
}

/// Coarser lattices have the borders of the ranks if the number of rows is
/// even.
std::vector<SharedCase> all_cases() {
  std::vector<SharedCase> found;
  for (const int degree : {1, 2})
    for (const bool is_periodic : {true, false}) {
      found.push_back({degree, 16, is_periodic, Moduli::layers});
      found.push_back({degree, 16, is_periodic, Moduli::heterogeneous_ratios});
      found.push_back({degree, 17, is_periodic, Moduli::heterogeneous});
    }
  return found;
}

class SharedLattices : public ::testing::TestWithParam<SharedCase> {};

INSTANTIATE_TEST_SUITE_P(All, SharedLattices, ::testing::ValuesIn(all_cases()),
                         [](const auto& parameter) {
                           const SharedCase& own = parameter.param;
                           return "q" + std::to_string(own.degree) + "_" +
                                  std::to_string(own.rows) +
                                  (own.is_periodic ? "_periodic_" : "_free_") +
                                  std::to_string(static_cast<int>(own.moduli));
                         });

// Verifies the stiffness on 2 to 4 ranks. Tolerance: roundoff of a sum over the
// cells of a node.
TEST_P(SharedLattices, HaveTheStiffnessOfOneProcess) {
  const BoxLattice lattice = lattice_of(GetParam());
  const LatticeMultigrid alone(lattice);
  std::vector<double> displacement = random_vector(lattice), expected;
  clear_far_boundary(lattice, displacement);
  alone.apply(displacement, expected);

  for (const int n : {2, 3, 4})
    tests::on_thread_ranks(n, [&](RankGroup& ranks) {
      const LatticeMultigrid shared(lattice, &ranks);
      ASSERT_TRUE(shared.slab().is_shared());
      auto own = part_of(displacement, lattice, shared.slab());
      std::vector<double> force;

      shared.apply(own, force);

      EXPECT_LT(difference(force, expected, lattice, shared.slab()), 1e-14);
    });
}

struct Answer {
  std::vector<double> displacement;
  LinearSolution solution;
  std::size_t bytes = 0;
};

/// Solves on this rank's rows, or on all rows without ranks.
Answer solved(const BoxLattice& lattice, Contact contact,
              const std::vector<double>& force, RankGroup* ranks) {
  LatticeMultigrid multigrid(lattice, ranks);
  multigrid.set_contact(contact_of(contact, lattice, multigrid.slab()));
  const std::vector<double> own = part_of(force, lattice, multigrid.slab());
  Answer answer;
  answer.displacement.assign(own.size(), 0.0);
  double square = 0.0;
  for (const double value : force)
    square += value * value;
  multigrid.force() = own;
  answer.solution =
      multigrid.solve(answer.displacement, 1e-12 * std::sqrt(square), 100);
  answer.bytes = multigrid.bytes();
  return answer;
}

void expect_same_solution(const SharedCase& own, Contact contact) {
  const BoxLattice lattice = lattice_of(own);
  std::vector<double> force = random_vector(lattice);
  clear_far_boundary(lattice, force);
  const Answer expected = solved(lattice, contact, force, nullptr);
  ASSERT_TRUE(expected.solution.has_converged);
  for (const int n : {2, 3, 4})
    tests::on_thread_ranks(n, [&](RankGroup& ranks) {
      const Answer found = solved(lattice, contact, force, &ranks);
      EXPECT_TRUE(found.solution.has_converged);
      EXPECT_LE(
          std::abs(found.solution.iterations - expected.solution.iterations),
          1);
      EXPECT_NEAR(found.solution.first_residual,
                  expected.solution.first_residual,
                  1e-12 * expected.solution.first_residual);
      EXPECT_LT(difference(found.displacement, expected.displacement, lattice,
                           LatticeMultigrid(lattice, &ranks).slab()),
                1e-10);
    });
}

// Verifies the solution on 2 to 4 ranks in any contact, and that it takes as
// many iterations as in one process. Tolerance: the residual times the
// condition number.
TEST_P(SharedLattices, HaveTheSolutionOfOneProcess) {
  for (const Contact contact :
       {Contact::none, Contact::held, Contact::sticking, Contact::springs}) {
    SCOPED_TRACE(static_cast<int>(contact));
    expect_same_solution(GetParam(), contact);
  }
}

// Verifies the rigid motions of a block that may move. The solutions of such
// blocks are compared in lattice_ranks_test.cpp.
TEST(SharedLatticeMotions, AreThoseOfOneProcess) {
  for (const int degree : {1, 2})
    for (const bool is_periodic : {true, false}) {
      const BoxLattice lattice =
          lattice_of({degree, 16, is_periodic, Moduli::heterogeneous, false,
                      !is_periodic});
      const auto modes = rigid_modes(lattice, LatticeSlab(lattice), false);
      tests::on_thread_ranks(3, [&](RankGroup& ranks) {
        const LatticeSlab slab = divided(lattice, &ranks);
        const auto own = rigid_modes(lattice, slab, false);
        ASSERT_EQ(own.size(), modes.size());
        for (std::size_t i = 0; i < own.size(); ++i)
          EXPECT_EQ(difference(own[i], modes[i], lattice, slab), 0.0);
      });
    }
}

// Verifies that the memory of a rank falls with the number of ranks. A quarter
// of the rows takes a quarter of the memory. The image row adds a sixteenth of
// it, and the coarse lattices that every rank has some per cent.
TEST(SharedLatticeMemory, IsDividedAmongTheRanks) {
  for (const int degree : {1, 2}) {
    SharedCase own;
    own.degree = degree;
    own.rows = 64;
    const BoxLattice lattice = lattice_of(own);
    const std::size_t alone = LatticeMultigrid(lattice).bytes();
    tests::on_thread_ranks(4, [&](RankGroup& ranks) {
      EXPECT_LT(LatticeMultigrid(lattice, &ranks).bytes(), 35 * alone / 100);
    });
  }
}

// Verifies that every rank solves a lattice of few rows alone.
TEST(SharedLatticeRows, AreNotSharedIfThereAreFew) {
  SharedCase own;
  own.rows = 6;
  const BoxLattice lattice = lattice_of(own);
  tests::on_thread_ranks(4, [&](RankGroup& ranks) {
    EXPECT_FALSE(LatticeMultigrid(lattice, &ranks).slab().is_shared());
  });
  own.rows = 64;
  const BoxLattice long_lattice = lattice_of(own);
  tests::on_thread_ranks(3, [&](RankGroup& ranks) {
    const LatticeSlab slab = divided(long_lattice, &ranks);
    EXPECT_EQ(slab.bounds(), std::vector<int>({0, 16, 40, 64}));
  });
}

} // namespace asperity::fem::shared_lattice_test
