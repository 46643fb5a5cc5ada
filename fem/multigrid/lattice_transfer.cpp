#include "fem/multigrid/lattice_transfer.hpp"

#include "fem/multigrid/lattice_levels.hpp"

#include <algorithm>

namespace asperity::fem {
namespace {

void add_multiple(double weight, const float* from, std::size_t size,
                  float* to) {
  const auto factor = static_cast<float>(weight);
  for (std::size_t i = 0; i < size; ++i)
    to[i] += factor * from[i];
}

} // namespace

LatticeTransfer::LatticeTransfer(const BoxLattice& fine,
                                 const BoxLattice& coarse)
    : fine_(fine), coarse_(coarse) {
  const auto from = axes_of(coarse);
  const auto to = axes_of(fine);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    weights_[axis] = interpolation(from[axis], to[axis]);
    transposed_[axis] = transposed(weights_[axis], from[axis].nodes());
  }
}

/// Adds the product of the matrix with one row of nodes, for each component.
void LatticeTransfer::add_along_x(const SparseRows& matrix, const float* from,
                                  std::size_t from_stride, float* to,
                                  std::size_t to_stride) const {
  const std::size_t degree = fine_.degree();
  for (std::size_t c = 0; c < 3; ++c) {
    const float* const own_from = from + c * degree * from_stride;
    float* const own_to = to + c * degree * to_stride;
    for (std::size_t row = 0; row < matrix.rows(); ++row) {
      double sum = 0.0;
      for (std::size_t i = matrix.start[row]; i < matrix.start[row + 1]; ++i) {
        const std::size_t x = matrix.column[i];
        sum += matrix.weight[i] *
               static_cast<double>(
                   own_from[x % degree * from_stride + x / degree]);
      }
      own_to[row % degree * to_stride + row / degree] +=
          static_cast<float>(sum);
    }
  }
}

void LatticeTransfer::restrict_force(const std::vector<float>& fine,
                                     std::vector<float>& coarse) {
  multiply(transposed_, fine_, fine, coarse_, coarse);
}

void LatticeTransfer::interpolate(const std::vector<float>& coarse,
                                  std::vector<float>& fine) {
  multiply(weights_, coarse_, coarse, fine_, fine);
}

void LatticeTransfer::multiply(const std::array<SparseRows, 3>& matrices,
                               const NodeLayout& from_layout,
                               const std::vector<float>& from,
                               const NodeLayout& to_layout,
                               std::vector<float>& to) {
  std::fill(to.begin(), to.end(), 0.0F);
  plane_.resize(from_layout.plane_size());
  row_.resize(from_layout.row_size());
  const auto& [x, y, z] = matrices;
  for (std::size_t k = 0; k < z.rows(); ++k) {
    std::fill(plane_.begin(), plane_.end(), 0.0F);
    for (std::size_t i = z.start[k]; i < z.start[k + 1]; ++i)
      add_multiple(z.weight[i], &from[z.column[i] * plane_.size()],
                   plane_.size(), plane_.data());
    for (std::size_t j = 0; j < y.rows(); ++j) {
      std::fill(row_.begin(), row_.end(), 0.0F);
      for (std::size_t i = y.start[j]; i < y.start[j + 1]; ++i)
        add_multiple(y.weight[i], &plane_[y.column[i] * row_.size()],
                     row_.size(), row_.data());
      add_along_x(x, row_.data(), from_layout.stride(),
                  &to[k * to_layout.plane_size() + j * to_layout.row_size()],
                  to_layout.stride());
    }
  }
}

std::size_t LatticeTransfer::bytes() const {
  return (plane_.size() + row_.size()) * sizeof(float);
}

} // namespace asperity::fem
