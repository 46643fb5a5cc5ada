#pragma once

// The loops over nodes of the preconditioned iteration. They are compiled for
// the instructions of several processors and round in the same way on all of
// them. Products of single-precision fields are rounded to single precision,
// and so are the sums of four of them; all other sums are in double precision.

#include "base/maximum.hpp"
#include "contact/solvers/node_blocks.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace asperity::contact {

/// Changes of pressure that the iteration allows at a node.
enum Freedom : std::uint8_t {
  fixed = 0, ///< inactive: no pressure and no overlap, or the hardness and one
  gains = 1, ///< overlaps without pressure: the pressure may only grow
  loses = 2, ///< has a gap at the hardness: the pressure may only fall
  may_shift = gains | loses, ///< carries less than the hardness
};

/// The value where it is kept, otherwise 0: of its bits, because the compiler
/// makes no vectors of branches.
[[gnu::always_inline]] inline float masked(float value, bool is_kept) {
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(value) &
                              -std::int32_t{is_kept});
}

[[gnu::always_inline]] inline double masked(double value, bool is_kept) {
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(value) &
                               -std::int64_t{is_kept});
}

/// Value of a search direction at a node, restricted to the changes allowed:
/// `gains` allows negative values, `loses` positive ones.
[[gnu::always_inline]] inline float allowed(float value, std::int32_t freedom) {
  const auto bits = std::bit_cast<std::int32_t>(value);
  return std::bit_cast<float>(bits & ((-(freedom >> 1) & ~(bits >> 31)) |
                                      (-(freedom & 1) & bits >> 31)));
}

/// The fields of an iteration. Pointers that a loop does not use may be null.
struct NodeFields {
  const double* weight = nullptr; ///< relative areas; null if all are equal
  double* pressure = nullptr;     ///< p [Pa]
  double* raw_gap = nullptr;      ///< C p - h [m]
  float* residual = nullptr;      ///< gap + c p [m]
  const float* previous_residual = nullptr;
  std::uint8_t* freedom = nullptr;       ///< Freedom of each node
  const float* preconditioned = nullptr; ///< z [Pa]
  float* direction = nullptr;            ///< d [Pa]
  const float* displaced = nullptr;      ///< C d, or a change of C p [m]
  float* change = nullptr;               ///< of the pressure [Pa]
  const double* heights = nullptr;       ///< [m]
  std::uint8_t* active = nullptr;        ///< one flag per block
  double* lowest = nullptr; ///< lowest raw_gap [m] of each inactive block
  double compliance = 0.0;  ///< c [m/Pa]
  /// Power of two by which products of a pressure and a length are multiplied
  /// in single precision, so that they do not underflow [1/(Pa m)].
  float product_scale = 1.0F;
  /// H, the largest pressure [Pa].
  double hardness = std::numeric_limits<double>::infinity();
};

/// What is found when the residual changes.
struct MeasuredNodes {
  double error = 0.0;   ///< largest |residual|; NaN if a value is not finite
  double weight = 0.0;  ///< of the active nodes
  double changed = 0.0; ///< number of nodes that became active or inactive

  MeasuredNodes& operator+=(const MeasuredNodes& other) {
    error = maximum(error, other.error);
    weight += other.weight;
    changed += other.changed;
    return *this;
  }
};

/// Two sums over the same nodes.
using TwoSums = SeveralSums<2>;

/// Sets residual and freedom of the nodes of the active blocks, see
/// ContactState::update_residual, and finds out which blocks remain active.
/// @param rigid  u [m]
MeasuredNodes measure_nodes(const NodeFields& fields, const NodeRange& range,
                            double rigid);

/// raw_gap += factor displaced. Returns the sums of weight (raw_gap + c p) and
/// of weight where 0 < p < H, in the active blocks; `lowest` of the other
/// blocks is set, to minus infinity if a value is not finite.
TwoSums change_gap(const NodeFields& fields, const NodeRange& range,
                   double factor);

/// The same with raw_gap = C p - heights, where raw_gap contains C p before.
TwoSums subtract_heights(const NodeFields& fields, const NodeRange& range);

/// Sum of weight z over the active nodes.
Sum sum_free(const NodeFields& fields, const NodeRange& range);

/// Sums of weight z' r and weight z' (r - previous r), where z' is z - mean
/// restricted to the changes allowed.
TwoSums sum_slopes(const NodeFields& fields, const NodeRange& range,
                   float mean);

/// direction = z' + beta direction, restricted likewise; returns the sum of
/// weight direction r.
Sum conjugate_nodes(const NodeFields& fields, const NodeRange& range,
                    float mean, float beta);

/// Sum of weight d (C d + c d).
Sum sum_energy(const NodeFields& fields, const NodeRange& range);

/// A step along the search direction: wish = p - step d becomes the pressure
/// min(H, max(0, factor wish)), and p itself where d = 0.
struct Advance {
  double step = 0.0;   ///< [1]
  double factor = 1.0; ///< > 0
};

/// Sets p by `advance`, and `change` to the change of p. Returns the sum of
/// weight p and a number that is positive if a pressure is not the wish.
TwoSums advance_nodes(const NodeFields& fields, const NodeRange& range,
                      const Advance& advance);

/// What advance_nodes() would find.
struct AdvancedLoad {
  double load = 0.0, cut = 0.0; ///< its two sums
  double slope = 0.0;           ///< derivative of the first by the factor
  double largest = 0.0;         ///< of the pressures [Pa]

  AdvancedLoad& operator+=(const AdvancedLoad& other) {
    load += other.load;
    cut += other.cut;
    slope += other.slope;
    largest = maximum(largest, other.largest);
    return *this;
  }
};

AdvancedLoad sum_advanced(const NodeFields& fields, const NodeRange& range,
                          const Advance& advance);

/// Multiplies p and adds its change to `change`.
void scale_nodes(const NodeFields& fields, const NodeRange& range,
                 double factor);

} // namespace asperity::contact
