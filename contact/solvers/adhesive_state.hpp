#pragma once

// The fields of an adhesive contact, and the products of vectors of free nodes
// that its minimisation and its test for a minimum need.

#include "base/ranks/node_sums.hpp"
#include "contact/solvers/adhesive.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace asperity::contact {

/// The gap with the residual and the free nodes that follow from it.
/// Fields have the nodes of this process; the calls are collective.
class AdhesiveState {
public:
  AdhesiveState(SurfaceOperator& elasticity_, const AdhesiveProblem& problem_,
                const mechanics::LoadTarget& target_,
                std::vector<double> start);

  SurfaceOperator& elasticity;
  const AdhesiveProblem& problem;
  const mechanics::LoadTarget& target;
  Workers workers;

  std::vector<double> gap;        ///< g [m], >= 0 for a law with a wall
  std::vector<double> elastic;    ///< K v [Pa], mean 0
  std::vector<double> gradient;   ///< K v + W'(g) [Pa]
  std::vector<std::uint8_t> free; ///< 1 for an open gap or a negative residual
  double load = 0.0;              ///< p_0 [Pa], or its present estimate
  double n_free = 0.0;
  double least_gap = 0.0; ///< [m]
  /// Largest stiffness of the elastic surface on the grid [Pa/m]: its shortest
  /// waves are 2 sqrt 2 times as short as those of the compliance.
  const double stiffest_waves;
  int transforms = 0;

  /// The gap at which a node is closed [m]: 0, or -infinity without a wall.
  double wall() const {
    return mechanics::has_wall(problem.law.law)
               ? 0.0
               : -std::numeric_limits<double>::infinity();
  }

  /// Whether <g> is that of the target.
  bool by_gap() const {
    return target.control == mechanics::Control::mean_gap && !by_spring();
  }

  /// Whether p_0 = k (<g> - d).
  bool by_spring() const { return std::isfinite(target.spring); }

  /// Number of nodes on all ranks.
  double n_nodes() const {
    return static_cast<double>(workers.all_nodes(gap.size()));
  }

  /// Sum over all nodes of all ranks.
  template <class Term>
  double sum(const Term& term) const {
    return weighted_sum({}, gap.size(), workers, term);
  }

  /// Calls of(i) for all nodes of this process.
  template <class Of>
  void each(const Of& of) const {
    chunked(gap.size(), workers.threads,
            [&](std::size_t begin, std::size_t end) {
              for (std::size_t i = begin; i < end; ++i)
                of(i);
            });
  }

  double dot(std::span<const double> a, std::span<const double> b) const {
    return sum(
        [a = a.data(), b = b.data()](std::size_t i) { return a[i] * b[i]; });
  }

  double rms(std::span<const double> field) const;

  /// r where a node is free, otherwise 0, and without the mean under gap
  /// control.
  void residual(std::span<double> answer) const;

  /// Sets nodes that are not free to 0 and, under gap control, the mean of the
  /// free ones.
  void restrict_to_free(std::span<double> field) const;

  /// answer = M field [m] on the free nodes. With the repulsion D = W'' > 0 of
  /// laws without a wall, S = (1 + D/k)^-1/2, the stiffness k_s of the
  /// shortest waves and that of the mean gap, k_u,
  ///
  ///     M = S [(K + k)^-1 + (1/k_u - 1/k) P] S + (1 - S^2)/(D + k_s)
  ///
  /// where P takes the mean of a field.
  /// @param field  [Pa], as restrict_to_free() leaves it
  void precondition(std::span<const double> field, std::span<double> answer);

  /// answer = (K + W'') field [Pa] on the free nodes.
  void apply_hessian(std::span<const double> field, std::span<double> answer);

  /// What a step changes.
  struct Change {
    double energy = 0.0; ///< of U [J/m^2]
    double slope = 0.0;  ///< <r, change of the gap>, its first order [J/m^2]
  };

  /// Finds the state behind a step, which take() makes that of this object.
  /// @param direction  [m], as restrict_to_free() leaves it
  Change try_step(std::span<const double> direction, double length);

  /// Adopts the last state of try_step().
  /// @param step    change of the gap [m], overwritten
  /// @param bend    change of the gradient [Pa], overwritten
  void take(std::span<float> step, std::span<float> bend);
  void take();

  /// The load over the nominal area that free nodes carry and the law does not,
  /// the mean of r where there is a counter-surface, or where there is none, if
  /// that is larger [Pa] >= 0.
  double missing_load() const;

  /// The largest missing_load() of a solution [Pa]: load_tolerance <|p|>, or
  /// the roundoff of the residual.
  double accepted_load() const;

  /// The missing_load() whose energy, p^2/(2 k_c), is the roundoff of that of
  /// the law, w: what no descent finds [Pa].
  double unresolved_load() const;

  /// Whether no node can carry the prescribed tensile load any more.
  bool is_detached() const;

private:
  /// Projects the free nodes of a gap on gaps >= `closed` of a mean: shifts
  /// them and clips them there.
  void restore_mean(std::span<double> moved, double mean, double closed) const;
  void restrict_to_free(std::span<double> field, bool is_without_mean) const;
  /// From the gap: K v.
  void find_elastic(std::span<const double> from, std::span<double> answer);
  void find_free();
  /// The multiplier of a prescribed mean gap [Pa].
  double mean_load() const;
  /// k_u [Pa/m]: the mean of D, or of an infinite stiffness at closed nodes, in
  /// series with k_s. A residual moves the mean gap by at most the range, and
  /// k_u is at most k_c.
  double stiffness_of_mean_gap() const;
  /// W'' [Pa/m] where a law without a wall repels, otherwise 0.
  double repulsion(std::size_t i) const;

  bool has_wall_;
  double wave_stiffness_;          ///< k [Pa/m] of M
  double uniform_stiffness_ = 0.0; ///< k_u [Pa/m]
  std::vector<double> next_gap_, next_elastic_;
  std::vector<float> scratch_;
};

} // namespace asperity::contact
