// Tests of md/minimise/curvature_memory.hpp: three calls form the product with
// the inverse that the matrix formula of the update defines.
#include "md/minimise/curvature_memory.hpp"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace asperity::md::curvature_memory_test {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

constexpr Eigen::Index unknowns = 2100; // more than one block of the cache

/// Whole numbers, which single precision represents exactly.
Vector random_vector(std::mt19937& generator) {
  std::uniform_int_distribution<int> uniform(-9, 9);
  Vector vector(unknowns);
  for (double& value : vector)
    value = uniform(generator);
  return vector;
}

std::span<const double> view(const Vector& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}

std::span<double> view(Vector& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}

/// H forces by H <- (1 - s y'/s.y) H (1 - y s'/s.y) + s s'/s.y, newest first.
Vector updated(const std::vector<Vector>& steps,
               const std::vector<Vector>& falls, std::size_t count,
               const Vector& forces) {
  if (count == 0)
    return 0.5 * forces; // H_0
  const Vector& s = steps[count - 1];
  const Vector& y = falls[count - 1];
  const double weight = s.dot(forces) / s.dot(y);
  const Vector inner = updated(steps, falls, count - 1, forces - weight * y);
  return inner + (weight - y.dot(inner) / s.dot(y)) * s;
}

class ManySteps : public ::testing::TestWithParam<int> {};

// Any number of steps with a memory of four equals the formula with the last
// four. Tolerance: roundoff of sums of 2100 terms, amplified by the recursion.
TEST_P(ManySteps, AreCombinedByTheFormula) {
  std::mt19937 generator(11);
  CurvatureMemory memory(unknowns, 4);
  std::vector<Vector> steps;
  std::vector<Vector> falls;
  for (int k = 0; k < GetParam(); ++k) {
    const Vector step = random_vector(generator);
    const Vector before = random_vector(generator);
    const Vector after = before - 3.0 * step - random_vector(generator);
    memory.learn(view(step), 2.0, view(before), view(after));
    steps.push_back(2.0 * step);
    falls.push_back(before - after);
  }
  const std::size_t old = steps.size() > 4 ? steps.size() - 4 : 0;
  steps.erase(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(old));
  falls.erase(falls.begin(), falls.begin() + static_cast<std::ptrdiff_t>(old));
  const Vector forces = random_vector(generator);
  Vector direction(unknowns);

  memory.remaining(view(forces), view(direction));
  direction *= 0.5; // H_0
  memory.complete(view(direction));

  const Vector expected = updated(steps, falls, steps.size(), forces);
  EXPECT_LT((direction - expected).norm() / expected.norm(), 1e-12);
  EXPECT_EQ(memory.size(), steps.size());
}

INSTANTIATE_TEST_SUITE_P(Counts, ManySteps,
                         ::testing::Values(0, 1, 2, 4, 5, 7, 11));

TEST(CurvatureMemory, RefusesPairsOfNegativeCurvature) {
  std::mt19937 generator(12);
  CurvatureMemory memory(unknowns, 4);
  const Vector step = random_vector(generator);
  const Vector before = random_vector(generator);

  memory.learn(view(step), 1.0, view(before), view(Vector(before + step)));
  EXPECT_EQ(memory.size(), 0U);
  memory.learn(view(step), 1.0, view(before), view(Vector(before - step)));
  EXPECT_EQ(memory.size(), 1U);
  memory.clear();
  EXPECT_EQ(memory.size(), 0U);
}

TEST(CurvatureMemory, WithoutPairsIsTheInverseOfTheCaller) {
  std::mt19937 generator(13);
  CurvatureMemory memory(unknowns, 0);
  const Vector step = random_vector(generator);
  const Vector forces = random_vector(generator);
  Vector direction(unknowns);

  memory.learn(view(step), 1.0, view(forces), view(Vector(forces - step)));
  memory.remaining(view(forces), view(direction));
  memory.complete(view(direction));

  EXPECT_EQ(direction, forces);
}

} // namespace asperity::md::curvature_memory_test
