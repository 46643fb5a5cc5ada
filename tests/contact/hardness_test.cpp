// Tests of hard contact with a hardness H: pressures between 0 and H, and the
// imprint that a surface keeps along a path.
#include "base/ranks/node_sums.hpp"
#include "contact/certificate/certificate.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "contact/solvers/polonsky_keer.hpp"
#include "tests/contact/problems.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace asperity::contact::hardness_test {

using Kind = mechanics::Control;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Largest violation of 0 <= p <= H, gap >= 0 where p < H, gap <= 0 where
/// p > 0 [m]. The displacement is computed again.
double error_of(SurfaceOperator& elasticity, const ContactProblem& problem,
                const ContactSolution& solution) {
  std::vector<double> displacement(problem.heights.size());
  elasticity.displacement(solution.pressure, displacement);
  const double rigid = solution.gap[0] - displacement[0] + problem.heights[0];
  double error = 0.0;
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    const double p = solution.pressure[i];
    const double gap = displacement[i] - problem.heights[i] + rigid;
    if (!(p >= 0.0 && p <= problem.hardness))
      return infinity;
    if (p < problem.hardness)
      error = maximum(error, -gap);
    if (p > 0.0)
      error = maximum(error, gap);
  }
  return error;
}

double share_at(const std::vector<double>& pressure, double least) {
  const auto count =
      std::ranges::count_if(pressure, [=](double own) { return own >= least; });
  return static_cast<double>(count) / static_cast<double>(pressure.size());
}

constexpr Grid grid{128, 128, 1.0, 1.0};

std::unique_ptr<SurfaceOperator> block(double thickness = infinity,
                                       int threads = 1) {
  return std::make_unique<FourierOperator>(
      halfspace_operator(grid, {1.0, 0.3, thickness, {}}, threads));
}

class Hardness : public testing::Test {
protected:
  std::vector<double> heights = problems::rough_heights(grid, {});
  double rms_height = problems::rms(heights);
  double tolerance = 1e-8 * rms_height;

  ContactProblem problem(double hardness) const {
    return {heights, 0.0, tolerance, 100, hardness};
  }

  LoadSequence path(double hardness, int threads = 1) const {
    return {block(infinity, threads),
            heights,
            {.law = mechanics::ContactLaw::hard, .hardness = hardness},
            tolerance,
            100};
  }

  static mechanics::LoadTarget load(double pressure) {
    return {Kind::nominal_pressure, pressure};
  }
};

// E* h' = 1, so that H = 10 is reached near full contact only, and H = 1e-4
// changes next to nothing of the heights. Cold starts and coarse-to-fine ones
// take as many iterations as hard contact: 9 and 16 at most were seen.
TEST_F(Hardness, IsSolvedAsFastAsHardContact) {
  for (const double thickness : {infinity, 0.1}) {
    const std::unique_ptr<SurfaceOperator> elasticity = block(thickness);
    for (const double hardness : {10.0, 1.0, 0.1, 0.01, 1e-4})
      for (const double share : {0.01, 0.1, 0.5, 0.9, 0.999, 1.0}) {
        const mechanics::LoadTarget target = load(share * hardness);
        const std::string what = std::to_string(hardness) + " " +
                                 std::to_string(share) + " " +
                                 std::to_string(thickness);
        const ContactSolution found =
            solve_contact(*elasticity, problem(hardness), target,
                          coarse_start(*elasticity, problem(hardness), target,
                                       1e-3 * rms_height));
        EXPECT_TRUE(found.converged) << what << found.note;
        EXPECT_LE(found.iterations, 12) << what;
        EXPECT_LE(error_of(*elasticity, problem(hardness), found),
                  2.0 * tolerance)
            << what;
        EXPECT_NEAR(found.nominal_pressure, target.amount,
                    1e-11 * target.amount);
        const ContactSolution cold =
            solve_contact(*elasticity, problem(hardness), target);
        EXPECT_TRUE(cold.converged) << what << cold.note;
        EXPECT_LE(cold.iterations, 18) << what;
        EXPECT_NEAR(cold.mean_gap, found.mean_gap,
                    share < 1.0 ? 4.0 * tolerance : 1e-6)
            << what;
      }
  }
}

TEST_F(Hardness, IsSolvedAtAMeanGapToo) {
  const std::unique_ptr<SurfaceOperator> elasticity = block();
  for (const double hardness : {1.0, 0.1, 0.01})
    for (const double gap : {2.0, 0.5, 0.05}) {
      const ContactSolution found = solve_contact(
          *elasticity, problem(hardness), {Kind::mean_gap, gap * rms_height});
      EXPECT_TRUE(found.converged) << hardness << " " << gap << found.note;
      EXPECT_LE(error_of(*elasticity, problem(hardness), found),
                2.0 * tolerance);
      const ContactSolution again = solve_contact(
          *elasticity, problem(hardness), load(found.nominal_pressure));
      EXPECT_NEAR(again.mean_gap, gap * rms_height, 4.0 * tolerance);
    }
}

