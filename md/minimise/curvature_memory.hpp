#pragma once

// What the last steps of a minimisation taught about the second derivatives.
// Owns the limited-memory update of Broyden, Fletcher, Goldfarb and Shanno.

#include <cstddef>
#include <span>
#include <vector>

namespace asperity::md {

/// The last pairs (s, y) of step and fall of the forces along it. With H_0 the
/// caller's inverse of the second derivatives, the direction H forces is made
/// in three calls: remaining(), H_0 of what is left, complete(). Everything the
/// two-loop recursion needs of the pairs is their products, so each call goes
/// through the memory once or twice. Pairs are kept in single precision: any
/// pairs with s.y > 0 make H positive definite, and H is an estimate anyway.
/// @see  J. Nocedal, Math. Comp. 35, 773 (1980)
class CurvatureMemory {
public:
  /// @param pairs  >= 0 that are kept; 0 leaves H = H_0
  CurvatureMemory(std::size_t unknowns, int pairs);

  void clear() { kept_.clear(); }

  std::size_t size() const { return kept_.size(); }

  /// Learns from the step `length` direction, the forces before and after it.
  /// A pair without positive curvature is not kept.
  void learn(std::span<const double> direction, double length,
             std::span<const double> before, std::span<const double> after);

  /// rest = forces - sum of alpha_i y_i; keeps the alpha_i for complete().
  void remaining(std::span<const double> forces, std::span<double> rest);

  /// Turns direction = H_0 rest into H forces.
  void complete(std::span<double> direction) const;

private:
  struct Pair {
    std::vector<float> step;      ///< s
    std::vector<float> fall;      ///< y, forces before less forces after
    std::vector<double> products; ///< s . y of every slot
    double weight = 0.0;          ///< alpha
  };

  std::size_t free_slot();
  std::vector<const float*> columns(std::vector<float> Pair::*which) const;

  std::size_t unknowns_ = 0;
  std::vector<Pair> slots_;
  std::vector<std::size_t> kept_; ///< slots, oldest first
};

} // namespace asperity::md
