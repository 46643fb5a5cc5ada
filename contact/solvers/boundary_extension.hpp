#pragma once

// This file extends a residual from the active nodes across the contact
// boundary, and applies the transpose to the result, which makes the masked
// preconditioner efficient.

#include "contact/operators/workers.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace asperity::contact {

class NodeBits;

/// The linear map E from a residual on the active nodes to a field on the grid.
/// It is the identity on the active nodes; on each of the `layers` next rings
/// of nodes around them it is
///
///     e_i = reach * sum_j w_ij e_j / sum_j w_ij                        (R.1)
///
/// over the neighbours j in the previous ring, w = 1 for nearest neighbours and
/// 1/2 for diagonal ones.
///
/// Reason: the inverse of C on the active nodes corresponds to the continuation
/// of the residual with the least energy. F^-1 C^-1 F corresponds to the
/// continuation by 0, whose jump at the contact boundary has an energy that
/// grows with the logarithm of contact size over grid spacing. E^T C^-1 E
/// corresponds to one that decays over a few nodes.
class BoundaryExtension {
public:
  static constexpr int layers = 3;

  /// @param workers  whose ranks share the rows of the grid, if there are any
  BoundaryExtension(const Grid& grid, const Workers& workers);

  /// Finds the rings around the active nodes, those with is_free[i] > 0. This
  /// and the other calls are collective; fields have the nodes of this process.
  void build(std::span<const std::uint8_t> is_free);

  /// Number of active nodes at the contact boundary on all ranks when the rings
  /// were built.
  std::size_t size() const { return size_; }

  bool is_built() const { return is_built_; }

  /// field = E field. A node of a ring that has become active since build()
  /// keeps its value.
  /// @param field  0 at the inactive nodes
  void extend(double reach, std::span<const std::uint8_t> is_free,
              std::span<float> field);

  /// Sets the field on the rings to 0.
  void clear(std::span<const std::uint8_t> is_free,
             std::span<float> field) const;

  /// field = E^T field on the active nodes; elsewhere the result has no
  /// meaning.
  void fold(double reach, std::span<const std::uint8_t> is_free,
            std::span<float> field);

private:
  struct Ring {
    std::vector<std::uint32_t> nodes; ///< those off the grid's border first
    std::size_t n_inside = 0;         ///< number of those off the border
    std::vector<float> share;         ///< 1 / sum of w over the previous ring
  };

  /// Builds the ring of `members`; `before` are the nodes of the previous ring.
  void collect(const NodeBits& members, const NodeBits& before,
               Ring& kept) const;
  void clear_work();

  /// Values of work_ at the nodes of this process.
  float* own_work() { return work_.data() + rows_.width(); }

  /// Sum of w field over the eight neighbours of node k of the ring.
  float around(const Ring& ring, std::size_t k, const float* field) const;
  /// The same for a node on the border of the grid.
  float around_border(std::size_t node, const float* field) const;
  template <class DoNodes>
  void each_chunk(const Ring& ring, const DoNodes& do_nodes) const;

  SharedRows rows_;
  int threads_;
  std::size_t size_ = 0;
  bool is_built_ = false;
  std::vector<Ring> rings_; ///< 0: the active nodes adjacent to ring 1
  std::vector<float> values_;
  /// Shares of the completed rings, otherwise 0; from the row before those of
  /// this process to the row after them.
  std::vector<float> work_;
};

} // namespace asperity::contact
