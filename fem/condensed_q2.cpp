#include "fem/condensed_q2.hpp"

#include "base/parallel_rows.hpp"
#include "fem/cell_stiffness.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cmath>
#include <numbers>

namespace asperity::fem {
namespace {

constexpr int plane_size = 12; // four kinds of three components
using PlaneMatrix = Eigen::Matrix<double, plane_size, plane_size>;
using UpperMatrix = Eigen::Matrix<double, 2 * plane_size, 2 * plane_size>;
using UpperToLower = Eigen::Matrix<double, 2 * plane_size, plane_size>;
using LayerMatrix = Eigen::Matrix<double, 3 * plane_size, 3 * plane_size>;

/// cos and sin of q.(d_x h_x, d_y h_y) for node distances d in -2..2.
struct Phases {
  std::array<double, 25> cosine, sine;

  Phases(double theta_x, double theta_y) {
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const auto at = static_cast<std::size_t>((dy + 2) * 5 + dx + 2);
        cosine[at] = std::cos(theta_x * dx + theta_y * dy);
        sine[at] = std::sin(theta_x * dx + theta_y * dy);
      }
  }
};

/// One entry of a cell matrix on its way into the symbol: entry (row, column)
/// of S gets amount times a cosine, or times a sine between u_x, u_y (which
/// are multiplied by i) and u_z.
struct Term {
  double amount;
  std::uint8_t row, column, phase;
};

struct LayerTerms {
  std::vector<Term> even, odd; ///< with cosines, with sines

