#include "fem/hexahedra/hexahedron_operator.hpp"

#include "base/ranks/rank_sums.hpp"
#include "fem/hexahedra/hexahedron_kernel.hpp"
#include "fem/multigrid/box_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace asperity::fem {
namespace {

/// The coefficients c0 .. c6 of (F.5) in hexahedron_kernel.hpp [m].
using HexahedronShape = std::array<std::array<double, 3>, 7>;

/// The diagonal of the matrix of one cell, by node and component, from 3^3
/// Gauss points.
class CellDiagonal {
public:
  CellDiagonal();

  /// The diagonal [N/m]; it remains valid until the next call. Equal cells that
  /// follow each other are computed once.
  const std::array<double, 3 * nodes_in_hexahedron>&
  of(const HexahedronShape& shape, const CellModuli& moduli);

private:
  /// Values and derivatives of the shape functions of a line at a Gauss point.
  struct LineFunctions {
    std::array<double, 3> value{}, slope{};

    explicit LineFunctions(double at)
        : value{0.5 * at * (at - 1.0), 1.0 - at * at, 0.5 * at * (at + 1.0)},
          slope{at - 0.5, -2.0 * at, at + 0.5} {}
  };

  bool is_last(const HexahedronShape& shape, const CellModuli& moduli) const;
  void add_point(const HexahedronShape& c, const CellModuli& moduli,
                 const std::array<std::size_t, 3>& point);

  std::array<double, 3> places_{};
  std::array<LineFunctions, 3> lines_{LineFunctions(0.0), LineFunctions(0.0),
                                      LineFunctions(0.0)};
  HexahedronShape shape_{}; ///< of the last cell
  CellModuli moduli_{};     ///< of the last cell
  std::array<double, 3 * nodes_in_hexahedron> diagonal_{};
};

using Vector3 = std::array<double, 3>;

/// The signs of xi, eta, zeta of the shape's coefficients: which of the
/// coordinates a coefficient multiplies.
constexpr std::array<std::array<bool, 3>, 7> factors{{{true, false, false},
                                                      {false, true, false},
                                                      {false, false, true},
                                                      {true, true, false},
                                                      {false, true, true},
                                                      {true, false, true},
                                                      {true, true, true}}};

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

/// @param vertices  places of the vertices, x fastest [m]
HexahedronShape hexahedron_shape(const std::array<Vector3, 8>& vertices) {
  HexahedronShape shape{};
  for (std::size_t term = 0; term < 7; ++term)
    for (unsigned int v = 0; v < 8; ++v) {
      double sign = 0.125;
      for (unsigned int axis = 0; axis < 3; ++axis)
        if (factors[term][axis] && (v >> axis & 1U) == 0)
          sign = -sign;
      for (std::size_t i = 0; i < 3; ++i)
        shape[term][i] += sign * vertices[v][i];
    }
  return shape;
}

CellDiagonal::CellDiagonal() {
  const double place = std::sqrt(0.6);
  for (std::size_t i = 0; i < 3; ++i)
    lines_[i] =
        LineFunctions(places_[i] = place * (static_cast<double>(i) - 1.0));
}

const std::array<double, 3 * nodes_in_hexahedron>&
CellDiagonal::of(const HexahedronShape& shape, const CellModuli& moduli) {
  if (is_last(shape, moduli))
    return diagonal_;
  shape_ = shape;
  moduli_ = moduli;
  diagonal_.fill(0.0);
  for (std::size_t z = 0; z < 3; ++z)
    for (std::size_t y = 0; y < 3; ++y)
      for (std::size_t x = 0; x < 3; ++x)
        add_point(shape, moduli, {x, y, z});
  return diagonal_;
}

/// Whether the last cell was the same but for rounding.
bool CellDiagonal::is_last(const HexahedronShape& shape,
                           const CellModuli& moduli) const {
  constexpr double rounding = 1e-12;
  double size = 0.0, difference = 0.0;
  for (std::size_t term = 0; term < shape.size(); ++term)
    for (std::size_t i = 0; i < 3; ++i) {
      size = std::max(size, std::abs(shape[term][i]));
      difference =
          std::max(difference, std::abs(shape[term][i] - shape_[term][i]));
    }
  return difference <= rounding * size && moduli.lame == moduli_.lame &&
         moduli.shear == moduli_.shear;
}

void CellDiagonal::add_point(const HexahedronShape& c, const CellModuli& moduli,
                             const std::array<std::size_t, 3>& point) {
  const double xi = places_[point[0]], eta = places_[point[1]],
               zeta = places_[point[2]];
  std::array<Vector3, 3> edges{}, cofactors{};
  for (std::size_t i = 0; i < 3; ++i) {
    edges[0][i] =
        c[0][i] + eta * c[3][i] + zeta * c[5][i] + eta * zeta * c[6][i];
    edges[1][i] = c[1][i] + xi * c[3][i] + zeta * c[4][i] + xi * zeta * c[6][i];
    edges[2][i] = c[2][i] + xi * c[5][i] + eta * c[4][i] + xi * eta * c[6][i];
  }
  for (std::size_t i = 0; i < 3; ++i)
    cofactors[i] = cross(edges[(i + 1) % 3], edges[(i + 2) % 3]);
  const double determinant = edges[0][0] * cofactors[0][0] +
                             edges[0][1] * cofactors[0][1] +
                             edges[0][2] * cofactors[0][2];
  constexpr std::array<double, 3> weights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  const double scale =
      weights[point[0]] * weights[point[1]] * weights[point[2]] / determinant;
  std::array<const LineFunctions*, 3> lines{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    lines[axis] = &lines_[point[axis]];
  for (std::size_t a = 0; a < nodes_in_hexahedron; ++a) {
    const std::array<std::size_t, 3> node{a % 3, a / 3 % 3, a / 9};
    Vector3 gradient{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double slope = 1.0;
      for (std::size_t i = 0; i < 3; ++i)
        slope *=
            i == axis ? lines[i]->slope[node[i]] : lines[i]->value[node[i]];
      for (std::size_t k = 0; k < 3; ++k)
        gradient[k] += slope * cofactors[axis][k];
    }
    const double square = gradient[0] * gradient[0] +
                          gradient[1] * gradient[1] + gradient[2] * gradient[2];
    for (std::size_t k = 0; k < 3; ++k)
      diagonal_[3 * a + k] +=
          scale * ((moduli.lame + moduli.shear) * gradient[k] * gradient[k] +
                   moduli.shear * square);
  }
}

} // namespace

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
