// Verifies that every solution of a contact problem, however extreme its
// numbers, either is converged and passes an independent check, or is reported
// as not converged with a reason. Only arguments outside their range are
// refused. The instances have units from picometres and millipascals to
// megametres and terapascals, flat, spiked and huge heights, numbers that are
// not finite, loads up to 10 E*, grids from one node on, and one to three
// threads. ASPERITY_INSTANCES sets their number.
#include "base/special_numbers.hpp"
#include "contact/solvers/active_set.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "tests/contact/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>

namespace asperity::contact::hostile_instances_test {

using Kind = mechanics::Control;

using Solve = ContactSolution (*)(SurfaceOperator&, const ContactProblem&,
                                  const mechanics::LoadTarget&,
                                  std::span<const double>);
constexpr std::array solvers{solve_contact, solve_contact, active_set,
                             polonsky_keer, solve_augmented};

struct Instance {
  Grid grid;
  mechanics::ElasticBlock block;
  int threads = 1;
  std::vector<double> heights;
  std::vector<double> start;
  double local_compliance = 0.0;
  double gap_tolerance = 0.0;
  int max_iterations = 1000;
  mechanics::LoadTarget target;
  Solve solve = solve_contact;
  bool may_be_refused = false; ///< an argument is outside its range

  ContactProblem problem() const {
    return {heights, local_compliance, gap_tolerance, max_iterations};
  }
};

/// Draws the parts of a problem instance at random.
class Dice {
public:
  explicit Dice(unsigned number) : random_(number) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  double power_of_ten(double low, double high) {
    return std::pow(10.0, uniform(low, high));
  }

  bool is_one_in(int n) { return pick(n) == 0; }

  int pick(int n) {
    return std::uniform_int_distribution<int>(0, n - 1)(random_);
  }

private:
  std::mt19937_64 random_;
};

/// Heights of order one, of one of several kinds.
std::vector<double> heights_of(const Grid& grid, Dice& dice) {
  const int kind = dice.pick(7);
  std::vector<double> heights(grid.size(), kind == 0 ? 0.0 : 1.0);
  if (kind == 2) // a spike
    heights[static_cast<std::size_t>(
        dice.pick(static_cast<int>(heights.size())))] = 3.0;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      double& height = heights[grid.index(ix, iy)];
      if (kind == 3) // many equal heights
        height = (ix + iy) % 2;
      if (kind == 4) // a long wave
        height = std::cos(2.0 * std::numbers::pi * ix / grid.points_x);
      if (kind == 5)
        height = dice.uniform(-1.0, 1.0);
      if (kind == 6) // a large offset from 0
        height = 1e5 + dice.uniform(-1.0, 1.0);
    }
  return heights;
}

mechanics::ElasticBlock block_of(const Grid& grid, double modulus, Dice& dice) {
  mechanics::ElasticBlock block{modulus, dice.uniform(0.0, 0.5), infinity,
                                mechanics::FarBoundary::clamped};
  if (dice.is_one_in(2)) {
    block.far_boundary =
        std::array{mechanics::FarBoundary::clamped,
                   mechanics::FarBoundary::sliding,
                   mechanics::FarBoundary::pressure}[static_cast<std::size_t>(
            dice.pick(3))];
    block.thickness = grid.length_x * dice.power_of_ten(-1.7, 0.5);
  }
  return block;
}

/// Puts a number that is not finite, or a scale that overflows, at a random
/// place.
void make_invalid(Instance& instance, Dice& dice) {
  const double bad =
      std::array{not_a_number, infinity, -infinity, 1e300, -1e300, 1e-310}
          [static_cast<std::size_t>(dice.pick(6))];
  std::vector<double>& field =
      dice.is_one_in(2) ? instance.heights : instance.start;
  if (field.empty())
    field.assign(instance.grid.size(), 0.0);
  if (dice.is_one_in(2))
    std::fill(field.begin(), field.end(), bad);
  else
    field[static_cast<std::size_t>(dice.pick(static_cast<int>(field.size())))] =
        bad;
  instance.may_be_refused = true;
}

