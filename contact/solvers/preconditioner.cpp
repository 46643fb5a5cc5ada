#include "contact/solvers/preconditioner.hpp"

#include "base/parallel_rows.hpp"
#include "ranks/moved_rows.hpp"

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

SharedRows rows_or_all(const SharedRows* shared, const Grid& grid) {
  return shared != nullptr ? *shared : SharedRows(grid);
}

} // namespace

Preconditioner::Preconditioner(const SurfaceOperator& elasticity)
    : rows_(rows_or_all(elasticity.shared_rows(), elasticity.grid())),
      wide_rows_(
          rows_or_all(elasticity.wide_shared_rows(), elasticity.wide_grid())),
      threads_(elasticity.threads()),
      extension_(elasticity.wide_grid(), {threads_, elasticity.wide_grid(),
                                          elasticity.wide_shared_rows()}) {
  if (wide_rows_.grid() == rows_.grid())
    return;
  const std::size_t nodes = wide_rows_.size();
  wide_.freedom.resize(nodes);
  wide_.blocks.resize(blocks_of(nodes));
  wide_.residual.resize(nodes);
  wide_.extended.resize(nodes);
}

Grid Preconditioner::held_part() const {
  Grid part = rows_.grid();
  part.points_y =
      std::clamp(part.points_y - wide_rows_.first(), 0, wide_rows_.count());
  return part;
}

template <class Value>
void Preconditioner::widen(std::span<const Value> field,
                           std::span<Value> scratch,
                           std::span<Value> wide) const {
  if (rows_.ranks() != nullptr) {
    move_rows(rows_, wide_rows_, rows_.width(), field, scratch);
    field = scratch;
  }
  const Grid part = held_part();
  copy_rows(part, threads_, field.data(), part.points_x, wide.data(),
            wide_rows_.grid().points_x);
}

void Preconditioner::narrow(std::span<const float> wide,
                            std::span<float> scratch,
                            std::span<float> field) const {
  const Grid part = held_part();
  const bool has_ranks = rows_.ranks() != nullptr;
  copy_rows(part, threads_, wide.data(), wide_rows_.grid().points_x,
            has_ranks ? scratch.data() : field.data(), part.points_x);
  if (has_ranks)
    move_rows<float>(wide_rows_, rows_, rows_.width(), scratch, field);
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
  std::vector<std::uint8_t> scratch(rows_.ranks() != nullptr ? freedom.size()
                                                             : 0);
  widen<std::uint8_t>(active.is_free, scratch, freedom);
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
  widen<float>(residual, wide_.extended, wide_.residual);
  extension_.extend(wide_active, wide_.residual, wide_.extended);
  elasticity.wide_pressure_estimate(wide_.extended, local_compliance,
                                    wide_.extended);
  extension_.fold(wide_active, wide_.extended);
  narrow(wide_.extended, wide_.residual, estimate);
  if (rows_.ranks() != nullptr) // the added nodes have no residual
    std::ranges::fill(wide_.residual, 0.0F);
}

} // namespace asperity::contact
