#include "fem/waves/q2_operator.hpp"

#include "base/parallel_rows.hpp"
#include "base/ranks/rank_sums.hpp"
#include "base/require.hpp"
#include "contact/operators/fourier_operator.hpp"
#include "fem/waves/cell_stiffness.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace asperity::fem {
namespace {

using BlockView = Eigen::Map<const Eigen::Matrix4d>;
using WeightView = Eigen::Map<const Eigen::Vector4d>;

/// Compliance of the longest wave of a group with respect to itself [m/Pa].
double long_wave(const NodeClassBlock& block,
                 const std::vector<double>& class_weights) {
  double sum = 0.0;
  for (std::size_t i = 0; i < node_classes; ++i)
    for (std::size_t j = 0; j < node_classes; ++j)
      sum += block[node_classes * i + j] * class_weights[j];
  return sum / static_cast<double>(node_classes);
}

/// Removes the uniform displacement, weighted by area, from the block of q = 0.
void remove_uniform_mode(NodeClassBlock& of_zero,
                         const std::vector<double>& class_weights) {
  const WeightView weights(class_weights.data());
  const Eigen::Matrix4d keep =
      Eigen::Matrix4d::Identity() -
      Eigen::Vector4d::Ones() * weights.transpose() / 4;
  Eigen::Map<Eigen::Matrix4d> block(of_zero.data());
  block = (keep * block * keep.transpose()).eval();
}

/// The grid of the cells, which is also that of their vertices.
Grid grid_of_cells(const Grid& nodes) {
  return {nodes.points_x / 2, nodes.points_y / 2, nodes.length_x,
          nodes.length_y};
}

std::vector<int> halved(std::vector<int> bounds) {
  for (int& bound : bounds)
    bound /= 2;
  return bounds;
}

Q2Convolution<float>::Block rounded_block(const NodeClassBlock& block) {
  Q2Convolution<float>::Block rounded{};
  std::ranges::transform(block, rounded.begin(), [](double value) {
    return static_cast<float>(value);
  });
  return rounded;
}

/// The factor of W in (G W + c)^-1 = (W G W + c W)^-1 W.
Q2Convolution<float>::Block inverse_of(const Eigen::Matrix4d& block,
                                       const std::vector<double>& class_weights,
                                       double local_compliance) {
  const WeightView weights(class_weights.data());
  Eigen::Matrix4d whole = weights.asDiagonal() * block * weights.asDiagonal();
  whole.diagonal() += local_compliance * weights;
  // The block is scaled because Cholesky factorisation takes square roots,
  // whose roundoff depends on the unit.
  const double scale = whole(0, 0);
  whole /= scale;
  NodeClassBlock inverse;
  Eigen::Map<Eigen::Matrix4d>(inverse.data()) =
      whole.llt().solve(Eigen::Matrix4d::Identity()) / scale;
  return rounded_block(inverse);
}

} // namespace

struct Q2Operator::Shared {
  SharedRows nodes, cells;
  int threads;
  Q2Column column;
  std::vector<double> class_weights = relative_nodal_areas(2);
  std::vector<double> nodal_weights = {}; ///< of the nodes of this process
  std::size_t first_column = 0;           ///< of this rank
  /// G of the columns of this rank, jy = 0..cells/2 of each; the block of q = 0
  /// is without the uniform mode.
  std::vector<NodeClassBlock> blocks = {};
  std::vector<Q2Convolution<float>::Block> rounded = {};
  double softest = 0.0;  ///< largest compliance of a long wave [m/Pa]
  double shortest = 0.0; ///< compliance of the shortest long wave in x [m/Pa]

  std::size_t height() const {
    return static_cast<std::size_t>(cells.grid().points_y) / 2 + 1;
  }

  int columns() const { return cells.grid().points_x / 2 + 1; }

  void find_blocks();
  void find_long_waves();
  std::vector<double> all_long_waves() const;
};

/// Computes the blocks of the columns of this rank.
void Q2Operator::Shared::find_blocks() {
  const Convolution<float> transforms(cells, threads);
  first_column = transforms.columns().first;
  const std::size_t n = transforms.columns().count;
  blocks.resize(n * height());
  parallel_rows(static_cast<int>(n), threads, [&](int k) {
    column(static_cast<int>(first_column) + k,
           std::span(blocks).subspan(static_cast<std::size_t>(k) * height(),
                                     height()));
  });
  if (first_column == 0 && !blocks.empty())
    remove_uniform_mode(blocks[0], class_weights);
  find_long_waves();
  std::ranges::transform(blocks, std::back_inserter(rounded), rounded_block);
  for (int iy = 0; iy < nodes.count(); ++iy) // the first row is one of vertices
    for (int ix = 0; ix < nodes.grid().points_x; ++ix)
      nodal_weights.push_back(
          class_weights[static_cast<std::size_t>(ix % 2 + 2 * (iy % 2))]);
}