TEST_F(Hardness, BeyondAllPressuresChangesNoBit) {
  LoadSequence elastic = path(infinity);
  LoadSequence hard = path(1e3);
  for (const double pressure : {0.01, 0.02, 0.1, 0.02}) {
    const ContactSolution expected = elastic.solve(load(pressure));
    const ContactSolution found = hard.solve(load(pressure));
    EXPECT_EQ(found.pressure, expected.pressure) << pressure;
    EXPECT_EQ(found.gap, expected.gap) << pressure;
    EXPECT_EQ(found.mean_gap, expected.mean_gap) << pressure;
    EXPECT_EQ(found.iterations, expected.iterations) << pressure;
    EXPECT_EQ(found.mean_imprint, 0.0) << pressure;
  }
}

// Without elasticity the highest nodes carry H. Elastic displacements of 1e-4
// of the heights move the border by 1e-4 of the nodes or so.
TEST_F(Hardness, OfNothingCarriesOnTheBearingArea) {
  const double hardness = 1e-5;
  std::vector<double> sorted = heights;
  std::ranges::sort(sorted, std::greater<>());
  for (const double share : {0.01, 0.2, 0.7}) {
    const ContactSolution found = path(hardness).solve(load(share * hardness));
    const auto rank =
        static_cast<std::size_t>(share * static_cast<double>(heights.size()));
    EXPECT_NEAR(share_at(found.pressure, hardness), share, 1e-3);
    EXPECT_NEAR(found.mean_gap, sorted[rank], 1e-4 * rms_height);
  }
}

TEST_F(Hardness, RefusesALoadAboveIt) {
  const std::unique_ptr<SurfaceOperator> elasticity = block();
  EXPECT_NE(tests::message_of<std::domain_error>([&] {
              solve_contact(*elasticity, problem(0.5), load(0.6));
            }).find("at most the hardness, 0.5"),
            std::string::npos);
}

TEST_F(Hardness, EndsAPathAboveItWithoutConvergence) {
  LoadSequence own = path(0.5);
  EXPECT_TRUE(own.solve(load(0.4)).converged);
  const ContactSolution beyond = own.solve(load(0.6));
  EXPECT_FALSE(beyond.converged);
  EXPECT_NE(beyond.note.find("at most the hardness, 0.5 Pa"),
            std::string::npos);
  EXPECT_EQ(beyond.gap.size(), heights.size());
  EXPECT_TRUE(own.solve(load(0.45)).converged);
}

// The surface yields under the whole sphere: L = H pi a^2, and the area is that
// of the sphere at the indentation, pi a^2 = 2 pi R d, as for the plastic
// sphere of Abbott and Firestone. The elastic depth of the disc is of order
// H a/E*, 1e-4 of d; the border of nodes is 1 % of the area.
TEST(PlasticSphere, CarriesTheHardnessOnTheSectionOfTheSphere) {
  constexpr Grid cell{96, 96, 1.0, 1.0};
  const double radius = 4.0, hardness = 1e-6;
  std::vector<double> heights(cell.size());
  for (int iy = 0; iy < cell.points_y; ++iy)
    for (int ix = 0; ix < cell.points_x; ++ix) {
      const double x = ix * cell.spacing_x() - 0.5;
      const double y = iy * cell.spacing_y() - 0.5;
      heights[cell.index(ix, iy)] = -(x * x + y * y) / (2.0 * radius);
    }
  LoadSequence path(free_halfspace(cell, 1.0, 1).clone(), heights,
                    {.law = mechanics::ContactLaw::hard, .hardness = hardness},
                    1e-10, 100);
  const double p0 = 0.3 * hardness;
  const ContactSolution found = path.solve({Kind::nominal_pressure, p0});

  ASSERT_TRUE(found.converged) << found.note;
  const double area = share_at(found.pressure, 0.5 * hardness);
  EXPECT_NEAR(p0, hardness * area, 1e-3 * p0);
  const double depth = -(found.gap[0] + heights[0] -
                         found.displacement[0]); // minus the separation
  EXPECT_NEAR(area, 2.0 * std::numbers::pi * radius * depth, 0.01 * area);
}

