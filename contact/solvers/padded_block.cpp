#include "contact/solvers/padded_block.hpp"

#include <algorithm>

namespace asperity::contact {
namespace {

/// Copies a field if there is one, and returns the place of the copy.
template <class Value>
Value* copied(const Value* field, std::size_t nodes,
              std::array<Value, block_nodes>& values) {
  if (field == nullptr)
    return nullptr;
  std::copy_n(field, nodes, values.begin());
  return values.data();
}

} // namespace

PaddedBlock::PaddedBlock(const NodeFields& part) {
  const std::size_t n = part.nodes;
  doubles_[0].fill(1.0);
  doubles_[2].fill(1e300); // sums of them are finite
  fields_ = {block_nodes,
             part.weight != nullptr ? copied(part.weight, n, doubles_[0])
                                    : doubles_[0].data(),
             copied(part.pressure, n, doubles_[1]),
             copied(part.raw_gap, n, doubles_[2]),
             copied(part.residual, n, floats_[0]),
             copied(part.previous_residual, n, floats_[1]),
             copied(part.freedom, n, freedom_),
             copied(part.preconditioned, n, floats_[2]),
             copied(part.direction, n, floats_[3]),
             copied(part.displaced, n, floats_[4]),
             copied(part.change, n, floats_[5]),
             copied(part.heights, n, doubles_[3]),
             part.product_scale};
}

void PaddedBlock::copy_back(const NodeFields& part) const {
  const std::size_t n = part.nodes;
  const auto copy = [n](const auto& values, auto* field) {
    if (field != nullptr)
      std::copy_n(values.begin(), n, field);
  };
  copy(doubles_[1], part.pressure);
  copy(doubles_[2], part.raw_gap);
  copy(floats_[0], part.residual);
  copy(freedom_, part.freedom);
  copy(floats_[3], part.direction);
  copy(floats_[5], part.change);
}

} // namespace asperity::contact
