#include "mechanics/flow/elimination.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>
#include <vector>

namespace asperity::flow {
namespace {

/// The rows of a network, and which of them are kept.
class Elimination {
public:
  explicit Elimination(const Network& network)
      : network_(network),
        begin_(network.size() + 1),
        to_reservoirs_(network.size()),
        kept_(network.size(), unknown) {
    std::partial_sum(network.row_sizes.begin(), network.row_sizes.end(),
                     begin_.begin() + 1, std::plus<std::size_t>());
    choose();
    int next = 0;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      to_reservoirs_[i] = std::accumulate(
          network.values.begin() + static_cast<std::ptrdiff_t>(begin_[i]),
          network.values.begin() + static_cast<std::ptrdiff_t>(begin_[i + 1]),
          0.0);
      if (kept_[i] != eliminated)
        kept_[i] = next++;
    }
  }

  Network reduced() const {
    Network network;
    network.columns.reserve(network_.columns.size());
    network.values.reserve(network_.values.size());
    for (std::size_t i = 0; i < kept_.size(); ++i)
      if (kept_[i] != eliminated)
        add_row(i, network);
    return network;
  }

  /// The potentials of all nodes from those of the kept ones.
  std::vector<double> all_potentials(std::span<const double> known) const {
    std::vector<double> all(kept_.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (kept_[i] != eliminated) {
        all[i] = known[static_cast<std::size_t>(kept_[i])];
        continue;
      }
      double supplied = network_.right_side[i];
      for (std::size_t e = begin_[i] + 1; e < begin_[i + 1]; ++e)
        supplied -=
            network_.values[e] *
            known[static_cast<std::size_t>(kept_of(network_.columns[e]))];
      all[i] = supplied / network_.values[begin_[i]];
    }
    return all;
  }

private:
  static constexpr int eliminated = -1, unknown = -2, kept = 0;

  std::span<const int> neighbours(std::size_t row) const {
    return std::span(network_.columns)
        .subspan(begin_[row] + 1, begin_[row + 1] - begin_[row] - 1);
  }

  int kept_of(int row) const { return kept_[static_cast<std::size_t>(row)]; }

  bool is_beside_eliminated(std::size_t row) const {
    return std::ranges::any_of(neighbours(row),
                               [&](int j) { return kept_of(j) == eliminated; });
  }

  /// Chooses the eliminated nodes: those at an even number of links from the
  /// first of each part, but for the neighbours of another one.
  void choose() {
    std::vector<std::size_t> reached;
    for (std::size_t first = 0; first < kept_.size(); ++first) {
      if (kept_[first] != unknown)
        continue;
      kept_[first] = eliminated;
      reached.push_back(first);
      while (!reached.empty()) {
        const std::size_t i = reached.back();
        reached.pop_back();
        for (const int j : neighbours(i)) {
          const auto other = static_cast<std::size_t>(j);
          if (kept_[other] != unknown)
            continue;
          kept_[other] = kept_[i] == eliminated || is_beside_eliminated(other)
                             ? kept
                             : eliminated;
          reached.push_back(other);
        }
      }
    }
  }

  /// Adds the row of a kept node i: its conductances w_ij to kept neighbours,
  /// and w_ij w_jl/w_jj through each eliminated neighbour j to its others.
  void add_row(std::size_t i, Network& network) const {
    const std::size_t first = network.columns.size();
    double diagonal = to_reservoirs_[i], supplied = network_.right_side[i];
    const auto join = [&](int other, double value) { // value < 0
      diagonal -= value;
      const auto begin =
          network.columns.begin() + static_cast<std::ptrdiff_t>(first) + 1;
      const auto found = std::find(begin, network.columns.end(), other);
      if (found != network.columns.end()) {
        network.values[static_cast<std::size_t>(
            found - network.columns.begin())] += value;
        return;
      }
      network.columns.push_back(other);
      network.values.push_back(value);
    };
    network.columns.push_back(kept_[i]);
    network.values.push_back(0.0);
    for (std::size_t e = begin_[i] + 1; e < begin_[i + 1]; ++e) {
      const auto j = static_cast<std::size_t>(network_.columns[e]);
      if (kept_[j] != eliminated) {
        join(kept_[j], network_.values[e]);
        continue;
      }
      const double share = -network_.values[e] / network_.values[begin_[j]];
      diagonal += share * to_reservoirs_[j];
      supplied += share * network_.right_side[j];
      for (std::size_t f = begin_[j] + 1; f < begin_[j + 1]; ++f)
        if (network_.columns[f] != static_cast<int>(i))
          join(kept_of(network_.columns[f]), share * network_.values[f]);
    }
    network.values[first] = diagonal;
    network.row_sizes.push_back(
        static_cast<int>(network.columns.size() - first));
    network.right_side.push_back(supplied);
    network.start.push_back(network_.start[i]);
  }

  const Network& network_;
  std::vector<std::size_t> begin_;    ///< of each row among the entries
  std::vector<double> to_reservoirs_; ///< sums of the rows
  std::vector<int> kept_; ///< row in the reduced network, or eliminated
};

} // namespace

NetworkSolution solved_by_elimination(const Network& network,
                                      const SolveNetwork& solve) {
  const Elimination elimination(network);
  NetworkSolution solution = solve(elimination.reduced());
  if (solution.converged)
    solution.potential = elimination.all_potentials(solution.potential);
  return solution;
}

} // namespace asperity::flow
