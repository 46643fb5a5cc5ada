#pragma once

// The outer integrals of (9), (14) and their derivative at one pressure, fast:
// what is prepared once for a spectrum so that a point of u(p) is microseconds.

#include "theory/persson/gap_kernel.hpp"
#include "theory/persson/height_spectrum.hpp"

#include <array>
#include <span>
#include <vector>

namespace asperity::theory {

/// Sums over the nodes of a spectrum, x_k = p/(E* sqrt(pi) m_k). Nodes with
/// x_k < sqrt(1/2) enter through their power moments, all of them at once; only
/// the others, some three octaves of m, are summed one by one.
class GapSums {
public:
  /// @param nodes  descending in root_moment
  explicit GapSums(std::span<const RoughnessNode> nodes);

  /// Both parts of u(p), (14) [m].
  /// @param pressure_ratio  p/E* [1] > 0
  GammaParts mean_gap(double pressure_ratio) const;

  /// Both parts of D = -du/dln p [m].
  GammaParts mean_gap_slope(double pressure_ratio) const;

  /// Both parts of U_el/(A_0 E*), (9) [m].
  GammaParts elastic_energy(double pressure_ratio) const;

  /// sum of the weights = 2 int dm/q = u_0/gamma of (18) [m].
  double weight_sum() const { return weight_sum_; }

  /// The mean of ln w over the weights: the integrals' quotient in (19) [1].
  double mean_log_factor() const { return mean_log_factor_; }

private:
  using Moments = std::array<double, SmallPressureSeries::n_terms>;

  struct Node {
    double factor;      ///< w = 1/(sqrt(pi) m) [1], ascending
    double weight;      ///< [m]
    double log_sum;     ///< sum of weight * ln w up to and with this node [m]
    Moments power_sums; ///< sum of weight_i (w_i/w)^{2n} likewise [m]
  };

  /// How many nodes have x < limit: they come first.
  std::size_t n_small(double pressure_ratio) const;

  std::vector<Node> nodes_;
  double weight_sum_ = 0.0;
  double mean_log_factor_ = 0.0;
};

} // namespace asperity::theory
