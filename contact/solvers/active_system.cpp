#include "contact/solvers/active_system.hpp"

#include "base/maximum.hpp"
#include "base/ranks/node_sums.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace asperity::contact {
namespace {

/// Cholesky factor of a matrix that is scaled to order 1 by a power of two, so
/// that the roundoff of its square roots does not depend on the units.
class Factor {
public:
  /// Factorises the matrix, of which the lower triangle is used. There is no
  /// factor if the diagonal has no positive entry or if any entry, also of the
  /// upper triangle, is not finite.
  void compute(Eigen::MatrixXd matrix) {
    const double largest = matrix.diagonal().maxCoeff();
    exists_ = largest > 0.0 && matrix.allFinite();
    if (!exists_)
      return;
    scale_ = std::ldexp(1.0, -std::ilogb(largest));
    matrix *= scale_;
    factor_.compute(matrix);
    exists_ = factor_.info() == Eigen::Success;
  }

  bool exists() const { return exists_; }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    return factor_.solve(right) * scale_;
  }

private:
  Eigen::LLT<Eigen::MatrixXd, Eigen::Lower> factor_;
  double scale_ = 1.0;
  bool exists_ = false;
};

/// Conjugate gradients with a single-precision preconditioner take about five
/// iterations; an incomplete step still reduces the energy.
constexpr int most_refinements = 60;

/// Largest number of values in the cached columns: 128 MB.
constexpr std::size_t most_numbers = std::size_t{1} << 24;

Eigen::Index length_of(std::span<const std::size_t> nodes) {
  return static_cast<Eigen::Index>(nodes.size());
}

std::size_t at(std::span<const std::size_t> nodes, Eigen::Index i) {
  return nodes[static_cast<std::size_t>(i)];
}

} // namespace

double Columns::between(std::size_t node, std::size_t other) {
  if (columns_.size() == 1) { // that of the node 0, shifted
    const auto nx = static_cast<std::size_t>(grid_.points_x);
    const auto ny = static_cast<std::size_t>(grid_.points_y);
    node = (node / nx + ny - other / nx) % ny * nx +
           (node % nx + nx - other % nx) % nx;
    other = 0;
  }
  std::vector<double>& column = columns_[other];
  if (column.empty()) {
    std::vector<double> unit(grid_.size());
    unit[other] = 1.0;
    column.resize(grid_.size());
    take_(unit, column);
  }
  return column[node];
}

/// M = (C + c)^-1 restricted to the active nodes, in single precision.
class ActiveSystem::Preconditioner {
public:
  Preconditioner(ActiveSystem& system, std::vector<std::size_t> fixed)
      : system_(system), fixed_(std::move(fixed)) {
    const Eigen::Index m = length_of(fixed_);
    areas_.resize(m);
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(m, m);
    for (Eigen::Index b = 0; b < m; ++b) {
      areas_[b] = system_.weight(at(fixed_, b));
      for (Eigen::Index a = b; a < m; ++a)
        stiffness(a, b) =
            system_.weight(at(fixed_, a)) *
            system_.stiffness_.between(at(fixed_, a), at(fixed_, b));
    }
    if (m > 0) {
      stiffness.diagonal() *= 1.0 + std::numeric_limits<float>::epsilon();
      factor_.compute(std::move(stiffness));
      if (factor_.exists())
        of_areas_ = factor_.solve(areas_);
    }
  }

  bool exists() const { return fixed_.empty() || factor_.exists(); }

  /// Computes z = M r, which is 0 on the inactive nodes; r must be 0 there and
  /// is overwritten.
  void apply(std::vector<double>& r, std::vector<double>& z) const {
    const std::vector<double> ones(r.size(), 1.0);
    const double sum = system_.dot(ones, r);
    system_.estimate(r, z);
    double uniform = 0.0;
    if (!fixed_.empty()) {
      Eigen::VectorXd held(length_of(fixed_));
      for (Eigen::Index a = 0; a < held.size(); ++a)
        held[a] = areas_[a] * z[at(fixed_, a)];
      held = factor_.solve(held);
      if (!system_.keeps_load_) {
        uniform = uniform_part(sum, areas_.dot(held));
        held += uniform * of_areas_;
      }
      for (Eigen::Index a = 0; a < held.size(); ++a)
        r[at(fixed_, a)] = -held[a];
      system_.estimate(r, z);
    } else if (!system_.keeps_load_) {
      uniform = uniform_part(sum, 0.0);
    }
    for (double& value : z)
      value += uniform;
    for (const std::size_t node : fixed_)
      z[node] = 0.0;
  }

private:
  /// The uniform part u of z, from N c u = the sum of r and of the constraint
  /// values on the inactive nodes.
  double uniform_part(double sum, double held) const {
    const double softness =
        (fixed_.empty() ? 0.0 : areas_.dot(of_areas_)) +
        system_.local_compliance_ *
            static_cast<double>(system_.elasticity_.grid().size());
    return softness > 0.0 ? (sum - held) / softness : 0.0;
  }

  ActiveSystem& system_;
  std::vector<std::size_t> fixed_;
  Eigen::VectorXd areas_;
  Factor factor_;
  Eigen::VectorXd of_areas_;
};

ActiveSystem::ActiveSystem(SurfaceOperator& elasticity, double local_compliance,
                           bool keeps_load)
    : elasticity_(elasticity),
      local_compliance_(local_compliance),
      keeps_load_(keeps_load),
      weights_(elasticity.nodal_weights()),
      compliance_(elasticity,
                  [this](auto unit, auto column) {
                    elasticity_.displacement(unit, column);
                    ++transforms_;
                  }),
      stiffness_(elasticity,
                 [this](auto unit, auto column) { estimate(unit, column); }),
      gap_(elasticity.grid().size()),
      pressure_(elasticity.grid().size()) {}

