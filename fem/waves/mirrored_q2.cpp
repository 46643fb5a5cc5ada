#include "fem/waves/mirrored_q2.hpp"

#include "fem/waves/lattice_factors.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace asperity::fem {
namespace {

constexpr std::size_t flat = 8;    // in-plane components, p
constexpr std::size_t upright = 4; // u_z, v, which follow them
constexpr std::size_t plane = flat + upright;

// Offsets of the blocks of (Q2.4), which are stored one after the other.
// Symmetric blocks are stored as lower triangles.
constexpr std::size_t own = 0;                        // S_tt
constexpr std::size_t across = own + triangle(plane); // S_tb P
constexpr std::size_t middle_flat = across + triangle(plane);
constexpr std::size_t middle_upright = middle_flat + triangle(flat);
constexpr std::size_t x_rows = middle_upright + triangle(upright);
constexpr std::size_t y_rows = x_rows + flat * plane;
constexpr std::size_t layer_packs = y_rows + upright * plane;

using LayerBlocks = std::array<SimdBatch, layer_packs>;

LayerSymbol::Target mirrored_blocks(std::size_t row, std::size_t column) {
  const auto place = [](std::size_t unknown) { // index in its plane: p, then v
    const std::size_t kind = unknown % plane / 3, component = unknown % 3;
    return component == 2 ? flat + kind : 2 * kind + component;
  };
  constexpr std::size_t below = 0, middle = 1, above = 2;
  const std::size_t from = row / plane, to = column / plane;
  const std::size_t i = place(row), j = place(column);
  if (from == above && to == above && i >= j)
    return {own + in_triangle(plane, i, j)};
  if (from == above && to == below && i >= j)
    return {across + in_triangle(plane, i, j), j >= flat ? -1.0 : 1.0};
  if (from == middle && to == middle && i >= j && i < flat)
    return {middle_flat + in_triangle(flat, i, j)};
  if (from == middle && to == middle && i >= j && j >= flat)
    return {middle_upright + in_triangle(upright, i - flat, j - flat)};
  if (from == middle && to == above)
    return {i < flat ? x_rows + i * plane + j
                     : y_rows + (i - flat) * plane + j};
  return {};
}

/// Splits the entries of a cell matrix by their dependence on the thickness t:
/// those between p and p or v and v are C t + A/t, those between p and v are
/// constant.
struct ThicknessParts {
  CellStiffness growing, falling, constant; ///< at the thickness of `layer`

  ThicknessParts(const Grid& grid, ElasticLayer layer) {
    const double dx = 2.0 * grid.spacing_x(), dy = 2.0 * grid.spacing_y();
    growing = falling = constant = cell_stiffness(2, dx, dy, layer);
    layer.thickness *= 2.0;
    const CellStiffness doubled = cell_stiffness(2, dx, dy, layer);
    const std::size_t size = growing.size();
    for (std::size_t i = 0; i < size * size; ++i) {
      const double single = constant.entries[i];
      if ((i / size % 3 == 2) != (i % size % 3 == 2)) {
        growing.entries[i] = falling.entries[i] = 0.0;
        continue;
      }
      growing.entries[i] = (2.0 * doubled.entries[i] - single) / 3.0;
      falling.entries[i] = single - growing.entries[i];
      constant.entries[i] = 0.0;
    }
  }
};

/// The three symbols of a material at four wavevectors.
struct MaterialBlocks {
  LayerBlocks growing, falling, constant;

  MaterialBlocks(const MirroredQ2::Material& material,
                 const WaveProducts& products) {
    material.growing.evaluate(products, growing.data());
    material.falling.evaluate(products, falling.data());
    material.constant.evaluate(products, constant.data());
  }

