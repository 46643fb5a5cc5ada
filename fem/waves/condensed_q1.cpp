#include "fem/waves/condensed_q1.hpp"

#include "base/field_sums.hpp"
#include "base/parallel_rows.hpp"
#include "fem/waves/cell_stiffness.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace asperity::fem {
namespace {

/// Sums of a cell-matrix entry over the node pairs at one lateral offset
/// (dx, dy) in -1..1, with index (dy + 1) * 3 + dx + 1.
using Stencil = std::array<double, 9>;

Stencil stencil(const CellStiffness& cell, std::size_t row_plane,
                std::size_t row_component, std::size_t column_plane,
                std::size_t column_component) {
  Stencil sums{};
  for (std::size_t node = 0; node < 16; ++node) {
    const std::size_t a = node & 1, b = node >> 1 & 1;
    const std::size_t a_to = node >> 2 & 1, b_to = node >> 3;
    sums[(b_to + 1 - b) * 3 + a_to + 1 - a] +=
        cell.at(cell.row(a, b, row_plane, row_component),
                cell.row(a_to, b_to, column_plane, column_component));
  }
  return sums;
}

/// The lateral phases of one wavevector, theta = q h in x and y.
struct Phases {
  double cos_x, sin_x, cos_y, sin_y, cos_cos;
};

/// An xx, yy or zz entry: the sum of s cos(theta.d).
struct EvenEntry {
  double one = 0.0, cos_x = 0.0, cos_y = 0.0, cos_cos = 0.0;

  explicit EvenEntry(const Stencil& s)
      : one(s[4]),
        cos_x(s[3] + s[5]),
        cos_y(s[1] + s[7]),
        cos_cos(s[0] + s[2] + s[6] + s[8]) {}

  double operator()(const Phases& at) const {
    return one + cos_x * at.cos_x + cos_y * at.cos_y + cos_cos * at.cos_cos;
  }
};

/// An xz entry: the sum of s sin(theta.d), odd in x. The transposed entry zx
/// has the opposite sign.
struct OddX {
  double one = 0.0, cos_y = 0.0;

  OddX(const Stencil& s, double sign)
      : one(sign * (s[5] - s[3])), cos_y(sign * (s[8] + s[2] - s[6] - s[0])) {}

  double operator()(const Phases& at) const {
    return at.sin_x * (one + cos_y * at.cos_y);
  }
};

/// A yz entry, odd in y.
struct OddY {
  double one = 0.0, cos_x = 0.0;

  OddY(const Stencil& s, double sign)
      : one(sign * (s[7] - s[1])), cos_x(sign * (s[8] + s[6] - s[2] - s[0])) {}

  double operator()(const Phases& at) const {
    return at.sin_y * (one + cos_x * at.cos_x);
  }
};

/// An xy entry: the sum of s cos(theta.d), odd in both directions.
struct OddBoth {
  double sin_sin = 0.0;

  explicit OddBoth(const Stencil& s) : sin_sin(s[2] + s[6] - s[0] - s[8]) {}

  double operator()(const Phases& at) const {
    return sin_sin * at.sin_x * at.sin_y;
  }
};

struct Symmetric3 {
  double xx, yy, zz, xy, xz, yz;
};

Symmetric3 operator+(const Symmetric3& a, const Symmetric3& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz,
          a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}

Symmetric3 inverse(const Symmetric3& m) {
  const double xx = m.yy * m.zz - m.yz * m.yz;
  const double xy = m.xz * m.yz - m.xy * m.zz;
  const double xz = m.xy * m.yz - m.xz * m.yy;
  const double scale = 1.0 / (m.xx * xx + m.xy * xy + m.xz * xz);
  return {xx * scale,
          (m.xx * m.zz - m.xz * m.xz) * scale,
          (m.xx * m.yy - m.xy * m.xy) * scale,
          xy * scale,
          xz * scale,
          (m.xy * m.xz - m.xx * m.yz) * scale};
}

/// The diagonal block of one plane: A_l or D_l.
struct PlaneBlock {
  EvenEntry xx, yy, zz;
  OddBoth xy;
  OddX xz;
  OddY yz;

  PlaneBlock(const CellStiffness& cell, std::size_t plane)
      : xx(stencil(cell, plane, 0, plane, 0)),
        yy(stencil(cell, plane, 1, plane, 1)),
        zz(stencil(cell, plane, 2, plane, 2)),
        xy(stencil(cell, plane, 0, plane, 1)),
        xz(stencil(cell, plane, 0, plane, 2), 1.0),
        yz(stencil(cell, plane, 1, plane, 2), 1.0) {}

  Symmetric3 operator()(const Phases& at) const {
    return {xx(at), yy(at), zz(at), xy(at), xz(at), yz(at)};
  }
};

/// The coupling block B_l, with rows of the lower plane and columns of the
/// upper one.
struct CouplingBlock {
  EvenEntry xx, yy, zz;
  OddBoth xy, yx;
  OddX xz, zx;
  OddY yz, zy;

