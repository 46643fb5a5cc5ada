#pragma once

// A copy of an incomplete block of nodes, so that the loops of node_kernels.hpp
// need no code for it.

#include "contact/solvers/node_blocks.hpp"
#include "contact/solvers/node_kernels.hpp"

#include <array>
#include <cstdint>

namespace asperity::contact {

/// A copy of the fields of a block that has fewer nodes than others. Fields of
/// the missing nodes are 0, except raw_gap, which is so large that these nodes
/// are inactive. There are weights, also if they are equal.
class PaddedBlock {
public:
  explicit PaddedBlock(const NodeFields& part);

  const NodeFields& fields() const { return fields_; }

  /// Copies what a loop may have changed.
  void copy_back(const NodeFields& part) const;

private:
  std::array<std::array<double, block_nodes>, 4> doubles_{};
  std::array<std::array<float, block_nodes>, 6> floats_{};
  std::array<std::uint8_t, block_nodes> freedom_{};
  NodeFields fields_;
};

} // namespace asperity::contact