std::string refusal_of_system(const SurfaceOperator& elasticity,
                              std::size_t n_free, std::size_t n_nodes) {
  const std::size_t size = std::min(n_free, n_nodes - n_free);
  const bool is_even = elasticity.is_shift_invariant();
  if (size > most_active_nodes || (is_even ? 1 : size) * n_nodes > most_numbers)
    return std::to_string(n_free) + " of " + std::to_string(n_nodes) +
           " nodes in contact are too many for the active-set method";
  return {};
}

std::string ActiveSystem::solve(std::span<const std::size_t> free,
                                std::span<const double> residual,
                                double tolerance, std::span<double> step) {
  const std::size_t nodes = residual.size();
  std::string refusal = refusal_of_system(elasticity_, free.size(), nodes);
  if (!refusal.empty())
    return refusal;
  const bool is_direct = 2 * free.size() <= nodes;
  std::fill(step.begin(), step.end(), 0.0);
  if (free.empty()) // under gap control no node need be in contact
    return {};
  const bool is_solved = is_direct
                             ? solve_directly(free, residual, step)
                             : solve_by_fixed(free, residual, tolerance, step);
  return is_solved ? "" : "the compliance matrix is singular to roundoff";
}

bool ActiveSystem::solve_directly(std::span<const std::size_t> free,
                                  std::span<const double> residual,
                                  std::span<double> step) {
  const Eigen::Index n = length_of(free);
  Eigen::MatrixXd compliance = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right(n);
  Eigen::VectorXd areas(n);
  for (Eigen::Index b = 0; b < n; ++b) {
    const std::size_t node = at(free, b);
    areas[b] = weight(node);
    right[b] = -weight(node) * residual[node];
    for (Eigen::Index a = b; a < n; ++a)
      compliance(a, b) =
          weight(at(free, a)) * compliance_.between(at(free, a), node);
    compliance(b, b) += weight(node) * local_compliance_;
  }
  Factor factor;
  factor.compute(std::move(compliance));
  if (!factor.exists())
    return false;
  Eigen::VectorXd answer = factor.solve(right);
  if (keeps_load_) {
    const Eigen::VectorXd uniform = factor.solve(areas);
    answer -= areas.dot(answer) / areas.dot(uniform) * uniform;
  }
  for (Eigen::Index a = 0; a < n; ++a)
    step[at(free, a)] = answer[a];
  return answer.allFinite();
}

bool ActiveSystem::solve_by_fixed(std::span<const std::size_t> free,
                                  std::span<const double> residual,
                                  double tolerance, std::span<double> step) {
  const std::size_t nodes = residual.size();
  std::vector<std::size_t> fixed;
  for (std::size_t i = 0, at = 0; i < nodes; ++i)
    if (at < free.size() && free[at] == i)
      ++at;
    else
      fixed.push_back(i);
  const Preconditioner preconditioner(*this, std::move(fixed));
  if (!preconditioner.exists())
    return false;

  std::vector<double> r(nodes), used(nodes), z(nodes), d(nodes), cd(nodes);
  for (const std::size_t node : free)
    r[node] = -residual[node];
  double before = 0.0;
  for (int i = 0; i < most_refinements; ++i) {
    if (keeps_load_) { // a uniform part of r adds roundoff only
      double sum = 0.0, total = 0.0;
      for (const std::size_t node : free) {
        sum += weight(node) * r[node];
        total += weight(node);
      }
      for (const std::size_t node : free)
        r[node] -= sum / total;
    }
    double error = 0.0;
    for (const std::size_t node : free)
      error = maximum(error, std::abs(r[node]));
    if (error <= tolerance)
      break;
    used = r;
    preconditioner.apply(used, z);
    const double slope = dot(r, z);
    if (!(slope > 0.0))
      break;
    const double beta = before > 0.0 ? slope / before : 0.0;
    before = slope;
    for (const std::size_t node : free)
      d[node] = z[node] + beta * d[node];
    elasticity_.displacement(d, cd);
    ++transforms_;
    double curvature = 0.0;
    for (const std::size_t node : free) {
      cd[node] += local_compliance_ * d[node];
      curvature += weight(node) * d[node] * cd[node];
    }
    if (!(curvature > 0.0))
      break;
    const double length = dot(r, d) / curvature;
    for (const std::size_t node : free) {
      step[node] += length * d[node];
      r[node] -= length * cd[node];
    }
  }
  return before > 0.0;
}

void ActiveSystem::estimate(std::span<const double> gap,
                            std::span<double> pressure) {
  for (std::size_t i = 0; i < gap.size(); ++i)
    gap_[i] = static_cast<float>(gap[i]);
  elasticity_.pressure_estimate(gap_, local_compliance_, pressure_);
  ++transforms_;
  double sum = 0.0;
  for (std::size_t i = 0; i < gap.size(); ++i)
    sum += weight(i) * static_cast<double>(pressure_[i]);
  const double mean = sum / static_cast<double>(gap.size());
  for (std::size_t i = 0; i < gap.size(); ++i)
    pressure[i] = static_cast<double>(pressure_[i]) - mean;
}

double ActiveSystem::dot(std::span<const double> a,
                         std::span<const double> b) const {
  return weighted_dot(weights_, a, b);
}

} // namespace asperity::contact
