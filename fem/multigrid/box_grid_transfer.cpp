#include "fem/multigrid/box_grid_transfer.hpp"

#include "fem/multigrid/box_grid_levels.hpp"

#include <algorithm>

namespace asperity::fem {
namespace {

void add_multiple(double weight, const float* from, std::size_t size,
                  float* to) {
  const auto factor = static_cast<float>(weight);
  for (std::size_t i = 0; i < size; ++i)
    to[i] += factor * from[i];
}

/// The ranks that receive all of a coarse grid of boxes of which they share the
/// fine one.
RankGroup* gathering(const BoxGridSlab& fine, const BoxGridSlab& coarse) {
  return coarse.is_shared() ? nullptr : fine.ranks();
}

} // namespace

BoxGridTransfer::BoxGridTransfer(const BoxGrid& fine,
                                 const BoxGridSlab& fine_slab,
                                 const BoxGrid& coarse,
                                 const BoxGridSlab& coarse_slab)
    : LevelTransfer(gathering(fine_slab, coarse_slab)),
      fine_(fine_slab.layout(fine)),
      coarse_(coarse_slab.layout(coarse)) {
  const auto from = axes_of(coarse);
  const auto to = axes_of(fine);
  const bool is_gathered = gathering(fine_slab, coarse_slab) != nullptr;
  const BoxGridAxis from_y = coarse_slab.axis_y(coarse);
  const BoxGridAxis to_y = is_gathered ? to[1] : fine_slab.axis_y(fine);
  const std::size_t first =
      is_gathered ? fine_.degree() * static_cast<std::size_t>(fine_slab.first())
                  : 0;
  const SparseRows along_y = interpolation(from_y, to_y);
  weights_ = {
      interpolation(from[0], to[0]),
      some_rows(along_y, first, static_cast<std::size_t>(fine_.nodes_y())),
      interpolation(from[2], to[2])};
  for (const std::size_t axis : {0U, 1U, 2U})
    transposed_[axis] = transposed(
        weights_[axis], axis == 1 ? from_y.nodes() : from[axis].nodes());
  const std::size_t slices = fine_slab.is_shared()
                                 ? fine_.slices()
                                 : static_cast<std::size_t>(fine_.nodes_y());
  add_contact(some_rows(along_y, first, slices), nearest_fine(from[0], to[0]),
              nearest_fine(from_y, to_y), first);
}

/// @param along_y    the interpolation to the slices of this rank and the image
///                   slice, where its cells may have springs
/// @param nearest_x, nearest_y  the fine nodes nearest to coarse ones
/// @param first      slice of this rank in the numbers of nearest_y
void BoxGridTransfer::add_contact(const SparseRows& along_y,
                                  const std::vector<std::size_t>& nearest_x,
                                  const std::vector<std::size_t>& nearest_y,
                                  std::size_t first) {
  const auto normal = [](const NodeLayout& layout, std::size_t x,
                         std::size_t y) {
    return layout.index(static_cast<int>(x), static_cast<int>(y), 0, 2);
  };
  const SparseRows& along_x = weights_[0];
  for (std::size_t y = 0; y < along_y.rows(); ++y)
    for (std::size_t x = 0; x < along_x.rows(); ++x) {
      contact().add_node(normal(fine_, x, y));
      for (std::size_t j = along_y.start[y]; j < along_y.start[y + 1]; ++j)
        for (std::size_t i = along_x.start[x]; i < along_x.start[x + 1]; ++i)
          contact().add_master(
              normal(coarse_, along_x.column[i], along_y.column[j]),
              along_y.weight[j] * along_x.weight[i]);
    }
  const auto own = static_cast<std::size_t>(fine_.nodes_y());
  for (std::size_t y = 0; y < nearest_y.size(); ++y)
    for (std::size_t x = 0; x < nearest_x.size(); ++x)
      if (nearest_y[y] >= first && nearest_y[y] < first + own)
        contact().add_held(normal(fine_, nearest_x[x], nearest_y[y] - first),
                           normal(coarse_, x, y));
  contact().finish();
}

/// Adds the product of the matrix with one row of nodes, for each component.
void BoxGridTransfer::add_along_x(const SparseRows& matrix, const float* from,
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

void BoxGridTransfer::add_product(const std::array<SparseRows, 3>& matrices,
                                  const NodeLayout& from_layout,
                                  const std::vector<float>& from,
                                  const NodeLayout& to_layout,
                                  std::vector<float>& to) {
  slice_.resize(from_layout.slice_size());
  row_.resize(from_layout.row_size());
  const auto& [x, y, z] = matrices;
  for (std::size_t j = 0; j < y.rows(); ++j) {
    if (y.start[j] == y.start[j + 1])
      continue; // a slice to which other ranks contribute
    std::fill(slice_.begin(), slice_.end(), 0.0F);
    for (std::size_t i = y.start[j]; i < y.start[j + 1]; ++i)
      add_multiple(y.weight[i], &from[y.column[i] * slice_.size()],
                   slice_.size(), slice_.data());
    for (std::size_t k = 0; k < z.rows(); ++k) {
      std::fill(row_.begin(), row_.end(), 0.0F);
      for (std::size_t i = z.start[k]; i < z.start[k + 1]; ++i)
        add_multiple(z.weight[i], &slice_[z.column[i] * row_.size()],
                     row_.size(), row_.data());
      add_along_x(x, row_.data(), from_layout.stride(),
                  &to[j * to_layout.slice_size() + k * to_layout.row_size()],
                  to_layout.stride());
    }
  }
}

std::size_t BoxGridTransfer::bytes() const {
  return (slice_.size() + row_.size()) * sizeof(float) + contact().bytes();
}

} // namespace asperity::fem
