#pragma once

// Continues a residual from the free nodes over the rim of the contact, and
// brings the answer back: what makes the masked preconditioner a good one.

#include "base/grid.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace asperity::contact {

class NodeBits;

/// The linear map E of a residual on the free nodes to a field on the grid:
/// itself where free, and on each of the `layers` next rings of nodes
///
///     e_i = reach * sum_j w_ij e_j / sum_j w_ij                        (R.1)
///
/// over the neighbours j of the ring before, w = 1 beside and 1/2 across.
///
/// Why: the inverse of C on the free nodes takes the cheapest continuation of
/// the residual, while F^-1 C^-1 F takes the one by 0, whose jump at the rim
/// costs energy that grows with the logarithm of contact size over spacing.
/// E^T C^-1 E takes one that falls off over a few nodes.
class RimExtension {
public:
  static constexpr int layers = 3;

  RimExtension(const Grid& grid, int threads);

  /// Finds the rings around the nodes with is_free[i] > 0.
  void build(std::span<const std::uint8_t> is_free);

  /// Free nodes that touch others, when the rings were found.
  std::size_t size() const { return rings_[0].nodes.size(); }

  bool is_built() const { return is_built_; }

  /// field = E field. A ring's node that has become free since build() keeps
  /// its value.
  /// @param field  0 off the free nodes
  void extend(double reach, std::span<const std::uint8_t> is_free,
              std::span<float> field);

  /// Sets the rings to 0 again.
  void clear(std::span<const std::uint8_t> is_free,
             std::span<float> field) const;

  /// field = E^T field on the free nodes; elsewhere it means nothing.
  void fold(double reach, std::span<const std::uint8_t> is_free,
            std::span<float> field);

private:
  struct Ring {
    std::vector<std::uint32_t> nodes; ///< inside the grid's border rows first
    std::size_t n_inside = 0;
    std::vector<float> share; ///< 1 / sum of w over the ring before
  };

  /// The ring of these nodes, `before` the members of the ring before.
  void collect(const NodeBits& members, const NodeBits& before,
               Ring& kept) const;
  void clear_work();

  /// Sum of w field over the eight neighbours of the ring's node k.
  float around(const Ring& ring, std::size_t k, const float* field) const;
  template <class DoNodes>
  void each_chunk(const Ring& ring, const DoNodes& do_nodes) const;

  Grid grid_;
  int threads_;
  bool is_built_ = false;
  std::vector<Ring> rings_; ///< 0: the free nodes that touch ring 1
  std::vector<float> values_;
  std::vector<float> work_; ///< what the rings done pass on; else 0
};

} // namespace asperity::contact
