#pragma once

// Linear constraints of the unknowns of a mesh, applied to plain vectors. This
// file does not depend on deal.II.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace asperity::fem {

/// Homogeneous linear constraints of unknowns by unconstrained ones: hanging
/// nodes, images at periodic sides, and unknowns that are held (no entries).
/// The three unknowns of a node that have the same masters but for the
/// component are one row.
struct UnknownConstraints {
  std::vector<std::uint32_t> unknowns; ///< the first of each row, increasing
  std::vector<bool> is_node;           ///< whether each row has three
  /// The masters of row i are start[i]..start[i+1]-1, for the second and third
  /// unknown those that follow them. The weights of the pin against rotation
  /// need double precision.
  std::vector<std::uint32_t> start{0};
  std::vector<std::uint32_t> masters;
  std::vector<double> weights;

  /// Adds a master of the next unknown.
  void add_master(std::size_t master, double weight) {
    masters.push_back(static_cast<std::uint32_t>(master));
    weights.push_back(weight);
  }

  /// Adds the unknown of the masters since the last one, which must be larger
  /// than all before.
  void add(std::size_t unknown);

  std::size_t rows() const { return unknowns.size(); }

  /// The row of an unknown; rows() if it is not constrained.
  std::size_t row_of(std::size_t unknown) const;

  /// Calls a function of each constrained unknown.
  template <class Visit>
  void visit(const Visit& visit_unknown) const {
    for (std::size_t row = 0; row < rows(); ++row)
      for (std::size_t c = 0; c < width(row); ++c)
        visit_unknown(unknowns[row] + c);
  }

  std::size_t width(std::size_t row) const { ///< number of unknowns
    return is_node[row] ? 3 : 1;
  }

  /// Writes the constrained values of a displacement.
  template <class Number>
  void distribute(Number* displacement) const;

  /// Moves the forces on constrained unknowns to their masters; zeros remain.
  template <class Number>
  void condense(Number* force) const;

  /// The same for a diagonal, without the terms that couple two masters of one
  /// unknown.
  void condense_diagonal(std::vector<double>& diagonal) const;

  std::size_t bytes() const {
    return (unknowns.size() + start.size() + masters.size()) *
               sizeof(std::uint32_t) +
           weights.size() * sizeof(double) + is_node.size() / 8;
  }

private:
  bool is_shifted(std::size_t row, std::uint32_t shift) const;
};

/// Constraints that operators of one mesh share. None of these counts them in
/// its memory.
using SharedConstraints = std::shared_ptr<const UnknownConstraints>;

} // namespace asperity::fem
