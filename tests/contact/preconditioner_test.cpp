// Tests of contact/solvers/preconditioner.hpp: the map is symmetric and
// positive on the active nodes, and close to the inverse of C there, for
// periodic and free boundaries.
#include "contact/operators/free_halfspace.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/solvers/preconditioner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace asperity::contact::preconditioner_test {

/// The preconditioner on an active set of random discs and half of the border.
class PreconditionerOf : public testing::TestWithParam<bool> {
protected:
  PreconditionerOf() {
    if (GetParam())
      elasticity_ = std::make_unique<FreeHalfspace>(grid_, 1.0);
    else
      elasticity_ = std::make_unique<FourierOperator>(
          halfspace_operator(grid_,
                             {1.0, 0.0, std::numeric_limits<double>::infinity(),
                              mechanics::FarBoundary::pressure},
                             1));
    for (int iy = 0; iy < grid_.points_y; ++iy)
      for (int ix = 0; ix < grid_.points_x; ++ix) {
        const double wave = std::cos(0.31 * ix) + std::cos(0.23 * iy);
        freedom_[grid_.index(ix, iy)] = wave > 0.3 ? 2 : 0;
      }
    // The residual of inactive blocks is 0 and they are skipped.
    for (std::size_t i = 0; i < grid_.size(); ++i)
      if (freedom_[i] > 0)
        blocks_[i / block_nodes] = 1;
    preconditioner_ = std::make_unique<Preconditioner>(*elasticity_);
    preconditioner_->build(*elasticity_, 0.0, {freedom_, blocks_});
  }

  std::vector<float> random_residual() {
    std::uniform_real_distribution<float> value(-1.0F, 1.0F);
    std::vector<float> residual(grid_.size());
    for (std::size_t i = 0; i < residual.size(); ++i)
      residual[i] = freedom_[i] > 0 ? value(random_) : 0.0F;
    return residual;
  }

  /// z, 0 at the inactive nodes
  std::vector<float> applied_to(const std::vector<float>& residual) {
    std::vector<float> scratch(grid_.size()), z(grid_.size());
    preconditioner_->apply(*elasticity_, 0.0, {freedom_, blocks_}, residual,
                           scratch, z);
    for (std::size_t i = 0; i < z.size(); ++i)
      z[i] = freedom_[i] > 0 ? z[i] : 0.0F;
    return z;
  }

  /// Removes the mean over the active nodes.
  void remove_mean(std::vector<float>& field) {
    double sum = 0.0, n_active = 0.0;
    for (std::size_t i = 0; i < field.size(); ++i) {
      sum += static_cast<double>(field[i]);
      n_active += freedom_[i] > 0 ? 1.0 : 0.0;
    }
    for (std::size_t i = 0; i < field.size(); ++i)
      field[i] -= freedom_[i] > 0 ? static_cast<float>(sum / n_active) : 0.0F;
  }

  static double dot(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return sum;
  }

  const Grid grid_{90, 75, 1.2, 1.0};
  std::unique_ptr<SurfaceOperator> elasticity_;
  std::vector<std::uint8_t> freedom_ =
      std::vector<std::uint8_t>(grid_.size(), 0);
  BlockFlags blocks_ = BlockFlags(blocks_of(grid_.size()), 0);
  std::unique_ptr<Preconditioner> preconditioner_;
  std::mt19937_64 random_{3};
};

// Claim: z = E^T K E r with a symmetric, positive K. Tolerance: single
// precision.
TEST_P(PreconditionerOf, IsSymmetricAndPositive) {
  const std::vector<float> a = random_residual();
  const std::vector<float> b = random_residual();
  const std::vector<float> of_a = applied_to(a);
  const std::vector<float> of_b = applied_to(b);
  EXPECT_GT(dot(a, of_a), 0.0);
  EXPECT_NEAR(dot(a, of_b), dot(b, of_a),
              1e-5 * std::sqrt(dot(a, of_a) * dot(b, of_b)));
}

// Claim: the largest eigenvalue of P C, found by power iteration on pressures
// without mean, is small; the smallest one is 1, because E is the identity on
// the active nodes. Measured: 1.32 periodic, 1.61 with free boundaries, where
// it is 2.07 if the border is continued periodically. Margin: a tenth.
TEST_P(PreconditionerOf, IsCloseToTheInverse) {
  std::vector<float> pressure = random_residual();
  double ratio = 0.0;
  for (int i = 0; i < 30; ++i) {
    remove_mean(pressure);
    const double size = std::sqrt(dot(pressure, pressure));
    for (float& value : pressure)
      value /= static_cast<float>(size);
    std::vector<float> residual(grid_.size());
    elasticity_->displacement_change(pressure, residual);
    for (std::size_t node = 0; node < residual.size(); ++node)
      residual[node] = freedom_[node] > 0 ? residual[node] : 0.0F;
    std::vector<float> next = applied_to(residual);
    ratio = dot(residual, next) / dot(pressure, residual);
    pressure = std::move(next);
  }
  printf("RATIO %g\n", ratio);
  EXPECT_GT(ratio, 1.0);
  EXPECT_LT(ratio, GetParam() ? 1.77 : 1.45);
}

INSTANTIATE_TEST_SUITE_P(Boundaries, PreconditionerOf, testing::Bool(),
                         [](const auto& instance) {
                           return instance.param ? "free" : "periodic";
                         });

} // namespace asperity::contact::preconditioner_test
