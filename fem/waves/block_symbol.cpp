#include "fem/waves/block_symbol.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

namespace asperity::fem {
namespace {

/// The index in the list 1, cos, cos 2, sin, sin 2 for a distance of 0..2 node
/// spacings.
std::size_t cosine(int distance) {
  return static_cast<std::size_t>(std::abs(distance));
}

std::size_t sine(int distance) {
  return 2 + static_cast<std::size_t>(std::abs(distance));
}

int sign(int distance) {
  return (distance > 0) - (distance < 0);
}

struct Node {
  int a, b, plane;
};

/// Sum of the contributions to one entry and product.
struct Sum {
  double amount = 0.0, magnitude = 0.0;

  void add(double contribution) {
    amount += contribution;
    magnitude += std::abs(contribution);
  }

  /// Whether the contributions of mirror images cancel up to roundoff.
  bool is_nothing() const { return std::abs(amount) <= 1e-13 * magnitude; }
};

using Sums = std::map<std::pair<std::size_t, std::size_t>, Sum>;

/// Adds entry * cos(theta . d) as a sum of products.
void add_even(Sums& sums, std::size_t to, int dx, int dy, double entry) {
  sums[{to, 5 * cosine(dx) + cosine(dy)}].add(entry);
  if (dx != 0 && dy != 0)
    sums[{to, 5 * sine(dx) + sine(dy)}].add(-entry * sign(dx) * sign(dy));
}

/// Adds entry * sin(theta . d) as a sum of products.
void add_odd(Sums& sums, std::size_t to, int dx, int dy, double entry) {
  if (dx != 0)
    sums[{to, 5 * sine(dx) + cosine(dy)}].add(entry * sign(dx));
  if (dy != 0)
    sums[{to, 5 * cosine(dx) + sine(dy)}].add(entry * sign(dy));
}

/// Adds the contribution of a pair of nodes to S.
void add_pair(const CellStiffness& cell, const Node& from, const Node& to,
              LayerSymbol::Layout layout, Sums& sums) {
  const auto degree = static_cast<std::size_t>(cell.degree);
  const auto place = [&](const Node& node, std::size_t component) {
    const std::size_t node_class =
        static_cast<std::size_t>(node.a) % degree +
        2 * (static_cast<std::size_t>(node.b) % degree);
    return static_cast<std::size_t>(node.plane) * plane_unknowns(degree) +
           3 * node_class + component;
  };
  const auto cell_row = [&](const Node& node, std::size_t component) {
    return cell.row(static_cast<std::size_t>(node.a),
                    static_cast<std::size_t>(node.b),
                    static_cast<std::size_t>(node.plane), component);
  };
  for (std::size_t c = 0; c < 9; ++c) {
    const LayerSymbol::Target target =
        layout(place(from, c / 3), place(to, c % 3));
    if (target.place == LayerSymbol::Target::none)
      continue;
    const double entry =
        target.sign * cell.at(cell_row(from, c / 3), cell_row(to, c % 3));
    const bool from_z = c / 3 == 2, to_z = c % 3 == 2;
    if (from_z == to_z)
      add_even(sums, target.place, to.a - from.a, to.b - from.b, entry);
    else // the factor i of u_x and u_y changes the sign in the rows of u_z
      add_odd(sums, target.place, to.a - from.a, to.b - from.b,
              from_z ? -entry : entry);
  }
}

} // namespace

WaveProducts::WaveProducts(const SimdBatch& theta_x, const SimdBatch& theta_y) {
  const auto functions = [](const SimdBatch& theta) {
    std::array<SimdBatch, 5> at{};
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      at[0][lane] = 1.0;
      at[1][lane] = std::cos(theta[lane]);
      at[2][lane] = std::cos(2.0 * theta[lane]);
      at[3][lane] = std::sin(theta[lane]);
      at[4][lane] = std::sin(2.0 * theta[lane]);
    }
    return at;
  };
  const std::array<SimdBatch, 5> in_x = functions(theta_x);
  const std::array<SimdBatch, 5> in_y = functions(theta_y);
  for (std::size_t i = 0; i < 25; ++i)
    values[i] = in_x[i / 5] * in_y[i % 5];
}

LayerSymbol::LayerSymbol(const CellStiffness& cell, std::size_t size,
                         Layout layout)
    : size_(size) {
  std::vector<Node> nodes;
  for (int k = 0; k <= cell.degree; ++k)
    for (int b = 0; b <= cell.degree; ++b)
      for (int a = 0; a <= cell.degree; ++a)
        nodes.push_back({a, b, k});
  Sums sums;
  for (const Node& from : nodes)
    for (const Node& to : nodes)
      add_pair(cell, from, to, layout, sums);
  for (const auto& [place, sum] : sums)
    if (!sum.is_nothing())
      terms_.push_back({sum.amount, static_cast<std::uint16_t>(place.first),
                        static_cast<std::uint16_t>(place.second)});
}

void LayerSymbol::evaluate(const WaveProducts& products,
                           SimdBatch* blocks) const {
  std::fill_n(blocks, size_, SimdBatch{});
  for (const Term& term : terms_)
    blocks[term.target] += term.amount * products.values[term.product];
}

namespace {

/// Splits the entries of a cell matrix by their dependence on the thickness t:
/// those between u_z and lateral components are constant, the others
/// C t + A/t.
struct ThicknessParts {
  CellStiffness growing, falling, constant; ///< at the thickness of `layer`

  ThicknessParts(const Grid& grid, int degree, ElasticLayer layer) {
    const double dx = degree * grid.spacing_x(), dy = degree * grid.spacing_y();
    growing = falling = constant = cell_stiffness(degree, dx, dy, layer);
    layer.thickness *= 2.0;
    const CellStiffness doubled = cell_stiffness(degree, dx, dy, layer);
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

bool is_same_material(const ElasticLayer& a, const ElasticLayer& b) {
  return a.lame_modulus == b.lame_modulus && a.shear_modulus == b.shear_modulus;
}

} // namespace

BlockSymbol::BlockSymbol(const Grid& grid, int degree,
                         const LayeredBlock& block, std::size_t packs,
                         LayerSymbol::Layout layout)
    : packs_(packs) {
  const double thickness = degree * grid.spacing_x();
  std::vector<ElasticLayer> materials;
  for (const ElasticLayer& layer : block.layers) {
    const auto same = std::find_if(materials.begin(), materials.end(),
                                   [&](const ElasticLayer& material) {
                                     return is_same_material(material, layer);
                                   });
    layers_.push_back({static_cast<std::size_t>(same - materials.begin()),
                       layer.thickness / thickness});
    if (same != materials.end())
      continue;
    materials.push_back({thickness, layer.lame_modulus, layer.shear_modulus});
    const ThicknessParts parts(grid, degree, materials.back());
    for (const CellStiffness* part :
         {&parts.growing, &parts.falling, &parts.constant})
      symbols_.emplace_back(*part, packs, layout);
  }
}

SimdBatches BlockSymbol::at(const SimdBatch& theta_x,
                            const SimdBatch& theta_y) const {
  const WaveProducts products(theta_x, theta_y);
  SimdBatches materials(symbols_.size() * packs_);
  for (std::size_t i = 0; i < symbols_.size(); ++i)
    symbols_[i].evaluate(products, &materials[i * packs_]);
  return materials;
}

} // namespace asperity::fem
