#pragma once

// The smoother of the multigrid cycles: Chebyshev's polynomial of the fourth
// kind with the diagonal of the matrix.

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "ranks/rank_sums.hpp"

namespace asperity::fem {

/// The largest eigenvalue of D^-1 K by the power method, made larger by its
/// possible error.
/// @param vector    random; zero at unknowns that are not solved for
/// @param diagonal  D; zero at unknowns that are not solved for
/// @param apply     computes a vector K x from a vector x, both of float
/// @param ranks     share the unknowns; null for this process alone
template <class Apply>
double eigenvalue_from(std::vector<float> vector,
                       const std::vector<float>& diagonal, const Apply& apply,
                       RankGroup* ranks = nullptr) {
  constexpr int steps = 25;
  constexpr double margin = 1.15;
  std::vector<float> image(diagonal.size());
  double estimate = 0.0;
  for (int step = 0; step < steps; ++step) {
    apply(vector.data(), image.data());
    double above = 0.0, below = 0.0;
    for (std::size_t i = 0; i < vector.size(); ++i)
      if (diagonal[i] > 0.0F) {
        const float before = vector[i];
        vector[i] = image[i] / diagonal[i];
        above += static_cast<double>(image[i] * vector[i]);
        below += static_cast<double>(before * image[i]);
      }
    above = rank_sum(ranks, above);
    estimate = above / rank_sum(ranks, below);
    const auto scale = static_cast<float>(1.0 / std::sqrt(above));
    for (float& value : vector)
      value *= scale;
  }
  return margin * estimate;
}

/// The same from a vector of its own.
template <class Apply>
double eigenvalue_estimate(const std::vector<float>& diagonal,
                           const Apply& apply, RankGroup* ranks = nullptr) {
  std::mt19937 engine(1);
  std::vector<float> vector(diagonal.size(), 0.0F);
  for (std::size_t i = 0; i < vector.size(); ++i)
    if (diagonal[i] > 0.0F)
      vector[i] = static_cast<float>(engine()) * 0x1p-32F - 0.5F;
  return eigenvalue_from(std::move(vector), diagonal, apply, ranks);
}

/// The vectors that are smoothed. The residual must be that of the
/// displacement.
struct SmoothedVectors {
  std::vector<float> displacement, residual, direction;
};

/// Smooths with `terms` terms of the polynomial.
/// @param inverse  1 / (largest eigenvalue times diagonal); zero at unknowns
///                 that are not solved for
/// @param subtract subtracts K direction from the residual
/// @param is_last  whether the residual of the result is not needed
template <class Subtract>
void smooth_by_chebyshev(SmoothedVectors& own,
                         const std::vector<float>& inverse, int terms,
                         bool is_last, const Subtract& subtract) {
  for (int term = 1; term <= terms; ++term) {
    const float kept = term == 1 ? 0.0F
                                 : static_cast<float>(2 * term - 3) /
                                       static_cast<float>(2 * term + 1);
    const float added =
        static_cast<float>(8 * term - 4) / static_cast<float>(2 * term + 1);
    for (std::size_t i = 0; i < inverse.size(); ++i) {
      own.direction[i] =
          kept * own.direction[i] + added * inverse[i] * own.residual[i];
      own.displacement[i] += own.direction[i];
    }
    if (!is_last || term < terms)
      subtract();
  }
}

} // namespace asperity::fem
