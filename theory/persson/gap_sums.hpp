#pragma once

// Evaluates the outer integrals of Eqs. (9) and (14) of Yang and Persson (2008)
// and of their derivative at one pressure, from quantities that are computed
// once per spectrum: a point of u(p) takes microseconds. Equation numbers in
// this file are those of that paper.

#include "theory/persson/gap_kernel.hpp"
#include "theory/persson/height_spectrum.hpp"

#include <array>
#include <span>
#include <vector>

namespace asperity::theory {

/// Sums over the nodes of a spectrum, x_k = p/(E* sqrt(pi) m_k). Nodes with
/// x_k < sqrt(1/2) enter together through their power moments; only the others,
/// about three octaves of m, are summed one by one.
class GapSums {
public:
  /// @param nodes  in descending order of root_moment
  explicit GapSums(std::span<const RoughnessNode> nodes);

  /// Both parts of u(p), Eq. (14) [m].
  /// @param pressure_ratio  p/E* [1] > 0
  GammaParts mean_gap(double pressure_ratio) const;

  /// Both parts of D = -du/dln p [m].
  GammaParts mean_gap_slope(double pressure_ratio) const;

  /// Both parts of U_el/(A_0 E*), Eq. (9) [m].
  GammaParts elastic_energy(double pressure_ratio) const;

  /// Sum of the weights = 2 int dm/q = u_0/gamma of Eq. (18) [m].
  double weight_sum() const { return weight_sum_; }

  /// Weighted mean of ln w, the quotient of the integrals in Eq. (19) [1].
  double mean_log_factor() const { return mean_log_factor_; }

private:
  using Moments = std::array<double, SmallPressureSeries::n_terms>;

  struct Node {
    double factor;      ///< w = 1/(sqrt(pi) m) [1], ascending
    double weight;      ///< [m]
    double log_sum;     ///< cumulative sum of weight * ln w [m]
    Moments power_sums; ///< cumulative sums of weight_i (w_i/w)^{2n} [m]
  };

  /// Number of nodes with x < limit, which come first.
  std::size_t n_small(double pressure_ratio) const;

  std::vector<Node> nodes_;
  double weight_sum_ = 0.0;
  double mean_log_factor_ = 0.0;
};

} // namespace asperity::theory