Instance instance_number(unsigned number) {
  Dice dice(number);
  constexpr std::array sizes{1, 2, 3, 4, 5, 8, 12, 16, 24};
  const auto size = [&] {
    return sizes[static_cast<std::size_t>(dice.pick(9))];
  };
  Instance instance;
  const double length = dice.power_of_ten(-12.0, 6.0);
  const double modulus = dice.power_of_ten(-3.0, 13.0);
  const int points_x = size();
  const int points_y = size();
  instance.grid = {points_x, points_y, length, length * points_y / points_x};
  instance.block = block_of(instance.grid, modulus, dice);
  instance.threads = 1 + dice.pick(3);
  const double amplitude =
      instance.grid.spacing_x() * dice.power_of_ten(-6.0, 1.0);
  instance.heights = heights_of(instance.grid, dice);
  for (double& height : instance.heights)
    height *= amplitude;
  instance.gap_tolerance = amplitude * dice.power_of_ten(-12.0, -4.0);
  if (dice.is_one_in(2))
    instance.local_compliance =
        instance.grid.spacing_x() / modulus * dice.power_of_ten(-8.0, 4.0);
  instance.target = {Kind::nominal_pressure,
                     modulus * dice.power_of_ten(-12.0, 1.0)};
  if (dice.is_one_in(3))
    instance.target = {Kind::mean_gap,
                       amplitude * dice.power_of_ten(-6.0, 1.0)};
  instance.solve = solvers[static_cast<std::size_t>(dice.pick(5))];
  if (instance.solve == solve_augmented && instance.local_compliance == 0.0)
    instance.local_compliance = instance.grid.spacing_x() / modulus;
  if (dice.is_one_in(4)) {
    instance.start.resize(instance.grid.size());
    for (double& pressure : instance.start)
      pressure = modulus * std::max(0.0, dice.uniform(-1.0, 1.0));
    const bool has_load =
        *std::max_element(instance.start.begin(), instance.start.end()) > 0.0;
    instance.may_be_refused = !has_load;
  }
  if (dice.is_one_in(10))
    instance.max_iterations = 1 + dice.pick(5);
  if (dice.is_one_in(6))
    make_invalid(instance, dice);
  return instance;
}

/// Roundoff error of a gap [m].
double gap_rounding(const Instance& instance, const ContactSolution& answer) {
  const EvenColumn compliance =
      compliance_column(instance.grid, instance.block);
  double softest = 0.0;
  std::vector<double> column(
      static_cast<std::size_t>(instance.grid.points_y) / 2 + 1);
  for (int jx = 0; jx <= instance.grid.points_x / 2; ++jx) {
    compliance(jx, column);
    softest = std::max(softest, std::ranges::max(column));
  }
  return 64.0 * std::numeric_limits<double>::epsilon() *
         (2.0 * largest_magnitude(instance.heights) +
          largest_magnitude(answer.gap) +
          largest_magnitude(answer.pressure) *
              (softest + instance.local_compliance));
}

void expect_verified(const Instance& instance, FourierOperator& elasticity,
                     const ContactSolution& answer) {
  ContactProblem problem = instance.problem();
  if (instance.solve == solve_augmented)
    problem.local_compliance = 0.0;
  const double rounding = gap_rounding(instance, answer);
  EXPECT_LE(problems::complementarity_error(elasticity, problem, answer),
            1.01 * instance.gap_tolerance + rounding);
  EXPECT_LE(answer.gap_error, instance.gap_tolerance + rounding);
  if (instance.target.control == Kind::nominal_pressure)
    EXPECT_NEAR(answer.nominal_pressure / instance.target.amount, 1.0, 1e-12);
  else
    EXPECT_NEAR(answer.mean_gap, instance.target.amount,
                instance.gap_tolerance + rounding);
}

/// Verifies the solution and returns the outcome of the instance.
std::string outcome_of(const Instance& instance) {
  FourierOperator elasticity =
      halfspace_operator(instance.grid, instance.block, instance.threads);
  try {
    const ContactSolution answer = instance.solve(
        elasticity, instance.problem(), instance.target, instance.start);
    if (answer.converged) {
      expect_verified(instance, elasticity, answer);
      return answer.note.empty() ? "verified" : "verified, with a note";
    }
    EXPECT_FALSE(answer.note.empty());
    if (answer.note.find("not finite") != std::string::npos)
      return "not converged: not finite";
    return instance.max_iterations < 10 ? "not converged: few iterations"
                                        : "not converged";
  } catch (const std::domain_error& error) {
    EXPECT_TRUE(instance.may_be_refused) << error.what();
    return "refused";
  }
}

TEST(HostileInstances, AreVerifiedOrStateTheReason) {
  const char* const requested = std::getenv("ASPERITY_INSTANCES");
  const unsigned n_instances =
      requested ? static_cast<unsigned>(std::atoi(requested)) : 3000;
  std::map<std::string, int> outcomes;
  for (unsigned number = 1; number <= n_instances; ++number) {
    SCOPED_TRACE(number);
    ++outcomes[outcome_of(instance_number(number))];
  }
  for (const auto& [outcome, count] : outcomes)
    RecordProperty(outcome, count);
  for (const auto& [outcome, count] : outcomes)
    std::printf("%6d %s\n", count, outcome.c_str());
  EXPECT_GT(outcomes["verified"], static_cast<int>(n_instances / 2));
}

} // namespace asperity::contact::hostile_instances_test
