// Verifies that all instances of a slice of the stability matrix converged and
// were verified, or were refused with a reason. `asperity robustness` runs the
// entire matrix.
#include "robustness/run_instance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

namespace asperity::robustness::slice_test {

TEST(Slice, HasNoOtherOutcome) {
  int verified = 0;
  int refused = 0;
  for (int index = 0; index < 160; ++index) {
    Instance instance = draw_instance(11, index);
    if (instance.family == Family::full_block)
      continue;
    instance.points = std::min(instance.points, 32);
    instance.path = Path::library; // for those of the program see
                                   // robustness/program_instance
    const InstanceReport report = run_instance(within_reach(instance));
    EXPECT_TRUE(is_good(report.outcome))
        << name_of(report.outcome) << " " << report.check << ": "
        << report.reason << "\n"
        << text_of(instance);
    EXPECT_FALSE(report.outcome == Outcome::refused && report.reason.empty());
    verified += report.outcome == Outcome::verified;
    refused += report.outcome == Outcome::refused;
  }
  EXPECT_GT(verified, 100);
  EXPECT_GT(refused, 10);
}

TEST(Slice, RefusesEveryFlaw) {
  for (int flaw = 1; flaw <= static_cast<int>(Flaw::infinite_modulus); ++flaw)
    for (const int index : {0, 1}) {
      Instance instance;
      instance.index = index;
      instance.family = Family::flawed;
      instance.flaw = static_cast<Flaw>(flaw);

      const InstanceReport report = run_instance(instance);

      EXPECT_EQ(report.outcome, Outcome::refused)
          << name_of(instance.flaw) << ": " << report.reason;
    }
}

// Adhesion whose stiffness exceeds single precision (2352), whose faces jump
// into contact from afar (9007), and whose mean gap is far below that of the
// step before (14410).
TEST(Slice, SolvesAdhesion) {
  for (const auto& [seed, index] :
       {std::pair(39, 2352), std::pair(38, 9007), std::pair(39, 14410)}) {
    const InstanceReport report =
        run_instance(draw_instance(static_cast<std::uint64_t>(seed), index));

    EXPECT_EQ(report.outcome, Outcome::verified)
        << seed << " " << index << " " << report.check << ": " << report.reason;
  }
}

// Thin slabs with a free far boundary, for which both iterations stagnate: the
// active set of the solver solves them.
TEST(Slice, SolvesPlates) {
  for (const int index : {519, 944, 1738}) {
    const InstanceReport report = run_instance(draw_instance(1, index));

    EXPECT_EQ(report.outcome, Outcome::verified)
        << index << " " << report.check << ": " << report.reason;
  }
}

// Elastic blocks on a ball, a column and a cuboid of finite size, with coatings
// and moduli that vary: equal to the direct solver.
TEST(Slice, SolvesBlocksOnCounterBodies) {
  using mechanics::MeshKind;
  for (const auto& [counter, mesh, degree] :
       {std::tuple{CounterBody::sphere, MeshKind::layers, 1},
        {CounterBody::cylinder, MeshKind::gmsh, 2},
        {CounterBody::cuboid, MeshKind::hanging, 1}}) {
    Instance instance;
    instance.family = Family::full_block;
    instance.shape = Shape::wave;
    instance.points = 8;
    instance.counter = counter;
    instance.counter_stiffness = 0.1;
    instance.law = mechanics::ContactLaw::augmented;
    instance.load = 0.1;
    instance.thickness = 0.5;
    instance.mesh = mesh;
    instance.degree = degree;
    instance.linear_solver = mechanics::LinearSolver::multigrid;
    instance.modulus_ratio = 3.0;
    instance.coating_stiffness = 10.0;

    const InstanceReport report = run_instance(within_reach(instance));

    EXPECT_EQ(report.outcome, Outcome::verified)
        << report.check << ": " << report.reason << "\n"
        << text_of(within_reach(instance));
    EXPECT_TRUE(report.has_pair);
    EXPECT_GT(report.area, 0.0);
  }
}

// First-order and second-order blocks on balls of few cells, whose meshes had
// inverted cells, so that conjugate gradients broke down.
TEST(Slice, SolvesBlocksOnBallsOfFewCells) {
  for (const int index : {109, 992}) {
    const InstanceReport report = run_instance(draw_instance(9001, index));

    EXPECT_EQ(report.outcome, Outcome::verified)
        << index << ", " << report.check << ": " << report.reason;
  }
}

// Flat surfaces with second-order elements, held apart from hard contact, to
// which the solver once assigned a pressure of 1e13 Pa because roundoff
// concealed its error.
TEST(Slice, KeepsAFlatSurfaceSeparated) {
  for (const int index : {739, 928}) {
    const InstanceReport report = run_instance(draw_instance(101, index));

    EXPECT_EQ(report.outcome, Outcome::verified)
        << index << " " << report.check << ": " << report.reason;
    EXPECT_EQ(report.area, 0.0) << index;
  }
}

// A thin plate with a free back, on which conjugate gradients diverge. They
// must end at an error that does not depend on the units, and not where single
// precision overflows.
TEST(Slice, EndsDivergenceInAnyUnits) {
  const InstanceReport report = run_instance(draw_instance(90125, 441));

  EXPECT_EQ(report.outcome, Outcome::verified)
      << report.check << ": " << report.reason;
  EXPECT_TRUE(report.has_same_bits);
}

// An instance with a flaw that is in fact valid is not refused, which must be
// detected.
TEST(Slice, DetectsAMissingRefusal) {
  Instance instance;
  instance.family = Family::flawed;
  instance.flaw = Flaw::none;

  const InstanceReport report = run_instance(instance);

  EXPECT_EQ(report.outcome, Outcome::check_failed);
  EXPECT_EQ(report.check, "refusal");
}

// Small blocks with every unknown, one of each order for each linear solver,
// with moduli that differ by up to 1e6, free sides where the solver allows
// them, and a soft or a stiff coating: equal to the direct solver.
TEST(Slice, SolvesFullBlocks) {
  using mechanics::LinearSolver;
  int index = 0;
  for (const LinearSolver solver :
       {LinearSolver::automatic, LinearSolver::multigrid})
    for (const int degree : {1, 2}) {
      Instance instance;
      instance.index = index++;
      instance.family = Family::full_block;
      instance.law = mechanics::ContactLaw::penalty;
      instance.penalty = 1e4;
      instance.load = 0.3;
      instance.thickness = 0.3;
      instance.degree = degree;
      instance.linear_solver = solver;
      instance.modulus_ratio = 1e3;
      instance.coating_stiffness = degree == 1 ? 1e-3 : 1e3;
      instance.has_free_sides = solver == LinearSolver::multigrid;

      const InstanceReport report = run_instance(within_reach(instance));

      EXPECT_EQ(report.outcome, Outcome::verified)
          << report.check << ": " << report.reason << "\n"
          << text_of(within_reach(instance));
      EXPECT_TRUE(report.has_pair);
    }
}

// A block on each other kind of mesh, with a coating and moduli that differ by
// up to 100: equal to the direct solver. First-order cells of gmsh are
// tetrahedra at odd indices. At this length deal.II did not find points in
// them.
TEST(Slice, SolvesFullBlocksOnOtherMeshes) {
  using mechanics::MeshKind;
  for (const MeshKind mesh :
       {MeshKind::hanging, MeshKind::adaptive, MeshKind::gmsh}) {
    Instance instance;
    instance.index = 1;
    instance.family = Family::full_block;
    instance.law = mechanics::ContactLaw::penalty;
    instance.penalty = 1e4;
    instance.load = 0.3;
    instance.points = 8;
    instance.length = 59650.134936840383;
    instance.thickness = 0.1;
    instance.degree = mesh == MeshKind::hanging ? 2 : 1;
    instance.mesh = mesh;
    instance.linear_solver = mechanics::LinearSolver::multigrid;
    instance.modulus_ratio = 10.0;
    instance.coating_stiffness = 10.0;
    instance.has_free_sides = mesh != MeshKind::gmsh;

    const InstanceReport report = run_instance(within_reach(instance));

    EXPECT_EQ(report.outcome, Outcome::verified)
        << report.check << ": " << report.reason << "\n"
        << text_of(within_reach(instance));
    EXPECT_TRUE(report.has_pair);
  }
}

// The cells of a stiff coating, 0.004 lengths thick, are 57 times as wide as
// high, and the moduli beside each other differ by 48^2: conjugate gradients do
// not converge, and `auto` goes on with the direct solver.
TEST(Slice, SolvesFlatCellsOfLargeContrast) {
  const InstanceReport report = run_instance(draw_instance(11, 184));

  EXPECT_EQ(report.outcome, Outcome::verified)
      << report.check << ": " << report.reason;
}

// Under light loads and stiff springs, on a mesh whose contact points are not
// the highest nodes of the map: gaps must not be differences of larger numbers.
// One block of hexahedra under a coating, one of tetrahedra with free sides.
TEST(Slice, BalancesLightLoadsBetweenTheHighestNodes) {
  for (const int index : {14149, 333}) {
    const InstanceReport report = run_instance(draw_instance(4001, index));

    EXPECT_EQ(report.outcome, Outcome::verified)
        << index << ", " << report.check << ": " << report.reason;
  }
}

/// A problem with a direct solver beside it, which was drawn for two ranks.
Instance drawn_for_one_process(std::uint64_t seed, int index) {
  Instance instance = draw_instance(seed, index);
  instance.path = Path::library;
  instance.relation = MetamorphicRelation::direct_solver;
  return instance;
}

// Pressures below that of a gap tolerance: tension at nodes in contact must be
// small for the balance of forces, too. Sawteeth on a block with hanging nodes
// and a flat surface on one of gmsh, whose last steps left a tension of 24 and
// 47 % of the largest force.
TEST(Slice, KeepsNoTensionUnderLightLoads) {
  for (const auto& [seed, index] : {std::pair{601, 1355}, {4001, 8387}}) {
    const InstanceReport report =
        run_instance(draw_instance(static_cast<std::uint64_t>(seed), index));

    EXPECT_EQ(report.outcome, Outcome::verified)
        << index << ", " << report.check << ": " << report.reason;
  }
}

// Paraboloids on adaptive meshes, almost in full contact at a prescribed mean
// gap: second-order nodes have unequal areas, and the mean height is that of
// these areas, below which no mean gap exists.
TEST(Slice, ReachesSmallMeanGapsOnAdaptiveMeshes) {
  for (const auto& [seed, index] : {std::pair{1001, 391}, {4001, 7714}}) {
    const InstanceReport report =
        run_instance(draw_instance(static_cast<std::uint64_t>(seed), index));

    EXPECT_EQ(report.outcome, Outcome::verified)
        << index << ", " << report.check << ": " << report.reason;
  }
}

// A thin, nearly incompressible coating is stiffer than its shear modulus per
// node spacing by a factor of 6e4, so that the working penalty has to grow.
TEST(Slice, AugmentsStiffCoatings) {
  const InstanceReport report = run_instance(drawn_for_one_process(5001, 7123));

  EXPECT_EQ(report.outcome, Outcome::verified)
      << report.check << ": " << report.reason;
  EXPECT_TRUE(report.has_pair);
  EXPECT_LT(report.iterations, 100);
}

// Soft springs on a nearly incompressible coating, 858 times stiffer than the
// block: the roundoff of its displacements exceeds the tolerance of forces.
TEST(Slice, SaysThatForcesCannotBeRepresented) {
  const InstanceReport report = run_instance(draw_instance(1001, 1666));

  EXPECT_EQ(report.outcome, Outcome::refused);
  EXPECT_NE(report.reason.find("roundoff of the displacements"),
            std::string::npos)
      << report.reason;
}

/// A problem that was found before meshes were drawn, on its mesh of layers.
Instance drawn_on_layers(std::uint64_t seed, int index) {
  Instance instance = draw_instance(seed, index);
  instance.mesh = mechanics::MeshKind::layers;
  return within_reach(instance);
}

// Newton's method with full steps cycles on this block under a prescribed
// load; shortened steps find its contact set.
TEST(Slice, SolvesAFullBlockWhoseContactSetCycles) {
  Instance instance = drawn_on_layers(520, 5179);
  instance.linear_solver = mechanics::LinearSolver::automatic;
  instance.modulus_ratio = 10.0;
  instance.poisson_ratio = 0.4999;

  const InstanceReport report = run_instance(instance);

  EXPECT_EQ(report.outcome, Outcome::verified)
      << report.check << ": " << report.reason;
}

// A heterogeneous block that lifts two of its nodes under any pressure: a mean
// gap below the least one has no solution.
TEST(Slice, RefusesAMeanGapThatNoPressureReaches) {
  const InstanceReport report = run_instance(drawn_on_layers(520, 2996));

  EXPECT_EQ(report.outcome, Outcome::refused);
  EXPECT_NE(report.reason.find("mean must be at least"), std::string::npos)
      << report.reason;
}

// The first load that is tried is more than 1e6 times too large.
TEST(Slice, FindsAMeanGapFarFromTheFirstLoad) {
  const InstanceReport report = run_instance(draw_instance(12001, 18812));

  EXPECT_EQ(report.outcome, Outcome::verified)
      << report.check << ": " << report.reason;
}

/// Second-order cells of a stiff coating with moduli that differ by 38^2, held
/// at a mean gap by hard contact.
Instance held_at_mean_gap(double gap) {
  Instance instance = draw_instance(6001, 2870);
  instance.points = 8;
  instance.load = gap;
  return within_reach(instance);
}

// The mean gap has a least value, beyond which it increases with the pressure.
// A gap above it is found, although full steps lead to pressures of 1e9 E*.
// What is said of one below it agrees with that: the least value lies between.
TEST(Slice, FindsMeanGapsDownToTheLeast) {
  const InstanceReport found = run_instance(held_at_mean_gap(0.009));
  const InstanceReport refused = run_instance(held_at_mean_gap(0.003));

  EXPECT_EQ(found.outcome, Outcome::verified)
      << found.check << ": " << found.reason;
  ASSERT_EQ(refused.outcome, Outcome::refused) << refused.reason;
  const auto value_after = [&](const std::string& words) {
    const std::size_t at = refused.reason.find(words);
    return at == std::string::npos
               ? 0.0
               : std::stod(refused.reason.substr(at + words.size()));
  };
  const double share =
      value_after("must be at least ") / value_after("closes the gap to ");
  EXPECT_GT(share, 1.0) << refused.reason;
  EXPECT_LT(share, 0.009 / 0.003) << refused.reason;
}

} // namespace asperity::robustness::slice_test
