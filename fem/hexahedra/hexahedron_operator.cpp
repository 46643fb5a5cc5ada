#include "fem/hexahedra/hexahedron_operator.hpp"

#include "fem/hexahedra/hexahedron_diagonal.hpp"
#include "ranks/rank_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::fem {

MeshUnits units_of(const HexahedronMesh& mesh) {
  double edge = std::numeric_limits<double>::max(), stiffest = 0.0;
  for (std::size_t cell = 0; cell < mesh.nodes.size(); ++cell) {
    const auto& v = mesh.vertices[cell];
    for (const std::size_t other : {1U, 2U, 4U}) {
      const double length = std::hypot(
          v[other][0] - v[0][0], v[other][1] - v[0][1], v[other][2] - v[0][2]);
      edge = std::min(edge, length);
    }
    stiffest = std::max(stiffest, mesh.moduli[cell].shear);
  }
  RankGroup* const ranks = mesh.unknowns.ranks();
  return {-rank_max(ranks, -edge), rank_max(ranks, stiffest)};
}

HexahedronMesh scaled(const HexahedronMesh& mesh, const MeshUnits& units) {
  HexahedronMesh result = mesh;
  for (auto& vertices : result.vertices)
    for (auto& vertex : vertices)
      for (double& coordinate : vertex)
        coordinate /= units.length;
  for (CellModuli& moduli : result.moduli)
    moduli = {moduli.lame / units.modulus, moduli.shear / units.modulus};
  return result;
}

std::vector<double> diagonal_of(const HexahedronMesh& mesh) {
  std::vector<double> sum(mesh.unknowns.size, 0.0);
  CellDiagonal of_cell;
  for (std::size_t cell = 0; cell < mesh.nodes.size(); ++cell) {
    const auto& own =
        of_cell.of(hexahedron_shape(mesh.vertices[cell]), mesh.moduli[cell]);
    for (std::size_t a = 0; a < nodes_in_hexahedron; ++a)
      for (std::size_t k = 0; k < 3; ++k)
        sum[mesh.nodes[cell][a] + k] += own[3 * a + k];
  }
  mesh.unknowns.constraints->condense_diagonal(sum);
  mesh.unknowns.collect(sum.data());
  return sum;
}

template <class Number>
HexahedronOperator<Number>::HexahedronOperator(const HexahedronMesh& mesh)
    : MeshOperator<Number>(mesh.unknowns) {
  const std::size_t cells = mesh.nodes.size();
  const std::size_t groups = (cells + cells_in_group - 1) / cells_in_group;
  nodes_.reserve(groups * cells_in_group * nodes_in_hexahedron);
  for (const auto& nodes : mesh.nodes)
    nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
  nodes_.resize(groups * cells_in_group * nodes_in_hexahedron, 0);
  shapes_.resize(groups * cells_in_group * numbers_in_shape);
  for (std::size_t cell = 0; cell < groups * cells_in_group; ++cell)
    take_shape(mesh, cell);
}

/// Stores the numbers of a cell. Those that fill up the last group have a
/// volume but no stiffness.
template <class Number>
void HexahedronOperator<Number>::take_shape(const HexahedronMesh& mesh,
                                            std::size_t cell) {
  const bool is_real = cell < mesh.nodes.size();
  Number* const to = shapes_.data() +
                     cell / cells_in_group * cells_in_group * numbers_in_shape +
                     cell % cells_in_group;
  const HexahedronShape shape =
      hexahedron_shape(mesh.vertices[is_real ? cell : 0]);
  std::size_t number = 0;
  for (const auto& coefficient : shape)
    for (const double value : coefficient)
      to[cells_in_group * number++] = static_cast<Number>(value);
  const CellModuli moduli = is_real ? mesh.moduli[cell] : CellModuli{};
  to[cells_in_group * number++] = static_cast<Number>(moduli.lame);
  to[cells_in_group * number] = static_cast<Number>(moduli.shear);
}

template <class Number>
void HexahedronOperator<Number>::set_tangents(
    std::span<const CellTangents> cells) {
  tangents_.clear();
  tangent_places_.clear();
  if (cells.empty())
    return;
  constexpr std::size_t in_point = numbers_in_tangent * cells_in_group;
  constexpr std::size_t in_group = points_in_hexahedron * in_point;
  tangent_places_.assign(groups(), no_tangents);
  for (const CellTangents& cell : cells) {
    const std::size_t group = cell.cell / cells_in_group;
    if (tangent_places_.at(group) == no_tangents) {
      tangent_places_[group] =
          static_cast<std::uint32_t>(tangents_.size() / in_group);
      // The moduli, which are the last two numbers of a shape, and no s.
      const Number* const moduli =
          shapes_.data() +
          ((group + 1) * numbers_in_shape - 2) * cells_in_group;
      for (std::size_t point = 0; point < points_in_hexahedron; ++point) {
        tangents_.insert(tangents_.end(), moduli, moduli + 2 * cells_in_group);
        tangents_.resize(tangents_.size() + 6 * cells_in_group, Number(0));
      }
    }
    Number* to = tangents_.data() + tangent_places_[group] * in_group +
                 cell.cell % cells_in_group;
    for (const PointTangent& point : cell.points) {
      to[0] = static_cast<Number>(point.lame);
      to[cells_in_group] = static_cast<Number>(point.shear);
      for (std::size_t i = 0; i < point.softening.size(); ++i)
        to[(2 + i) * cells_in_group] = static_cast<Number>(point.softening[i]);
      to += in_point;
    }
  }
}

template <class Number>
void HexahedronOperator<Number>::add_cells(const Number* displacement,
                                           Number* force, Number factor) const {
  HexahedronProduct<Number> product;
  product.from = displacement;
  product.to = force;
  product.groups = groups();
  product.nodes = nodes_.data();
  product.shapes = shapes_.data();
  product.tangent_places =
      tangent_places_.empty() ? nullptr : tangent_places_.data();
  product.tangents = tangents_.data();
  product.factor = factor;
  multiply_hexahedra(product);
}

template <class Number>
std::size_t HexahedronOperator<Number>::bytes() const {
  return nodes_.size() * sizeof(std::uint32_t) +
         (shapes_.size() + tangents_.size()) * sizeof(Number) +
         tangent_places_.size() * sizeof(std::uint32_t);
}

template class HexahedronOperator<float>;
template class HexahedronOperator<double>;

} // namespace asperity::fem
