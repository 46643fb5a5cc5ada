#pragma once

// This file computes means over the nodes for the certificate, whose roundoff
// does not grow with the number of nodes.

#include "contact/operators/node_weights.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace asperity::contact {

/// Means over the nodes with the weights of the operator.
class Weighted {
public:
  explicit Weighted(std::span<const double> weights) : weights_(weights) {}

  double mean_of(std::span<const double> a) const {
    return mean(a.size(), [&](std::size_t i) { return a[i]; });
  }

  /// <a, b>: the weighted mean of the product.
  double product(std::span<const double> a, std::span<const double> b) const {
    return mean(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
  }

private:
  /// Compensated summation (Kahan): the roundoff does not grow with the number
  /// of nodes. Independent sums of every eighth node are added up in the end,
  /// because a single one waits for each of its additions.
  template <class Term>
  double mean(std::size_t nodes, const Term& term) const {
    constexpr std::size_t lanes = 8;
    return with_weights(weights_, [&](const auto weight) {
      std::array<double, lanes> sums{}, lost{};
      const auto add = [&](std::size_t lane, double value) {
        const double added = value - lost[lane];
        const double next = sums[lane] + added;
        lost[lane] = (next - sums[lane]) - added;
        sums[lane] = next;
      };
      std::size_t i = 0;
      for (; i + lanes <= nodes; i += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane)
          add(lane, weight[i + lane] * term(i + lane));
      for (; i < nodes; ++i)
        add(0, weight[i] * term(i));
      for (std::size_t lane = 1; lane < lanes; ++lane) {
        add(0, sums[lane]);
        add(0, -lost[lane]);
      }
      return sums[0] / static_cast<double>(nodes);
    });
  }

  std::span<const double> weights_;
};

} // namespace asperity::contact