// Tolerance of mean gaps: that of each of up to six solutions in the gap.
TEST_F(Hardness, UnloadingIsElasticAndReloadingRetracesIt) {
  const double hardness = 0.3;
  LoadSequence sequence = path(hardness);
  sequence.solve(load(0.03));
  const ContactSolution top = sequence.solve(load(0.1));
  ASSERT_GT(share_at(top.pressure, hardness), 0.05);
  const ContactSolution half = sequence.solve(load(0.05));
  const ContactSolution low = sequence.solve(load(0.01));
  const ContactSolution half_again = sequence.solve(load(0.05));
  const ContactSolution top_again = sequence.solve(load(0.1));

  EXPECT_NEAR(half_again.mean_gap, half.mean_gap, 6.0 * tolerance);
  EXPECT_NEAR(top_again.mean_gap, top.mean_gap, 6.0 * tolerance);
  EXPECT_NEAR(top_again.mean_imprint, top.mean_imprint, 2.0 * tolerance);
  EXPECT_EQ(low.mean_imprint, top.mean_imprint) << "unloading is elastic";
  const ContactSolution first = path(hardness).solve(load(0.05));
  EXPECT_LT(half.mean_gap, first.mean_gap - 1e-3 * rms_height)
      << "the block stays closer after the load";
  EXPECT_TRUE(std::ranges::all_of(low.gap, [&](double gap) {
    return gap >= -tolerance;
  })) << "gaps are those of the imprinted surface";
  // An elastic solution on the surface with the imprint.
  std::vector<double> lowered(sequence.heights().begin(),
                              sequence.heights().end());
  const std::unique_ptr<SurfaceOperator> elasticity = block();
  const ContactSolution elastic =
      solve_contact(*elasticity, {lowered, 0.0, tolerance, 100}, load(0.05));
  EXPECT_NEAR(elastic.mean_gap - sequence.mean_imprint(), half.mean_gap,
              6.0 * tolerance);
}

// Pressures grow everywhere with the load, so that the way to a load does not
// matter.
TEST_F(Hardness, TheStateUnderFirstLoadDoesNotDependOnTheSteps) {
  const double hardness = 0.3;
  LoadSequence steps = path(hardness);
  ContactSolution last;
  for (const double pressure : {0.01, 0.02, 0.05, 0.1, 0.2})
    last = steps.solve(load(pressure));
  const ContactSolution direct = path(hardness).solve(load(0.2));

  EXPECT_NEAR(last.mean_gap, direct.mean_gap, 6.0 * tolerance);
  EXPECT_NEAR(last.mean_imprint, direct.mean_imprint, 6.0 * tolerance);
}

// The work of the load on the way up is stored or dissipated; on the way down
// the stored one comes back. The trapezoidal rule in 20 and 40 steps.
TEST_F(Hardness, WorkIsElasticEnergyAndPlasticDissipation) {
  const double hardness = 0.3, top = 0.15;
  std::vector<double> errors;
  for (const int n : {20, 40}) {
    LoadSequence sequence = path(hardness);
    double work = 0.0, last_load = 0.0, last_gap = 0.0, stored = 0.0,
           lost = 0.0;
    for (int step = 0; step <= n; ++step) {
      const double pressure = top * (0.05 + 0.95 * step / n);
      const ContactSolution found = sequence.solve(load(pressure));
      double energy = 0.0;
      for (std::size_t i = 0; i < found.pressure.size(); ++i)
        energy += 0.5 * found.pressure[i] * found.displacement[i];
      energy /= static_cast<double>(found.pressure.size());
      if (step > 0)
        work -= 0.5 * (pressure + last_load) * (found.mean_gap - last_gap);
      else
        stored = -energy, lost = -hardness * found.mean_imprint;
      EXPECT_GE(hardness * found.mean_imprint, lost);
      last_load = pressure;
      last_gap = found.mean_gap;
      if (step == n) {
        stored += energy;
        lost += hardness * found.mean_imprint;
        EXPECT_GT(lost, 0.2 * work);
      }
    }
    errors.push_back(work / (stored + lost) - 1.0);
  }
  EXPECT_LT(std::abs(errors[1]), 1e-3);
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.6);
}

TEST_F(Hardness, APathContinuesWithTheBitsOfOneRun) {
  const std::vector<double> loads{0.05, 0.1, 0.05, 0.02, 0.12};
  LoadSequence whole = path(0.3, 2);
  std::vector<ContactSolution> expected;
  expected.reserve(loads.size());
  for (const double pressure : loads)
    expected.push_back(whole.solve(load(pressure)));
  for (std::size_t stop = 1; stop < loads.size(); ++stop) {
    LoadSequence first = path(0.3);
    for (std::size_t i = 0; i < stop; ++i)
      first.solve(load(loads[i]));
    LoadSequence second = path(0.3);
    second.recall(first.memory());
    for (std::size_t i = stop; i < loads.size(); ++i) {
      const ContactSolution found = second.solve(load(loads[i]));
      EXPECT_EQ(found.pressure, expected[i].pressure) << stop << i;
      EXPECT_EQ(found.gap, expected[i].gap) << stop << i;
      EXPECT_EQ(found.mean_gap, expected[i].mean_gap) << stop << i;
      EXPECT_EQ(found.mean_imprint, expected[i].mean_imprint) << stop << i;
    }
  }
}