  explicit CouplingBlock(const CellStiffness& cell)
      : xx(stencil(cell, 0, 0, 1, 0)),
        yy(stencil(cell, 0, 1, 1, 1)),
        zz(stencil(cell, 0, 2, 1, 2)),
        xy(stencil(cell, 0, 0, 1, 1)),
        yx(stencil(cell, 0, 1, 1, 0)),
        xz(stencil(cell, 0, 0, 1, 2), 1.0),
        zx(stencil(cell, 0, 2, 1, 0), -1.0),
        yz(stencil(cell, 0, 1, 1, 2), 1.0),
        zy(stencil(cell, 0, 2, 1, 1), -1.0) {}

  using Row = std::array<double, 3>;

  std::array<Row, 3> operator()(const Phases& at) const {
    return {Row{xx(at), xy(at), xz(at)}, Row{yx(at), yy(at), yz(at)},
            Row{zx(at), zy(at), zz(at)}};
  }
};

CouplingBlock::Row times(const Symmetric3& m, const CouplingBlock::Row& v) {
  return {m.xx * v[0] + m.xy * v[1] + m.xz * v[2],
          m.xy * v[0] + m.yy * v[1] + m.yz * v[2],
          m.xz * v[0] + m.yz * v[1] + m.zz * v[2]};
}

/// Computes A - B M B^T for a symmetric M.
Symmetric3 schur_complement(const Symmetric3& a,
                            const std::array<CouplingBlock::Row, 3>& b,
                            const Symmetric3& m) {
  const CouplingBlock::Row x = times(m, b[0]);
  const CouplingBlock::Row y = times(m, b[1]);
  const CouplingBlock::Row z = times(m, b[2]);
  return {a.xx - dot(b[0], x), a.yy - dot(b[1], y), a.zz - dot(b[2], z),
          a.xy - dot(b[0], y), a.xz - dot(b[0], z), a.yz - dot(b[1], z)};
}

struct Q1Layer {
  PlaneBlock lower, upper;
  CouplingBlock coupling;

  explicit Q1Layer(const CellStiffness& cell)
      : lower(cell, 0), upper(cell, 1), coupling(cell) {}
};

/// Computes (D_(n-1) + T_n)^-1 at the far boundary.
Symmetric3 top_compliance(const Symmetric3& top_block,
                          mechanics::FarBoundary top) {
  if (top == mechanics::FarBoundary::clamped)
    return {};
  if (top == mechanics::FarBoundary::pressure)
    return inverse(top_block);
  const Symmetric3& m = top_block;
  const double scale = 1.0 / (m.xx * m.yy - m.xy * m.xy);
  return {m.yy * scale, m.xx * scale, 0.0, -m.xy * scale, 0.0, 0.0};
}

/// Computes (T_0^-1)_zz by (Q1.1).
double surface_compliance(const std::vector<Q1Layer>& layers,
                          mechanics::FarBoundary top, const Phases& at) {
  Symmetric3 upper = top_compliance(layers.back().upper(at), top);
  for (std::size_t l = layers.size(); l-- > 1;)
    upper = inverse(
        layers[l - 1].upper(at) +
        schur_complement(layers[l].lower(at), layers[l].coupling(at), upper));
  return inverse(schur_complement(layers[0].lower(at), layers[0].coupling(at),
                                  upper))
      .zz;
}

Phases phases(const Grid& grid, int mode_x, int mode_y) {
  const double theta_x = 2.0 * std::numbers::pi * mode_x / grid.points_x;
  const double theta_y = 2.0 * std::numbers::pi * mode_y / grid.points_y;
  const double cos_x = std::cos(theta_x);
  const double cos_y = std::cos(theta_y);
  return {cos_x, std::sin(theta_x), cos_y, std::sin(theta_y), cos_x * cos_y};
}

} // namespace

std::vector<double> condensed_compliance_q1(const Grid& grid,
                                            const LayeredBlock& block,
                                            int threads) {
  require_cells(grid, 1);
  require_block(block);
  std::vector<Q1Layer> layers;
  for (const ElasticLayer& layer : block.layers)
    layers.emplace_back(
        cell_stiffness(1, grid.spacing_x(), grid.spacing_y(), layer));

  std::vector<double> compliance(grid.half_spectrum_size(), 0.0);
  const int columns = grid.points_x / 2 + 1;
  const bool is_square = grid.is_square();
  const auto at = [&](int mode_x, int mode_y) -> double& {
    return compliance[static_cast<std::size_t>(mode_y) *
                          static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(mode_x)];
  };
  parallel_rows(grid.points_y / 2 + 1, threads, [&](int mode_y) {
    for (int mode_x = is_square ? mode_y : 0; mode_x < columns; ++mode_x) {
      if (mode_x == 0 && mode_y == 0)
        continue;
      at(mode_x, mode_y) =
          grid.cell_area() *
          surface_compliance(layers, block.top, phases(grid, mode_x, mode_y));
      if (is_square) // (x, y) and (y, x) are mirror images
        at(mode_y, mode_x) = at(mode_x, mode_y);
    }
  });
  for (int mode_y = grid.points_y / 2 + 1; mode_y < grid.points_y; ++mode_y)
    for (int mode_x = 0; mode_x < columns; ++mode_x)
      at(mode_x, mode_y) = at(mode_x, grid.points_y - mode_y);
  return compliance;
}

} // namespace asperity::fem
