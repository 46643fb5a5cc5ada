#include "fem/multigrid/lattice_transfer.hpp"

#include "fem/multigrid/lattice_levels.hpp"

#include <algorithm>

#include "ranks/value_exchange.hpp"

namespace asperity::fem {
namespace {

void add_multiple(double weight, const float* from, std::size_t size,
                  float* to) {
  const auto factor = static_cast<float>(weight);
  for (std::size_t i = 0; i < size; ++i)
    to[i] += factor * from[i];
}

/// The interpolation along y to the fine nodes of a rank.
/// @param all  to all fine nodes
SparseRows rows_of_rank(const SparseRows& all, const LatticeSlab& slab,
                        std::size_t rank, std::size_t degree) {
  const auto first = degree * static_cast<std::size_t>(slab.bounds()[rank]);
  const bool is_last = rank + 2 == slab.bounds().size();
  const auto end =
      is_last ? all.rows()
              : degree * static_cast<std::size_t>(slab.bounds()[rank + 1]);
  return some_rows(all, first, end - first);
}

} // namespace

LatticeTransfer::LatticeTransfer(const BoxLattice& fine,
                                 const LatticeSlab& fine_slab,
                                 const BoxLattice& coarse,
                                 const LatticeSlab& coarse_slab)
    : fine_(fine_slab.layout(fine)),
      coarse_(coarse_slab.layout(coarse)),
      fine_slab_(fine_slab),
      coarse_slab_(coarse_slab) {
  const auto from = axes_of(coarse);
  const auto to = axes_of(fine);
  for (const std::size_t axis : {0U, 2U}) {
    weights_[axis] = interpolation(from[axis], to[axis]);
    transposed_[axis] = transposed(weights_[axis], from[axis].nodes());
  }
  const bool is_gathered = fine_slab.is_shared() && !coarse_slab.is_shared();
  const LatticeAxis from_y = coarse_slab.axis_y(coarse);
  const SparseRows along_y =
      interpolation(from_y, is_gathered ? to[1] : fine_slab.axis_y(fine));
  if (is_gathered) {
    weights_[1] = rows_of_rank(
        along_y, fine_slab, static_cast<std::size_t>(fine_slab.ranks()->rank()),
        fine_.degree());
    find_rows_of_ranks(along_y);
  } else {
    weights_[1] =
        some_rows(along_y, 0, static_cast<std::size_t>(fine_.nodes_y()));
  }
  transposed_[1] = transposed(weights_[1], from_y.nodes());
}

/// @param along_y  the interpolation to all fine rows
void LatticeTransfer::find_rows_of_ranks(const SparseRows& along_y) {
  for (std::size_t r = 0; r + 1 < fine_slab_.bounds().size(); ++r) {
    auto& rows = rows_of_ranks_.emplace_back(
        rows_of_rank(along_y, fine_slab_, r, fine_.degree()).column);
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  }
}

/// Sets the coarse force to the sum of those of all ranks.
void LatticeTransfer::add_rows_of_ranks(std::vector<float>& coarse) const {
  const std::size_t n = coarse_.row_size();
  const auto visit = [&](std::size_t rank, const auto& act) {
    for (std::size_t plane = 0; plane < coarse_.planes(); ++plane)
      for (const std::size_t row : rows_of_ranks_[rank])
        act(plane * coarse_.plane_size() + row * n);
  };
  std::vector<float> own;
  visit(static_cast<std::size_t>(fine_slab_.ranks()->rank()),
        [&](std::size_t at) {
          own.insert(own.end(), &coarse[at], &coarse[at] + n);
        });
  const ValueExchange forces(*fine_slab_.ranks(), own.size());
  const std::vector<float> all = forces.sent(std::span<const float>(own));
  std::fill(coarse.begin(), coarse.end(), 0.0F);
  std::size_t next = 0;
  for (std::size_t r = 0; r < rows_of_ranks_.size(); ++r)
    visit(r, [&](std::size_t at) {
      for (std::size_t i = 0; i < n; ++i)
        coarse[at + i] += all[next++];
    });
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
  if (coarse_slab_.is_shared())
    fold_images(coarse_, coarse_slab_, coarse.data());
  else if (fine_slab_.is_shared())
    add_rows_of_ranks(coarse);
}

void LatticeTransfer::interpolate(std::vector<float>& coarse,
                                  std::vector<float>& fine) {
  if (coarse_slab_.is_shared())
    write_images(coarse_, coarse_slab_, coarse.data());
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
      if (y.start[j] == y.start[j + 1])
        continue; // a row to which other ranks contribute
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
