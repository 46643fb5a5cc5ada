#pragma once

// Conjugate gradients in double precision around a multigrid cycle in single
// precision.

#include "base/ranks/rank_sums.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace asperity::fem {

/// The outcome of a solution by conjugate gradients.
struct LinearSolution {
  bool has_converged = false;
  int iterations = 0;
  double first_residual = 0.0, last_residual = 0.0; ///< l2 norms [N]
};

/// The vectors of the iteration, kept between solutions, which take their
/// initial values but for the residual.
struct GradientVectors {
  std::vector<double> residual, direction, product;
  /// The ranks that share the unknowns, or null. Each has its own unknowns and
  /// copies of others, at which the residual is zero.
  RankGroup* ranks = nullptr;
};

/// Solves for `displacement`, starting from its values. The residual of `own`
/// is the force before and that of the solution afterwards.
/// @tparam Problem  has apply_all(displacement, force), which may overwrite
///                  dependent entries of the displacement; clear_held(vector),
///                  which sets unknowns to zero that are not solved for;
///                  cycle_force() and cycle_displacement(), vectors of float;
///                  and run_cycle(), which computes the second from the first
/// @param tolerance  of the l2 norm of the residual
template <class Problem>
LinearSolution conjugate_gradients(Problem& problem,
                                   std::vector<double>& displacement,
                                   double tolerance, int most_iterations,
                                   GradientVectors& own) {
  const auto inner = [&own](const auto& a, const auto& b) {
    return rank_sum(own.ranks,
                    std::inner_product(a.begin(), a.end(), b.begin(), 0.0));
  };
  LinearSolution solution;
  own.direction.assign(own.residual.size(), 0.0);
  problem.apply_all(displacement, own.product);
  for (std::size_t i = 0; i < own.residual.size(); ++i)
    own.residual[i] -= own.product[i];
  problem.clear_held(own.residual);
  double norm = std::sqrt(inner(own.residual, own.residual));
  solution.first_residual = norm;
  double before = 1.0;
  while (norm > tolerance && solution.iterations < most_iterations) {
    ++solution.iterations;
    // The cycle acts on the residual over its norm, which fits into a float.
    std::vector<float>& scaled = problem.cycle_force();
    for (std::size_t i = 0; i < scaled.size(); ++i)
      scaled[i] = static_cast<float>(own.residual[i] / norm);
    problem.run_cycle();
    const std::vector<float>& result = problem.cycle_displacement();
    double product = 0.0;
    for (std::size_t i = 0; i < result.size(); ++i)
      product += own.residual[i] * static_cast<double>(result[i]);
    product = norm * rank_sum(own.ranks, product);
    const double kept = solution.iterations == 1 ? 0.0 : product / before;
    before = product;
    for (std::size_t i = 0; i < result.size(); ++i)
      own.direction[i] =
          norm * static_cast<double>(result[i]) + kept * own.direction[i];
    problem.clear_held(own.direction);
    problem.apply_all(own.direction, own.product);
    const double step = product / inner(own.direction, own.product);
    if (!(step > 0.0) || !std::isfinite(step))
      break;
    double square = 0.0;
    for (std::size_t i = 0; i < result.size(); ++i) {
      displacement[i] += step * own.direction[i];
      own.residual[i] -= step * own.product[i];
      square += own.residual[i] * own.residual[i];
    }
    norm = std::sqrt(rank_sum(own.ranks, square));
  }
  solution.last_residual = norm;
  solution.has_converged = norm <= tolerance;
  return solution;
}

} // namespace asperity::fem
