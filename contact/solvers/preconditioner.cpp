#include "contact/solvers/preconditioner.hpp"

#include "base/parallel_rows.hpp"
#include "base/ranks/chunked_sum.hpp"

#include <algorithm>
#include <cstddef>

namespace asperity::contact {
namespace {

/// Copies rows of n nodes, which are `from_stride` and `to_stride` nodes apart.
template <class Value>
void copy_rows(const Grid& rows, int threads, const Value* from,
               int from_stride, Value* to, int to_stride) {
  parallel_rows(rows.points_y, threads, [=](int iy) {
    const auto row = static_cast<std::ptrdiff_t>(iy);
    std::copy_n(from + row * from_stride, rows.points_x, to + row * to_stride);
  });
}

} // namespace

Preconditioner::Preconditioner(const SurfaceOperator& elasticity)
    : grid_(elasticity.grid()),
      wide_grid_(elasticity.wide_grid()),
      threads_(elasticity.threads()),
      extension_(wide_grid_, elasticity.workers(),
                 elasticity.is_mirrored() ? Continuation::mirrored
                                          : Continuation::periodic) {
  if (wide_grid_ == grid_)
    return;
  const std::size_t nodes = wide_grid_.size();
  wide_.freedom.resize(nodes);
  wide_.blocks.resize(blocks_of(nodes));
  wide_.residual.resize(nodes);
  wide_.extended.resize(nodes);
}

template <class Value>
void Preconditioner::widen(std::span<const Value> field,
                           std::span<Value> wide) const {
  copy_rows(grid_, threads_, field.data(), grid_.points_x, wide.data(),
            wide_grid_.points_x);
}

void Preconditioner::build(const SurfaceOperator& elasticity,
                           double local_compliance,
                           const BoundaryExtension::Active& active) {
  const double short_wave = elasticity.short_wave_compliance();
  const double share = short_wave / (short_wave + local_compliance);
  if (!is_wide()) {
    extension_.build(share, active.is_free);
    return;
  }
  std::vector<std::uint8_t>& freedom = wide_.freedom;
  widen<std::uint8_t>(active.is_free, freedom);
  chunked(freedom.size(), threads_, [&](std::size_t begin, std::size_t end) {
    each_block(begin, end,
               [&](std::size_t block, std::size_t first, std::size_t last) {
                 std::uint8_t any = 0;
                 for (std::size_t i = first; i < last; ++i)
                   any |= freedom[i];
                 wide_.blocks[block] = any > 0 ? 1 : 0;
               });
  });
  extension_.build(share, freedom);
}

void Preconditioner::apply(SurfaceOperator& elasticity, double local_compliance,
                           const BoundaryExtension::Active& active,
                           std::span<const float> residual,
                           std::span<float> extended,
                           std::span<float> estimate) {
  if (!is_wide()) {
    extension_.extend(active, residual, extended);
    elasticity.pressure_estimate(extended, local_compliance, estimate);
    extension_.fold(active, estimate);
    return;
  }
  const BoundaryExtension::Active wide_active{wide_.freedom, wide_.blocks};
  widen<float>(residual, wide_.residual);
  extension_.extend(wide_active, wide_.residual, wide_.extended);
  elasticity.pressure_estimate(wide_.extended, local_compliance,
                               wide_.extended);
  extension_.fold(wide_active, wide_.extended);
  copy_rows(grid_, threads_, wide_.extended.data(), wide_grid_.points_x,
            estimate.data(), grid_.points_x);
}

} // namespace asperity::contact
