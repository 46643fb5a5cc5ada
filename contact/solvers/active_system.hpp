#pragma once

// Solves the linear problem of a fixed set of nodes in contact, by dense
// factorisation of the smaller of two matrices.

#include "base/ranks/node_weights.hpp"
#include "contact/operators/surface_operator.hpp"

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asperity::contact {

/// Order of the largest matrix that is factorised; it takes 34 MB. A grid of
/// 64^2 nodes is always within this limit.
inline constexpr std::size_t most_active_nodes = 2048;

/// Why the system of a set of nodes is not solved: it exceeds most_active_nodes
/// or the memory of its columns. Empty if it is solved.
/// @param n_free, n_nodes  active nodes, all nodes
std::string refusal_of_system(const SurfaceOperator& elasticity,
                              std::size_t n_free, std::size_t n_nodes);

/// Entries of a linear operator on the contact surface. Each column is computed
/// when it is first needed and then kept. A translation-invariant operator has
/// a single one.
class Columns {
public:
  /// Writes the column of the operator for a unit value at a node.
  using Take = std::function<void(std::span<const double> unit,
                                  std::span<double> column)>;

  Columns(const SurfaceOperator& elasticity, Take take)
      : grid_(elasticity.grid()),
        take_(std::move(take)),
        columns_(elasticity.is_shift_invariant() ? 1 : grid_.size()) {}

  /// Value at `node` that results from a unit value at `other`.
  double between(std::size_t node, std::size_t other);

private:
  Grid grid_;
  Take take_;
  std::vector<std::vector<double>> columns_;
};

/// Computes the step d on the active nodes F (`free`), with d = 0 on the
/// inactive nodes Z, from
///
///     ((C + c) d + v)(x) = -r(x)  on F,
///
/// v is uniform: under a prescribed load it makes the mean of d vanish, under a
/// prescribed gap it is 0. If F has fewer nodes than Z, the weighted C + c on F
/// is factorised. Otherwise, with B = (C + c)^-1 on fields of zero mean, the
/// step is B (mu - r) plus a uniform part, with mu on Z such that d = 0 there,
/// and B on Z is factorised. Because B is known in single precision only, the
/// result is used as the preconditioner of conjugate gradients in double
/// precision, which take about five iterations.
class ActiveSystem {
public:
  /// @param keeps_load  true if the mean of the step is 0 (prescribed load)
  ActiveSystem(SurfaceOperator& elasticity, double local_compliance,
               bool keeps_load);

  /// @param free       F, indices in increasing order
  /// @param residual   r [m], one value per node of the grid
  /// @param tolerance  largest residual that the iterative variant leaves
  ///                   [m] > 0
  /// @param step       d [Pa], one value per node; overwritten
  /// @return           an empty string, or why there is no step
  std::string solve(std::span<const std::size_t> free,
                    std::span<const double> residual, double tolerance,
                    std::span<double> step);

  int transforms() const { return transforms_; }

private:
  class Preconditioner;

  double weight(std::size_t node) const { return weight_of(weights_, node); }

  bool solve_directly(std::span<const std::size_t> free,
                      std::span<const double> residual, std::span<double> step);
  bool solve_by_fixed(std::span<const std::size_t> free,
                      std::span<const double> residual, double tolerance,
                      std::span<double> step);
  void estimate(std::span<const double> gap, std::span<double> pressure);
  double dot(std::span<const double> a, std::span<const double> b) const;

  SurfaceOperator& elasticity_;
  double local_compliance_;
  bool keeps_load_;
  std::span<const double> weights_;
  Columns compliance_, stiffness_;
  std::vector<float> gap_;
  std::vector<float> pressure_;
  int transforms_ = 0;
};

} // namespace asperity::contact
