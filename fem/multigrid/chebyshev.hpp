#pragma once

// The smoother of the multigrid cycles: Chebyshev's polynomial of the fourth
// kind with the diagonal of the matrix.

#include "base/ranks/rank_sums.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

namespace asperity::fem {

/// The largest eigenvalue of the symmetric tridiagonal matrix of which these
/// are the diagonal and the squares of the entries beside it, by bisection.
inline double largest_eigenvalue(const std::vector<double>& diagonal,
                                 const std::vector<double>& squares) {
  double above = 0.0;
  for (std::size_t i = 0; i < diagonal.size(); ++i)
    above = std::max(above,
                     diagonal[i] + (i > 0 ? std::sqrt(squares[i - 1]) : 0.0) +
                         (i < squares.size() ? std::sqrt(squares[i]) : 0.0));
  // The pivots of x - T are positive above the largest eigenvalue.
  const auto is_above = [&](double x) {
    double pivot = 1.0;
    for (std::size_t i = 0; i < diagonal.size() && pivot > 0.0; ++i)
      pivot = x - diagonal[i] - (i > 0 ? squares[i - 1] / pivot : 0.0);
    return pivot > 0.0;
  };
  double below = 0.0;
  constexpr int halvings = 30;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (below + above);
    (is_above(middle) ? above : below) = middle;
  }
  return above;
}

/// A random vector, zero where D is: that of one process if the unknowns of the
/// ranks follow each other. Collective.
inline std::vector<float> random_vector_of(const std::vector<float>& diagonal,
                                           RankGroup* ranks) {
  const auto own = static_cast<double>(std::count_if(
      diagonal.begin(), diagonal.end(), [](float d) { return d > 0.0F; }));
  const std::vector<double> all = of_ranks(ranks, own);
  const int rank = ranks == nullptr ? 0 : ranks->rank();
  std::mt19937 engine(1);
  engine.discard(static_cast<unsigned long long>(
      std::accumulate(all.begin(), all.begin() + rank, 0.0)));
  std::vector<float> vector(diagonal.size(), 0.0F);
  for (std::size_t i = 0; i < vector.size(); ++i)
    if (diagonal[i] > 0.0F)
      vector[i] = static_cast<float>(engine()) * 0x1p-32F - 0.5F;
  return vector;
}

/// The largest eigenvalue of D^-1 K by the method of Lanczos in the product of
/// D, made larger by its possible error.
/// @param diagonal  D; zero at unknowns that are not solved for
/// @param apply     computes a vector K x from a vector x, both of float; it
///                  may overwrite entries of x where D is zero
/// @param ranks     share the unknowns; null for this process alone
template <class Apply>
double eigenvalue_estimate(const std::vector<float>& diagonal,
                           const Apply& apply, RankGroup* ranks = nullptr) {
  constexpr int steps = 12;
  constexpr double margin = 1.1;
  const std::size_t size = diagonal.size();
  std::vector<float> vector = random_vector_of(diagonal, ranks);
  std::vector<float> before(size, 0.0F), image(size);
  std::vector<double> alphas, squares; // of the tridiagonal matrix
  double square = 0.0;
  for (std::size_t i = 0; i < size; ++i)
    square += static_cast<double>(diagonal[i] * vector[i] * vector[i]);
  square = rank_sum(ranks, square);
  for (int step = 0; step < steps && square > 0.0; ++step) {
    const auto scale = static_cast<float>(1.0 / std::sqrt(square));
    for (std::size_t i = 0; i < size; ++i)
      vector[i] *= scale;
    apply(vector.data(), image.data());
    double product = 0.0;
    for (std::size_t i = 0; i < size; ++i)
      if (diagonal[i] > 0.0F)
        product += static_cast<double>(vector[i] * image[i]);
    alphas.push_back(rank_sum(ranks, product));
    const auto alpha = static_cast<float>(alphas.back());
    const auto beta =
        static_cast<float>(step > 0 ? std::sqrt(squares.back()) : 0.0);
    square = 0.0;
    for (std::size_t i = 0; i < size; ++i)
      if (diagonal[i] > 0.0F) {
        const float next =
            image[i] / diagonal[i] - alpha * vector[i] - beta * before[i];
        before[i] = vector[i];
        vector[i] = next;
        square += static_cast<double>(diagonal[i] * next * next);
      }
    square = rank_sum(ranks, square);
    squares.push_back(square);
  }
  if (!squares.empty())
    squares.pop_back();
  return margin * largest_eigenvalue(alphas, squares);
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