  [[gnu::always_inline]] void stretched(double stretch,
                                        LayerBlocks& layer) const {
    const double inverse = 1.0 / stretch;
    for (std::size_t i = 0; i < layer_packs; ++i)
      layer[i] = growing[i] * stretch + falling[i] * inverse + constant[i];
  }
};

/// Applies (Q2.4): F and H overwrite S_tt and S_tb P.
[[gnu::always_inline]] inline void eliminate_middle(LayerBlocks& layer) {
  std::array<SimdBatch, triangle(plane)> even{}, odd{};
  factorise<flat>(&layer[middle_flat]);
  solve_lower<flat, plane>(&layer[middle_flat], &layer[x_rows]);
  take_schur<flat, plane>(&layer[middle_flat], &layer[x_rows], even.data());
  factorise<upright>(&layer[middle_upright]);
  solve_lower<upright, plane>(&layer[middle_upright], &layer[y_rows]);
  take_schur<upright, plane>(&layer[middle_upright], &layer[y_rows],
                             odd.data());
  for (std::size_t i = 0; i < triangle(plane); ++i) {
    layer[own + i] += even[i] + odd[i];
    layer[across + i] += even[i] - odd[i];
  }
}

/// Writes the identity into the rows of held components and adds springs to the
/// uniform modes of the others.
inline void hold_top(mechanics::FarBoundary top, const SimdBatch& spring,
                     SimdBatch* matrix, SimdBatch* rows) {
  const auto component = [](std::size_t i) {
    return i < flat ? i % 2 : std::size_t{2};
  };
  for (std::size_t i = 0; i < plane; ++i) {
    if (!holds(top, component(i))) {
      for (std::size_t j = 0; j <= i; ++j)
        if (component(j) == component(i))
          matrix[in_triangle(plane, i, j)] += spring;
      continue;
    }
    for (std::size_t j = 0; j < plane; ++j)
      matrix[in_triangle(plane, std::max(i, j), std::min(i, j))] = SimdBatch{};
    matrix[in_triangle(plane, i, i)] += 1.0;
    std::fill_n(rows + i * plane, plane, SimdBatch{});
  }
}

/// Applies (Q2.5): T_(l+1) in `stiffness` becomes T_l.
[[gnu::always_inline]] inline void take_layer(const LayerBlocks& layer,
                                              const mechanics::FarBoundary* top,
                                              const SimdBatch& spring,
                                              SimdBatch* stiffness) {
  std::array<SimdBatch, triangle(plane)> matrix;
  std::array<SimdBatch, plane * plane> rows;
  for (std::size_t i = 0; i < triangle(plane); ++i)
    matrix[i] = layer[own + i] + stiffness[i];
  for (std::size_t i = 0; i < plane; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      rows[i * plane + j] = rows[j * plane + i] =
          layer[across + in_triangle(plane, i, j)];
  if (top)
    hold_top(*top, spring, matrix.data(), rows.data());
  factorise<plane>(matrix.data());
  solve_lower<plane, plane>(matrix.data(), rows.data());
  std::copy_n(&layer[own], triangle(plane), stiffness);
  take_schur<plane, plane>(matrix.data(), rows.data(), stiffness);
  for (std::size_t i = flat; i < plane; ++i)
    for (std::size_t j = 0; j < flat; ++j)
      stiffness[in_triangle(plane, i, j)] =
          -stiffness[in_triangle(plane, i, j)];
}

/// Computes (T_0^-1)_zz; T_0 is overwritten.
[[gnu::always_inline]] inline void upright_compliance(SimdBatch* stiffness,
                                                      SimdBatch* block) {
  std::array<SimdBatch, plane * upright> load{};
  for (std::size_t kind = 0; kind < upright; ++kind)
    load[(flat + kind) * upright + kind] += 1.0;
  factorise<plane>(stiffness);
  solve_lower<plane, upright>(stiffness, load.data());
  for (std::size_t i = 0; i < upright; ++i)
    for (std::size_t j = 0; j < upright; ++j) {
      SimdBatch sum{};
      for (std::size_t k = flat; k < plane; ++k) // the rows above are zero
        sum += load[k * upright + i] * load[k * upright + j] *
               stiffness[in_triangle(plane, k, k)];
      block[i * upright + j] = sum;
    }
}

/// The block, evaluated at four wavevectors.
struct Waves {
  mechanics::FarBoundary top;
  std::span<const MirroredQ2::Layer> layers;
  const std::vector<MaterialBlocks>& materials;
  SimdBatch spring;
};

[[gnu::always_inline]] inline void eliminate(const Waves& waves,
                                             SimdBatch* block) {
  std::array<SimdBatch, triangle(plane)> stiffness{};
  LayerBlocks layer;
  for (std::size_t l = waves.layers.size(); l-- > 0;) {
    waves.materials[waves.layers[l].material].stretched(waves.layers[l].stretch,
                                                        layer);
    eliminate_middle(layer);
    take_layer(layer, l + 1 == waves.layers.size() ? &waves.top : nullptr,
               waves.spring, stiffness.data());
  }
  upright_compliance(stiffness.data(), block);
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
  if (__builtin_cpu_supports("avx2"))
    return eliminate_on_avx2;
#endif
  return eliminate_on_any;
}

} // namespace

MirroredQ2::MirroredQ2(const Grid& grid, const LayeredBlock& block)
    : top_(block.top) {
  const double thickness = 2.0 * grid.spacing_x();
  for (const ElasticLayer& layer : block.layers) {
    const auto same = std::find_if(
        materials_.begin(), materials_.end(), [&](const Material& material) {
          return material.lame_modulus == layer.lame_modulus &&
                 material.shear_modulus == layer.shear_modulus;
        });
    layers_.push_back({static_cast<std::size_t>(same - materials_.begin()),
                       layer.thickness / thickness});
    if (same != materials_.end())
      continue;
    const ThicknessParts parts(
        grid, {thickness, layer.lame_modulus, layer.shear_modulus});
    const auto symbol = [](const CellStiffness& cell) {
      return LayerSymbol(cell, layer_packs, mirrored_blocks);
    };
    materials_.push_back({layer.lame_modulus, layer.shear_modulus,
                          symbol(parts.growing), symbol(parts.falling),
                          symbol(parts.constant)});
  }
}

void MirroredQ2::face_compliance(const SimdBatch& theta_x,
                                 const SimdBatch& theta_y,
                                 const SimdBatch& spring,
                                 SimdBatch* block) const {
  static const auto eliminate_waves = eliminate_here();
  const WaveProducts products(theta_x, theta_y);
  std::vector<MaterialBlocks> materials;
  for (const Material& material : materials_)
    materials.emplace_back(material, products);
  eliminate_waves({top_, layers_, materials, spring}, block);
}

} // namespace asperity::fem
