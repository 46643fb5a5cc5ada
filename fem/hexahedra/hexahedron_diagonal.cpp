#include "fem/hexahedra/hexahedron_diagonal.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::fem {
namespace {

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

} // namespace

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

} // namespace asperity::fem
