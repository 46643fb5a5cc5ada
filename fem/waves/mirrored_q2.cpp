#include "fem/waves/mirrored_q2.hpp"

#include <algorithm>
#include <array>

namespace asperity::fem {
namespace {

constexpr std::size_t n_lateral = 8; // lateral components, p
constexpr std::size_t n_normal = 4;  // u_z, v, which follow them
constexpr std::size_t n_plane = n_lateral + n_normal;

// Offsets of the blocks of (Q2.4), which are stored one after the other.
// Symmetric blocks are stored as lower triangles.
constexpr std::size_t first_tt = 0;                            // S_tt
constexpr std::size_t first_tb = first_tt + triangle(n_plane); // S_tb P
constexpr std::size_t first_pp = first_tb + triangle(n_plane);
constexpr std::size_t first_vv = first_pp + triangle(n_lateral);
constexpr std::size_t first_x = first_vv + triangle(n_normal);
constexpr std::size_t first_y = first_x + n_lateral * n_plane;
constexpr std::size_t layer_packs = first_y + n_normal * n_plane;

using LayerBlocks = std::array<SimdBatch, layer_packs>;

LayerSymbol::Target mirrored_blocks(std::size_t row, std::size_t column) {
  const auto place = [](std::size_t unknown) { // index in its plane: p, then v
    const std::size_t node_class = unknown % n_plane / 3,
                      component = unknown % 3;
    return component == 2 ? n_lateral + node_class : 2 * node_class + component;
  };
  constexpr std::size_t below = 0, middle = 1, above = 2;
  const std::size_t from = row / n_plane, to = column / n_plane;
  const std::size_t i = place(row), j = place(column);
  if (from == above && to == above && i >= j)
    return {first_tt + in_triangle(n_plane, i, j)};
  if (from == above && to == below && i >= j)
    return {first_tb + in_triangle(n_plane, i, j), j >= n_lateral ? -1.0 : 1.0};
  if (from == middle && to == middle && i >= j && i < n_lateral)
    return {first_pp + in_triangle(n_lateral, i, j)};
  if (from == middle && to == middle && i >= j && j >= n_lateral)
    return {first_vv + in_triangle(n_normal, i - n_lateral, j - n_lateral)};
  if (from == middle && to == above)
    return {i < n_lateral ? first_x + i * n_plane + j
                          : first_y + (i - n_lateral) * n_plane + j};
  return {};
}

/// Applies (Q2.4): F and H overwrite S_tt and S_tb P.
[[gnu::always_inline]] inline void eliminate_middle(LayerBlocks& layer) {
  std::array<SimdBatch, triangle(n_plane)> even{}, odd{};
  factorise<n_lateral>(&layer[first_pp]);
  solve_lower<n_lateral, n_plane>(&layer[first_pp], &layer[first_x]);
  take_schur<n_lateral, n_plane>(&layer[first_pp], &layer[first_x],
                                 even.data());
  factorise<n_normal>(&layer[first_vv]);
  solve_lower<n_normal, n_plane>(&layer[first_vv], &layer[first_y]);
  take_schur<n_normal, n_plane>(&layer[first_vv], &layer[first_y], odd.data());
  for (std::size_t i = 0; i < triangle(n_plane); ++i) {
    layer[first_tt + i] += even[i] + odd[i];
    layer[first_tb + i] += even[i] - odd[i];
  }
}

/// Writes the identity into the rows of held components and adds springs to the
/// uniform modes of the others.
inline void hold_far_boundary(mechanics::FarBoundary far_boundary,
                              const SimdBatch& spring, SimdBatch* matrix,
                              SimdBatch* rows) {
  const auto component = [](std::size_t i) {
    return i < n_lateral ? i % 2 : std::size_t{2};
  };
  for (std::size_t i = 0; i < n_plane; ++i) {
    if (!holds(far_boundary, component(i))) {
      for (std::size_t j = 0; j <= i; ++j)
        if (component(j) == component(i))
          matrix[in_triangle(n_plane, i, j)] += spring;
      continue;
    }
    for (std::size_t j = 0; j < n_plane; ++j)
      matrix[in_triangle(n_plane, std::max(i, j), std::min(i, j))] =
          SimdBatch{};
    matrix[in_triangle(n_plane, i, i)] += 1.0;
    std::fill_n(rows + i * n_plane, n_plane, SimdBatch{});
  }
}

/// Applies (Q2.5): T_(l+1) in `stiffness` becomes T_l.
[[gnu::always_inline]] inline void
take_layer(const LayerBlocks& layer, const mechanics::FarBoundary* far_boundary,
           const SimdBatch& spring, SimdBatch* stiffness) {
  std::array<SimdBatch, triangle(n_plane)> matrix;
  std::array<SimdBatch, n_plane * n_plane> rows;
  for (std::size_t i = 0; i < triangle(n_plane); ++i)
    matrix[i] = layer[first_tt + i] + stiffness[i];
  for (std::size_t i = 0; i < n_plane; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      rows[i * n_plane + j] = rows[j * n_plane + i] =
          layer[first_tb + in_triangle(n_plane, i, j)];
  if (far_boundary)
    hold_far_boundary(*far_boundary, spring, matrix.data(), rows.data());
  factorise<n_plane>(matrix.data());
  solve_lower<n_plane, n_plane>(matrix.data(), rows.data());
  std::copy_n(&layer[first_tt], triangle(n_plane), stiffness);
  take_schur<n_plane, n_plane>(matrix.data(), rows.data(), stiffness);
  for (std::size_t i = n_lateral; i < n_plane; ++i)
    for (std::size_t j = 0; j < n_lateral; ++j)
      stiffness[in_triangle(n_plane, i, j)] =
          -stiffness[in_triangle(n_plane, i, j)];
}

/// Computes (T_0^-1)_zz; T_0 is overwritten.
[[gnu::always_inline]] inline void normal_compliance(SimdBatch* stiffness,
                                                     SimdBatch* block) {
  std::array<SimdBatch, n_plane * n_normal> load{};
  for (std::size_t node_class = 0; node_class < n_normal; ++node_class)
    load[(n_lateral + node_class) * n_normal + node_class] += 1.0;
  factorise<n_plane>(stiffness);
  solve_lower<n_plane, n_normal>(stiffness, load.data());
  for (std::size_t i = 0; i < n_normal; ++i)
    for (std::size_t j = 0; j < n_normal; ++j) {
      SimdBatch sum{};
      for (std::size_t k = n_lateral; k < n_plane;
           ++k) // the rows above are zero
        sum += load[k * n_normal + i] * load[k * n_normal + j] *
               stiffness[in_triangle(n_plane, k, k)];
      block[i * n_normal + j] = sum;
    }
}

/// The block, evaluated at four wavevectors.
struct Waves {
  mechanics::FarBoundary far_boundary;
  const BlockSymbol& layers;
  const SimdBatch* materials;
  SimdBatch spring;
};

[[gnu::always_inline]] inline void eliminate(const Waves& waves,
                                             SimdBatch* block) {
  std::array<SimdBatch, triangle(n_plane)> stiffness{};
  LayerBlocks layer;
  for (std::size_t l = waves.layers.layers(); l-- > 0;) {
    waves.layers.evaluate(l, waves.materials, layer.data());
    eliminate_middle(layer);
    take_layer(layer, waves.layers.is_last(l) ? &waves.far_boundary : nullptr,
               waves.spring, stiffness.data());
  }
  normal_compliance(stiffness.data(), block);
}

void eliminate_on_any(const Waves& waves, SimdBatch* block) {
  eliminate(waves, block);
}

#ifdef __x86_64__
/// Compiled for four numbers per instruction, but without fused multiply-add,
/// so that the result is bitwise the same.
[[gnu::target("avx2")]] void eliminate_on_avx2(const Waves& waves,
                                               SimdBatch* block) {
  eliminate(waves, block);
}
#endif

auto eliminate_here() {
#ifdef __x86_64__
  if (has_avx2())
    return eliminate_on_avx2;
#endif
  return eliminate_on_any;
}

} // namespace

MirroredQ2::MirroredQ2(const Grid& grid, const LayeredBlock& block)
    : far_boundary_(block.far_boundary),
      layers_(grid, 2, block, layer_packs, mirrored_blocks) {}

void MirroredQ2::face_compliance(const SimdBatch& theta_x,
                                 const SimdBatch& theta_y,
                                 const SimdBatch& spring,
                                 SimdBatch* block) const {
  static const auto eliminate_waves = eliminate_here();
  const SimdBatches materials = layers_.at(theta_x, theta_y);
  eliminate_waves({far_boundary_, layers_, materials.data(), spring}, block);
}

} // namespace asperity::fem
