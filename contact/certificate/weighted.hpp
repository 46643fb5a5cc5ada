#pragma once

// Computes means over the nodes for the certificate, whose roundoff does not
// grow with the number of nodes.

#include "base/ranks/chunked_sum.hpp"
#include "base/ranks/node_weights.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace asperity::contact {

/// Several sums with compensated summation (Kahan).
template <std::size_t n>
struct CompensatedSums {
  std::array<double, n> values{}, lost{};

  void add(std::size_t k, double value) {
    const double added = value - lost[k];
    const double next = values[k] + added;
    lost[k] = (next - values[k]) - added;
    values[k] = next;
  }

  CompensatedSums& operator+=(const CompensatedSums& other) {
    for (std::size_t k = 0; k < n; ++k) {
      add(k, other.values[k]);
      add(k, -other.lost[k]);
    }
    return *this;
  }
};

/// Means over the nodes with the weights of the operator.
class Weighted {
public:
  /// @param workers  if ranks share the rows, each call is collective
  Weighted(std::span<const double> weights, const Workers& workers)
      : weights_(weights), workers_(workers) {}

  double mean_of(std::span<const double> a) const {
    return mean(a.size(), [&](std::size_t i) { return a[i]; });
  }

  /// <a, b>: the weighted mean of the product.
  double product(std::span<const double> a, std::span<const double> b) const {
    return mean(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
  }

  /// The weighted mean of term(i) over the nodes i of this process, or of all
  /// ranks.
  template <class Term>
  double mean(std::size_t nodes, const Term& term) const {
    return means<1>(nodes, [&](std::size_t i) {
      return std::array<double, 1>{term(i)};
    })[0];
  }

  /// The weighted means of the n numbers terms(i). A chunk has independent sums
  /// of every eighth node, which are added up in the end, because a single one
  /// waits for each of its additions.
  template <std::size_t n, class Terms>
  std::array<double, n> means(std::size_t nodes, const Terms& terms) const {
    auto sums = with_weights(weights_, [&](const auto weight) {
      return chunked_sum<CompensatedSums<n>>(
          nodes, workers_, [&](std::size_t begin, std::size_t end) {
            std::array<CompensatedSums<n>, lanes> parts{};
            const auto add = [&](std::size_t i, CompensatedSums<n>& part) {
              const std::array<double, n> values = terms(i);
              for (std::size_t k = 0; k < n; ++k)
                part.add(k, weight[i] * values[k]);
            };
            std::size_t i = begin;
            for (; i + lanes <= end; i += lanes)
              for (std::size_t lane = 0; lane < lanes; ++lane)
                add(i + lane, parts[lane]);
            for (; i < end; ++i)
              add(i, parts[0]);
            for (std::size_t lane = 1; lane < lanes; ++lane)
              parts[0] += parts[lane];
            return parts[0];
          });
    });
    for (double& value : sums.values)
      value /= static_cast<double>(workers_.all_nodes(nodes));
    return sums.values;
  }

private:
  static constexpr std::size_t lanes = 8;

  std::span<const double> weights_;
  Workers workers_;
};

} // namespace asperity::contact
