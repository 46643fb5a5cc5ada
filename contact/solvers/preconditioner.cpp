#include "contact/solvers/preconditioner.hpp"

#include "base/parallel_rows.hpp"
#include "base/ranks/chunked_sum.hpp"

#include <algorithm>
#include <cstddef>

namespace asperity::contact {

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
}

template <class Value>
void Preconditioner::widen(std::span<const Value> field,
                           std::span<Value> wide) const {
  parallel_rows(wide_grid_.points_y, threads_, [&](int iy) {
    Value* const row = &wide[wide_grid_.index(0, iy)];
    const int held = iy < grid_.points_y ? grid_.points_x : 0;
    if (held > 0)
      std::copy_n(&field[grid_.index(0, iy)], held, row);
    std::fill(row + held, row + wide_grid_.points_x, Value{0});
  });
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

/// In rounds, in which no row is moved to where another one comes from.
void Preconditioner::narrow(std::span<float> wide) const {
  int begin = 1;
  while (begin < grid_.points_y) {
    const auto before_source =
        static_cast<int>(static_cast<std::int64_t>(begin) *
                         wide_grid_.points_x / grid_.points_x);
    const int end = std::clamp(before_source, begin + 1, grid_.points_y);
    parallel_rows(end - begin, threads_, [&](int i) {
      std::copy_n(&wide[wide_grid_.index(0, begin + i)], grid_.points_x,
                  &wide[grid_.index(0, begin + i)]);
    });
    begin = end;
  }
}

void Preconditioner::apply(SurfaceOperator& elasticity, double local_compliance,
                           const BoundaryExtension::Active& active,
                           std::span<const float> residual,
                           std::span<float> scratch) {
  if (!is_wide()) {
    const std::span<float> field = scratch.first(residual.size());
    extension_.extend(active, residual, field);
    elasticity.pressure_estimate(field, local_compliance, field);
    extension_.fold(active, field);
    return;
  }
  const std::span<float> field = scratch.first(wide_grid_.size());
  const BoundaryExtension::Active wide_active{wide_.freedom, wide_.blocks};
  widen<float>(residual, field);
  extension_.extend(wide_active, field, field);
  elasticity.pressure_estimate(field, local_compliance, field);
  extension_.fold(wide_active, field);
  narrow(field);
}

} // namespace asperity::contact