double potential(SurfaceOperator& elasticity,
                 const std::vector<double>& heights,
                 const std::vector<double>& pressure) {
  std::vector<double> displacement(heights.size());
  elasticity.displacement(pressure, displacement);
  double sum = 0.0;
  for (std::size_t i = 0; i < heights.size(); ++i)
    sum += pressure[i] * (0.5 * displacement[i] - heights[i]);
  return sum / static_cast<double>(heights.size());
}

/// A pressure within the bounds, of the same mean, with noise of a part of H.
std::vector<double> with_noise(const std::vector<double>& pressure,
                               double hardness, double amplitude) {
  std::vector<double> noisy = pressure;
  std::vector<double> noise = problems::random_field(noisy.size());
  for (std::size_t i = 0; i < noisy.size(); ++i)
    noisy[i] =
        std::clamp(noisy[i] + amplitude * hardness * noise[i], 0.0, hardness);
  return noisy;
}

// The bounds (1) and (3) of docs/numerics/hardness.md. With noise the mean
// pressure changes, which the certificate corrects; the exact answer is that at
// the mean of the noisy field.
TEST_F(Hardness, ACertificateEnclosesEnergyAndMeanGap) {
  const std::unique_ptr<SurfaceOperator> elasticity = block();
  for (const double hardness : {1.0, 0.2, 0.02})
    for (const double share : {0.05, 0.5, 0.95})
      for (const double amplitude : {0.0, 1e-4, 0.1}) {
        const ContactSolution first = solve_contact(
            *elasticity, problem(hardness), load(share * hardness));
        const std::vector<double> field =
            with_noise(first.pressure, hardness, amplitude);
        double mean = 0.0;
        for (const double own : field)
          mean += own / static_cast<double>(field.size());
        ContactProblem sharp = problem(hardness);
        sharp.gap_tolerance = 1e-11 * rms_height;
        const ContactSolution exact =
            solve_contact(*elasticity, sharp, load(mean), first.pressure);
        ASSERT_TRUE(exact.converged) << exact.note;

        const SubmittedField submitted{.heights = heights,
                                       .nominal_pressure = mean,
                                       .pressure = field,
                                       .hardness = hardness};
        const FieldCheck check = check_field(*elasticity, submitted);
        const SeparationBounds bounds =
            bound_separation(*elasticity, submitted);
        const double above = potential(*elasticity, heights, field) -
                             potential(*elasticity, heights, exact.pressure);
        const double allowed = 1e-10 * mean * rms_height;
        const std::string what = std::to_string(hardness) + " " +
                                 std::to_string(share) + " " +
                                 std::to_string(amplitude);
        EXPECT_LE(above, check.duality_gap + allowed) << what;
        EXPECT_GE(above, -allowed) << what;
        EXPECT_LE(std::abs(check.mean_gap - exact.mean_gap),
                  check.mean_gap_error + allowed)
            << what;
        EXPECT_LE(bounds.low, exact.mean_gap + 1e-10 * rms_height) << what;
        EXPECT_GE(bounds.high, exact.mean_gap - 1e-10 * rms_height) << what;
        EXPECT_LT(bounds.high - bounds.low, 1e-4 * rms_height) << what;
        if (amplitude == 0.0) {
          EXPECT_LT(check.duality_gap, 1e-6 * mean * rms_height) << what;
          EXPECT_LT(check.largest_penetration, 4.0 * tolerance) << what;
        }
      }
}

// The unpreconditioned method is for steps that stall.
TEST_F(Hardness, IsSolvedByTheReferenceMethod) {
  const std::unique_ptr<SurfaceOperator> elasticity = block();
  for (const double hardness : {1.0, 0.1}) {
    ContactProblem slow = problem(hardness);
    slow.max_iterations = 5000;
    const ContactSolution found =
        polonsky_keer(*elasticity, slow, load(0.3 * hardness));
    EXPECT_TRUE(found.converged) << found.note;
    EXPECT_LE(error_of(*elasticity, slow, found), 2.0 * tolerance);
  }
}

} // namespace asperity::contact::hardness_test
