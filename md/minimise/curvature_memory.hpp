#pragma once

// The limited-memory BFGS approximation of the inverse second derivatives,
// built from the last steps of a minimisation.

#include <cstddef>
#include <span>
#include <vector>

namespace asperity::md {

/// Stores the last pairs (s, y) of a step and the resulting decrease of the
/// forces. With H_0 the caller's approximate inverse of the second derivatives,
/// the search direction H forces is computed in three stages: remaining(),
/// application of H_0 to its result, and complete(). The two-loop recursion
/// needs only the inner products of the pairs, so each call passes through the
/// memory once or twice. Pairs are stored in single precision, which is
/// sufficient because any pairs with s.y > 0 make H positive definite and H is
/// an approximation anyway.
/// @see  J. Nocedal, Math. Comp. 35, 773 (1980)
class CurvatureMemory {
public:
  /// @param pairs  number of pairs stored, >= 0; with 0, H = H_0
  CurvatureMemory(std::size_t unknowns, int pairs);

  void clear() { kept_.clear(); }

  std::size_t size() const { return kept_.size(); }

  /// Adds the pair of the step `length` direction, given the forces before and
  /// after it. A pair without positive curvature is rejected.
  void learn(std::span<const double> direction, double length,
             std::span<const double> before, std::span<const double> after);

  /// Computes rest = forces - sum of alpha_i y_i and stores the alpha_i for
  /// complete().
  void remaining(std::span<const double> forces, std::span<double> rest);

  /// Transforms direction = H_0 rest into H forces.
  void complete(std::span<double> direction) const;

private:
  struct Pair {
    std::vector<float> step;      ///< s
    std::vector<float> fall;      ///< y, forces before minus forces after
    std::vector<double> products; ///< s . y for the y of every slot
    double weight = 0.0;          ///< alpha
  };

  std::size_t free_slot();
  std::vector<const float*> columns(std::vector<float> Pair::*which) const;

  std::size_t unknowns_ = 0;
  std::vector<Pair> slots_;
  std::vector<std::size_t> kept_; ///< slots, oldest first
};

} // namespace asperity::md
