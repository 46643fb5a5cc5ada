#pragma once

// Values of unknowns that go from the rank that has them in deal.II's numbering
// to the rank that has their node of a lattice, and back.
// Include this header in .cpp files of fem/ only.

#include "ranks/value_exchange.hpp"

#include <deal.II/lac/trilinos_vector.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace asperity::fem {

/// The numbers 0..n-1 by increasing target.
std::vector<std::size_t> order_by(const std::vector<int>& targets);

/// All calls are collective.
class UnknownExchange {
public:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;
  static constexpr auto nowhere = static_cast<std::size_t>(-1);

  /// @param ranks     null if there is only one
  /// @param numbers   of the node's component of each own unknown, or nowhere
  /// @param rank_of   the rank that has a number; null if each rank has all
  /// @param place_of  the place of a number in a vector of the rank that has it
  UnknownExchange(
      RankGroup* ranks, std::span<const std::size_t> numbers,
      const std::function<int(std::size_t number)>& rank_of,
      const std::function<std::size_t(std::size_t number)>& place_of);

  /// Writes the values to their places; others become zero.
  void send(const Vector& from, std::span<double> to) const;

  /// Sets the unknowns from their places; those that are nowhere become zero.
  void give_back(std::span<const double> from, Vector& to) const;

  std::size_t bytes() const {
    return (unknowns_.size() + places_.size()) * sizeof(std::uint32_t);
  }

private:
  // Both are below 2^32, because the numbers of unknowns are.
  std::vector<std::uint32_t> unknowns_; ///< in this rank's vector, by target
  std::vector<std::uint32_t> places_;   ///< of values received
  std::optional<ValueExchange> values_; ///< none on one rank
};

} // namespace asperity::fem
