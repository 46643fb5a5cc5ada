#pragma once

// The loops over nodes of the preconditioned iteration. They are compiled for
// the instructions of several processors and round in the same way on all of
// them. Products of single-precision fields are rounded to single precision,
// and so are the sums of four of them; all other sums are in double precision.

#include "base/maximum.hpp"
#include "contact/solvers/node_blocks.hpp"

#include <cstddef>
#include <cstdint>

namespace asperity::contact {

/// The fields of an iteration at adjacent nodes, the first of which begins a
/// block. Pointers that a loop does not use may be null.
struct NodeFields {
  std::size_t nodes = 0;
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
  /// Power of two by which products of a pressure and a length are multiplied
  /// in single precision, so that they do not underflow [1/(Pa m)].
  float product_scale = 1.0F;

  /// The same fields from node `begin` on.
  NodeFields at(std::size_t begin, std::size_t end) const;
};

/// Two sums over the same nodes.
struct TwoSums {
  double first = 0.0, second = 0.0;

  TwoSums& operator+=(const TwoSums& other) {
    first += other.first;
    second += other.second;
    return *this;
  }
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

/// Sets residual and freedom of the nodes of the active blocks, see
/// ContactState::update_residual, and finds out which blocks remain active.
/// @param rigid       u [m]
/// @param compliance  c [m/Pa]
/// @param active      one flag per block
MeasuredNodes measure_nodes(const NodeFields& fields, double rigid,
                            double compliance, std::uint8_t* active);

/// raw_gap += factor displaced. Returns the sums of weight (raw_gap + c p) and
/// of weight where p > 0, in the active blocks.
/// @param active  one flag per block
/// @param lowest  lowest raw_gap [m] of each block that is not active,
///                overwritten; minus infinity if a value is not finite
TwoSums change_gap(const NodeFields& fields, double factor, double compliance,
                   const std::uint8_t* active, double* lowest);

/// The same with raw_gap = C p - heights, where raw_gap contains C p before.
TwoSums subtract_heights(const NodeFields& fields, double compliance,
                         const std::uint8_t* active, double* lowest);

/// Sum of weight z over the active nodes.
double sum_free(const NodeFields& fields);

/// Sums of weight z' r and weight z' (r - previous r), where z' is z - mean
/// restricted to the changes allowed.
TwoSums sum_slopes(const NodeFields& fields, float mean);

/// direction = z' + beta direction, restricted likewise; returns the sum of
/// weight direction r.
double conjugate_nodes(const NodeFields& fields, float mean, float beta);

/// Sum of weight d (C d + c d).
double sum_energy(const NodeFields& fields, double compliance);

/// Sets p = max(0, p - step d) and `change` to the change of p. Returns the sum
/// of weight p and a number that is positive if a pressure was set to 0.
TwoSums advance_nodes(const NodeFields& fields, double step);

/// Multiplies p and adds its change to `change`.
void scale_nodes(const NodeFields& fields, double factor);

} // namespace asperity::contact