  /// @param scale  that the matrix is divided by [N/m]
  LayerTerms(const CellStiffness& cell, double scale);
};

LayerTerms::LayerTerms(const CellStiffness& cell, double scale) {
  struct Node {
    std::size_t a, b, plane;
  };

  std::vector<Node> nodes;
  for (std::size_t i = 0; i < 27; ++i)
    nodes.push_back({i % 3, i / 3 % 3, i / 9});
  const auto place = [](const Node& node, std::size_t component) {
    const std::size_t kind = node.a % 2 + 2 * (node.b % 2);
    return node.plane * plane_size + 3 * kind + component;
  };
  for (const Node& from : nodes)
    for (const Node& to : nodes)
      for (std::size_t c = 0; c < 9; ++c) {
        const std::size_t row = place(from, c / 3);
        const std::size_t column = place(to, c % 3);
        if (column > row)
          continue; // the lower triangle is enough
        const double entry =
            cell.at(cell.row(from.a, from.b, from.plane, c / 3),
                    cell.row(to.a, to.b, to.plane, c % 3)) /
            scale;
        const std::size_t phase = (to.b + 2 - from.b) * 5 + to.a + 2 - from.a;
        const bool from_z = c / 3 == 2;
        const bool to_z = c % 3 == 2;
        (from_z == to_z ? even : odd)
            .push_back({from_z && !to_z ? -entry : entry,
                        static_cast<std::uint8_t>(row),
                        static_cast<std::uint8_t>(column),
                        static_cast<std::uint8_t>(phase)});
      }
}

/// The lower triangle of the layer's symbol S(q).
LayerMatrix symbol(const LayerTerms& layer, const Phases& phases) {
  LayerMatrix matrix = LayerMatrix::Zero();
  for (const Term& term : layer.even)
    matrix(term.row, term.column) += term.amount * phases.cosine[term.phase];
  for (const Term& term : layer.odd)
    matrix(term.row, term.column) += term.amount * phases.sine[term.phase];
  return matrix;
}

/// What holds the top plane, besides the layer's own stiffness.
struct TopHold {
  std::array<bool, 3> is_held; ///< u_x, u_y, u_z = 0
  double spring =
      0.0; ///< on each free component's uniform mode, over the scale
};

TopHold top_hold(cases::TopFace top, bool is_uniform_mode, double stiffness) {
  const double spring = is_uniform_mode ? stiffness : 0.0;
  if (top == cases::TopFace::clamped)
    return {{true, true, true}, spring};
  if (top == cases::TopFace::sliding)
    return {{false, false, true}, spring};
  return {{false, false, false}, spring};
}

/// Holds components of the top plane: identity in their rows and columns.
void hold(const TopHold& top, UpperMatrix& matrix, UpperToLower& to_lower) {
  for (int component = 0; component < 3; ++component)
    for (int kind = 0; kind < 4; ++kind) {
      const int row = plane_size + 3 * kind + component;
      if (top.is_held[static_cast<std::size_t>(component)]) {
        matrix.row(row).setZero();
        matrix.col(row).setZero();
        matrix(row, row) = 1.0;
        to_lower.row(row).setZero();
        continue;
      }
      for (int other = 0; other < 4; ++other)
        matrix(row, plane_size + 3 * other + component) += top.spring;
    }
}

/// T_0 by (Q2.2).
PlaneMatrix surface_stiffness(const std::vector<LayerTerms>& layers,
                              const TopHold& top, const Phases& phases) {
  PlaneMatrix plane = PlaneMatrix::Zero();
  for (std::size_t l = layers.size(); l-- > 0;) {
    const LayerMatrix layer = symbol(layers[l], phases);
    UpperMatrix upper = layer.bottomRightCorner<24, 24>();
    UpperToLower to_lower = layer.bottomLeftCorner<24, 12>();
    upper.bottomRightCorner<12, 12>() += plane;
    if (l + 1 == layers.size())
      hold(top, upper, to_lower);
    const Eigen::LLT<UpperMatrix> factor(upper); // reads the lower triangle
    factor.matrixL().solveInPlace(to_lower);
    plane = layer.topLeftCorner<12, 12>();
    plane.triangularView<Eigen::Lower>() -= to_lower.transpose() * to_lower;
  }
  return plane;
}

/// (T_0^-1)_zz over the node kinds, times h_x h_y, both without the scale.
KindBlock surface_compliance(const PlaneMatrix& stiffness, double node_area) {
  Eigen::Matrix<double, plane_size, 4> load =
      Eigen::Matrix<double, plane_size, 4>::Zero();
  for (int kind = 0; kind < 4; ++kind)
    load(3 * kind + 2, kind) = 1.0;
  const Eigen::LLT<PlaneMatrix> factor(stiffness);
  factor.matrixL().solveInPlace(load);
  const Eigen::Matrix4d compliance = node_area * load.transpose() * load;
  KindBlock block{};
  Eigen::Map<Eigen::Matrix4d>(block.data()) = compliance;
  return block;
}

/// The block of the wavevector mirrored in the diagonal: x-edges are y-edges.
KindBlock mirrored(const KindBlock& block) {
  constexpr std::array<std::size_t, 4> image{0, 2, 1, 3};
  KindBlock mirror{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      mirror[4 * image[i] + image[j]] = block[4 * i + j];
  return mirror;
}

} // namespace

Q2Compliance condensed_compliance_q2(const Grid& grid,
                                     const LayeredBlock& block, int threads) {
  require_cells(grid, 2);
  require_block(block);
  // Cholesky takes roots, which round otherwise in other units: hence without.
  const double scale =
      block.layers.front().shear_modulus * grid.spacing_x(); // [N/m]
  std::vector<LayerTerms> layers;
  for (const ElasticLayer& layer : block.layers)
    layers.emplace_back(cell_stiffness(2, 2.0 * grid.spacing_x(),
                                       2.0 * grid.spacing_y(), layer),
                        scale);

  Q2Compliance compliance{grid, {}, relative_nodal_areas(2)};
  const int columns = compliance.columns();
  const bool is_square = grid.is_square();
  compliance.blocks.resize(static_cast<std::size_t>(columns) *
                           static_cast<std::size_t>(compliance.rows()));
  const auto at = [&](int mode_x, int mode_y) -> KindBlock& {
    return compliance.blocks[static_cast<std::size_t>(mode_y) *
                                 static_cast<std::size_t>(columns) +
                             static_cast<std::size_t>(mode_x)];
  };
  const double spring =
      block.layers.back().shear_modulus * grid.spacing_x() / scale;
  parallel_rows(compliance.rows(), threads, [&](int mode_y) {
    for (int mode_x = is_square ? mode_y : 0; mode_x < columns; ++mode_x) {
      const Phases phases(2.0 * std::numbers::pi * mode_x / grid.points_x,
                          2.0 * std::numbers::pi * mode_y / grid.points_y);
      const TopHold top =
          top_hold(block.top, mode_x == 0 && mode_y == 0, spring);
      at(mode_x, mode_y) = surface_compliance(
          surface_stiffness(layers, top, phases), grid.cell_area() / scale);
      if (is_square && mode_x != mode_y)
        at(mode_y, mode_x) = mirrored(at(mode_x, mode_y));
    }
  });
  return compliance;
}

} // namespace asperity::fem