void Q2Operator::Shared::find_long_waves() {
  const double none = -std::numeric_limits<double>::infinity();
  double largest = 0.0, last = none;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const double wave = long_wave(blocks[i], class_weights);
    if (first_column > 0 || i > 0)
      largest = std::max(largest, wave);
    if (first_column + i / height() ==
            static_cast<std::size_t>(columns()) - 1 &&
        i % height() == 0)
      last = wave;
  }
  softest = rank_max(nodes.ranks(), largest);
  shortest = rank_max(nodes.ranks(), last);
}

/// C of the operator on the vertices, for the half spectrum of the cells.
std::vector<double> Q2Operator::Shared::all_long_waves() const {
  const auto width = static_cast<std::size_t>(columns());
  const auto rows = static_cast<std::size_t>(cells.grid().points_y);
  std::vector<double> symbol(width * rows);
  for (std::size_t jy = 0; jy < rows; ++jy)
    for (std::size_t jx = 0; jx < width; ++jx)
      symbol[jy * width + jx] = long_wave(
          blocks[jx * height() + std::min(jy, rows - jy)], class_weights);
  return symbol;
}

namespace {

/// Copies the blocks of a column.
Q2Column column_of(const Q2Compliance& compliance) {
  return [&compliance](int jx, std::span<NodeClassBlock> of_jy) {
    for (std::size_t jy = 0; jy < of_jy.size(); ++jy)
      of_jy[jy] =
          compliance
              .blocks[jy * static_cast<std::size_t>(compliance.columns()) +
                      static_cast<std::size_t>(jx)];
  };
}

} // namespace

Q2Operator::Q2Operator(const Q2Compliance& compliance, int threads)
    : Q2Operator([&] {
        const Grid& grid = compliance.grid;
        require_cells(grid, 2);
        auto shared = std::make_shared<Shared>(
            Shared{SharedRows(grid), SharedRows(grid_of_cells(grid)), threads,
                   column_of(compliance)});
        shared->find_blocks();
        shared->column = nullptr; // refers to the argument
        return std::shared_ptr<const Shared>(std::move(shared));
      }()) {}

Q2Operator::Q2Operator(const Grid& grid, RankGroup& ranks, Q2Column blocks,
                       int threads)
    : Q2Operator([&] {
        require_cells(grid, 2);
        const std::vector<int> bounds = row_bounds(grid, ranks.size());
        auto shared = std::make_shared<Shared>(
            Shared{SharedRows(grid, ranks, bounds),
                   SharedRows(grid_of_cells(grid), ranks, halved(bounds)),
                   threads, std::move(blocks)});
        shared->find_blocks();
        return std::shared_ptr<const Shared>(std::move(shared));
      }()) {}

Q2Operator::Q2Operator(std::shared_ptr<const Shared> shared)
    : SurfaceOperator({.rows = shared->nodes,
                       .short_wave_compliance = shared->shortest,
                       .threads = shared->threads,
                       .nodal_weights = shared->nodal_weights}),
      shared_(std::move(shared)),
      exact_(shared_->nodes, shared_->cells, shared_->threads),
      convolution_(shared_->nodes, shared_->cells, shared_->threads) {}

std::unique_ptr<contact::SurfaceOperator> Q2Operator::do_clone() const {
  return std::unique_ptr<contact::SurfaceOperator>(new Q2Operator(shared_));
}

void Q2Operator::do_displacement(std::span<const double> pressure,
                                 std::span<double> displacement) {
  exact_.apply(shared_->blocks, pressure, displacement);
}

void Q2Operator::do_displacement_change(std::span<const float> pressure_change,
                                        std::span<float> displacement_change) {
  convolution_.apply(shared_->rounded, pressure_change, displacement_change);
}

void Q2Operator::do_pressure_estimate(std::span<const float> gap,
                                      double local_compliance,
                                      std::span<float> pressure) {
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  if (inverted_compliance_ != local_compliance) {
    const std::vector<NodeClassBlock>& blocks = shared_->blocks;
    inverse_.resize(blocks.size());
    for (std::size_t i = 0; i < inverse_.size(); ++i) {
      Eigen::Matrix4d block = BlockView(blocks[i].data());
      // The uniform mode gets the compliance of the longest wave.
      if (i == 0 && shared_->first_column == 0)
        block.array() += shared_->softest / 4.0;
      inverse_[i] = inverse_of(block, shared_->class_weights, local_compliance);
    }
    inverted_compliance_ = local_compliance;
  }
  convolution_.apply(inverse_, gap, pressure);
}

std::unique_ptr<contact::SurfaceOperator> Q2Operator::do_coarsened() const {
  const Grid& coarse = shared_->cells.grid();
  if (coarse.points_x < 32 || coarse.points_y < 32 || shared_rows() != nullptr)
    return nullptr;
  return std::make_unique<contact::FourierOperator>(
      coarse, shared_->all_long_waves(), threads());
}

} // namespace asperity::fem
