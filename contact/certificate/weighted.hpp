#pragma once

// This file computes means over the nodes for the certificate, whose roundoff
// does not grow with the number of nodes.

#include "contact/operators/node_weights.hpp"

#include <array>
#include <cstddef>
#include <span>

#include "ranks/in_order.hpp"

namespace asperity::contact {

/// Means over the nodes with the weights of the operator.
class Weighted {
public:
  /// @param rows  the rows of this process if ranks share them; then each call
  ///              is collective. Null: all rows.
  explicit Weighted(std::span<const double> weights,
                    const SharedRows* rows = nullptr)
      : weights_(weights), rows_(rows) {}

  double mean_of(std::span<const double> a) const {
    return mean(a.size(), [&](std::size_t i) { return a[i]; });
  }

  /// <a, b>: the weighted mean of the product.
  double product(std::span<const double> a, std::span<const double> b) const {
    return mean(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
  }

  /// The weighted mean of term(i) over the nodes i of this process, or of all
  /// ranks. Compensated summation (Kahan): the roundoff does not grow with the
  /// number of nodes. Independent sums of every eighth node are added up in the
  /// end, because a single one waits for each of its additions. A rank
  /// continues the sums of the ranks before; all but the last have a multiple
  /// of eight nodes.
  template <class Term>
  double mean(std::size_t nodes, const Term& term) const {
    constexpr std::size_t lanes = 8;
    return with_weights(weights_, [&](const auto weight) {
      struct State {
        std::array<double, lanes> sums{}, lost{};
      };
      const auto add = [](State& to, std::size_t lane, double value) {
        const double added = value - to.lost[lane];
        const double next = to.sums[lane] + added;
        to.lost[lane] = (next - to.sums[lane]) - added;
        to.sums[lane] = next;
      };
      State all = in_order(rows_, State{}, [&](State& so_far) {
        State own = so_far;
        std::size_t i = 0;
        for (; i + lanes <= nodes; i += lanes)
          for (std::size_t lane = 0; lane < lanes; ++lane)
            add(own, lane, weight[i + lane] * term(i + lane));
        for (; i < nodes; ++i)
          add(own, 0, weight[i] * term(i));
        so_far = own;
      });
      for (std::size_t lane = 1; lane < lanes; ++lane) {
        add(all, 0, all.sums[lane]);
        add(all, 0, -all.lost[lane]);
      }
      return all.sums[0] / static_cast<double>(all_nodes(rows_, nodes));
    });
  }

private:
  std::span<const double> weights_;
  const SharedRows* rows_;
};

} // namespace asperity::contact
