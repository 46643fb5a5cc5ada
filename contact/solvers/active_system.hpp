#pragma once

// The linear problem of a fixed set of nodes in contact, solved by a dense
// factor of the smaller of two matrices.

#include "contact/operators/columns.hpp"
#include "contact/operators/surface_operator.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::contact {

/// The step d on the free nodes F, 0 on the fixed ones Z, with
///
///     ((C + c) d + v)(x) = -r(x)  on F,
///
/// v uniform such that the mean of d is 0 (prescribed load) or 0 (prescribed
/// gap). With fewer nodes in F than in Z the weighted C + c of F is factored.
/// Else, with B = (C + c)^-1 on fields of mean 0, the step is B (mu - r) plus
/// a uniform part, mu on Z such that d = 0 there: B of Z is factored. B is
/// known in single precision only, so that is the preconditioner of conjugate
/// gradients in double precision, some five steps of them.
class ActiveSystem {
public:
  /// @param keeps_load  the mean of the step is 0
  ActiveSystem(SurfaceOperator& elasticity, double local_compliance,
               bool keeps_load);

  /// @param free       F, increasing
  /// @param residual   r [m], a value a node of the grid
  /// @param tolerance  left of r at most in the second way [m] > 0
  /// @param step       d [Pa], a value a node; overwritten
  /// @return           empty, or why there is no step
  std::string solve(std::span<const std::size_t> free,
                    std::span<const double> residual, double tolerance,
                    std::span<double> step);

  int transforms() const { return transforms_; }

private:
  class Preconditioner;

  double weight(std::size_t node) const {
    return weights_.empty() ? 1.0 : weights_[node];
  }

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
  Columns compliance_;
  Columns stiffness_;
  std::vector<float> gap_;
  std::vector<float> pressure_;
  int transforms_ = 0;
};

} // namespace asperity::contact
