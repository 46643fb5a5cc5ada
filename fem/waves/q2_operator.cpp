#include "fem/waves/q2_operator.hpp"

#include "base/require.hpp"
#include "contact/operators/fourier_operator.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace asperity::fem {
namespace {

using Amplitudes = std::array<std::complex<double>, node_classes>;
using BlockView = Eigen::Map<const Eigen::Matrix4d>;

/// Computes (Q2.3) without a factor; it is its own inverse up to 1/4.
Amplitudes hadamard(const Amplitudes& f) {
  const auto even = f[0] + f[1], odd = f[0] - f[1];
  const auto even_y = f[2] + f[3], odd_y = f[2] - f[3];
  return {even + even_y, odd + odd_y, even - even_y, odd - odd_y};
}

/// Compliance of the longest wave of a group with respect to itself [m/Pa].
double long_wave(const Q2Compliance& compliance, const NodeClassBlock& block) {
  double sum = 0.0;
  for (std::size_t i = 0; i < node_classes; ++i)
    for (std::size_t j = 0; j < node_classes; ++j)
      sum += block[node_classes * i + j] * compliance.class_weights[j];
  return sum / static_cast<double>(node_classes);
}

/// Removes the uniform displacement, weighted by area, from the block of q = 0.
void remove_uniform_mode(Q2Compliance& compliance) {
  const Eigen::Map<const Eigen::Vector4d> weights(
      compliance.class_weights.data());
  const Eigen::Matrix4d keep =
      Eigen::Matrix4d::Identity() -
      Eigen::Vector4d::Ones() * weights.transpose() / 4;
  Eigen::Map<Eigen::Matrix4d> block(compliance.blocks[0].data());
  block = (keep * block * keep.transpose()).eval();
}

/// The four grid modes of one cell wavevector in the half spectrum. Modes
/// beyond half of the grid in x are stored as the conjugates of their
/// opposites.
struct Group {
  std::array<std::size_t, node_classes> place;

  Group(const Grid& grid, int mode_x, int mode_y) {
    const int half_x = grid.points_x / 2;
    const int half_y = grid.points_y / 2;
    const auto index = [&](int column, int row) {
      const int wrapped =
          ((row % grid.points_y) + grid.points_y) % grid.points_y;
      return static_cast<std::size_t>(wrapped) *
                 static_cast<std::size_t>(half_x + 1) +
             static_cast<std::size_t>(column);
    };
    place = {index(mode_x, mode_y), index(half_x - mode_x, -mode_y),
             index(mode_x, mode_y + half_y),
             index(half_x - mode_x, -mode_y - half_y)};
  }

  Amplitudes read(const std::vector<std::complex<double>>& spectrum) const {
    return {spectrum[place[0]], std::conj(spectrum[place[1]]),
            spectrum[place[2]], std::conj(spectrum[place[3]])};
  }

  void write(const Amplitudes& amplitudes,
             std::vector<std::complex<double>>& spectrum) const {
    spectrum[place[0]] = amplitudes[0];
    spectrum[place[1]] = std::conj(amplitudes[1]);
    spectrum[place[2]] = amplitudes[2];
    spectrum[place[3]] = std::conj(amplitudes[3]);
  }
};

} // namespace

struct Q2Operator::Shared {
  RealFourier fourier;
  Q2Compliance compliance; ///< the block of q = 0 is without the uniform mode
  std::vector<double> nodal_weights;
  double softest; ///< largest compliance of a long wave [m/Pa]
  int threads;
};

Q2Operator::Q2Operator(Q2Compliance compliance, int threads) {
  require_cells(compliance.grid, 2);
  const Grid& grid = compliance.grid;
  remove_uniform_mode(compliance);
  std::vector<double> weights(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      weights[grid.index(ix, iy)] =
          compliance
              .class_weights[static_cast<std::size_t>(ix % 2 + 2 * (iy % 2))];
  double softest = 0.0;
  for (std::size_t i = 1; i < compliance.blocks.size(); ++i)
    softest = std::max(softest, long_wave(compliance, compliance.blocks[i]));
  shared_ = std::make_shared<const Shared>(
      Shared{RealFourier(grid, threads), std::move(compliance),
             std::move(weights), softest, threads});
  spectrum_.resize(shared_->fourier.grid().half_spectrum_size());
  product_.resize(spectrum_.size());
}

Q2Operator::Q2Operator(std::shared_ptr<const Shared> shared)
    : shared_(std::move(shared)),
      spectrum_(shared_->fourier.grid().half_spectrum_size()),
      product_(spectrum_.size()) {}

std::unique_ptr<contact::SurfaceOperator> Q2Operator::clone() const {
  return std::unique_ptr<contact::SurfaceOperator>(new Q2Operator(shared_));
}

const Grid& Q2Operator::grid() const {
  return shared_->fourier.grid();
}

std::span<const double> Q2Operator::nodal_weights() const {
  return shared_->nodal_weights;
}

/// Computes result = B W field, where B are the blocks and W the weights of the
/// node classes.
void Q2Operator::apply(const std::vector<NodeClassBlock>& blocks,
                       std::span<const double> field,
                       std::span<double> result) {
  shared_->fourier.forward(field, spectrum_);
  const std::vector<double>& weights = shared_->compliance.class_weights;
  const int cells_x = grid().points_x / 2;
  const int cells_y = grid().points_y / 2;
  const double normalise =
      1.0 / static_cast<double>(node_classes * grid().size());
  for (int row = 0; row < cells_y; ++row) {
    const int mode_y = signed_wavenumber(row, cells_y);
    const std::size_t block_row =
        static_cast<std::size_t>(std::abs(mode_y)) *
        static_cast<std::size_t>(shared_->compliance.columns());
    for (int mode_x = 0; mode_x <= cells_x / 2; ++mode_x) {
      const NodeClassBlock& block =
          blocks[block_row + static_cast<std::size_t>(mode_x)];
      const Group group(grid(), mode_x, mode_y);
      Amplitudes n_classes = hadamard(group.read(spectrum_));
      for (std::size_t k = 0; k < node_classes; ++k)
        n_classes[k] *= weights[k] * normalise;
      Amplitudes answer{};
      for (std::size_t i = 0; i < node_classes; ++i)
        for (std::size_t j = 0; j < node_classes; ++j)
          answer[i] += block[node_classes * i + j] * n_classes[j];
      group.write(hadamard(answer), product_);
    }
  }
  shared_->fourier.backward(product_, result);
}

void Q2Operator::apply(const std::vector<NodeClassBlock>& blocks,
                       std::span<const float> field, std::span<float> result) {
  field_.assign(field.begin(), field.end());
  apply(blocks, field_, field_);
  std::transform(field_.begin(), field_.end(), result.begin(),
                 [](double value) { return static_cast<float>(value); });
}

void Q2Operator::displacement(std::span<const double> pressure,
                              std::span<double> displacement) {
  apply(shared_->compliance.blocks, pressure, displacement);
}

void Q2Operator::displacement_change(std::span<const float> pressure_change,
                                     std::span<float> displacement_change) {
  apply(shared_->compliance.blocks, pressure_change, displacement_change);
}

/// Applies (G W + c)^-1 = (W G W + c W)^-1 W, which is again a symmetric block
/// times W.
void Q2Operator::pressure_estimate(std::span<const float> gap,
                                   double local_compliance,
                                   std::span<float> pressure) {
  require_not_negative("local_compliance", local_compliance, "m/Pa");
  if (inverted_compliance_ != local_compliance) {
    const Q2Compliance& compliance = shared_->compliance;
    const Eigen::Map<const Eigen::Vector4d> weights(
        compliance.class_weights.data());
    inverse_.resize(compliance.blocks.size());
    for (std::size_t i = 0; i < inverse_.size(); ++i) {
      Eigen::Matrix4d block = BlockView(compliance.blocks[i].data());
      if (i == 0) // the uniform mode gets the compliance of the longest wave
        block.array() += shared_->softest / 4.0;
      Eigen::Matrix4d whole =
          weights.asDiagonal() * block * weights.asDiagonal();
      whole.diagonal() += local_compliance * weights;
      // The block is scaled because Cholesky factorisation takes square roots,
      // whose roundoff depends on the unit.
      const double scale = whole(0, 0);
      whole /= scale;
      Eigen::Map<Eigen::Matrix4d>(inverse_[i].data()) =
          whole.llt().solve(Eigen::Matrix4d::Identity()) / scale;
    }
    inverted_compliance_ = local_compliance;
  }
  apply(inverse_, gap, pressure);
}

int Q2Operator::threads() const {
  return shared_->threads;
}

double Q2Operator::short_wave_compliance() const {
  const Q2Compliance& compliance = shared_->compliance;
  return long_wave(
      compliance,
      compliance.blocks[static_cast<std::size_t>(compliance.columns() - 1)]);
}

std::unique_ptr<contact::SurfaceOperator> Q2Operator::coarsened() const {
  const Q2Compliance& compliance = shared_->compliance;
  const Grid coarse{grid().points_x / 2, grid().points_y / 2, grid().length_x,
                    grid().length_y};
  if (coarse.points_x < 32 || coarse.points_y < 32)
    return nullptr;
  std::vector<double> symbol;
  for (int row = 0; row < coarse.points_y; ++row)
    for (int mode_x = 0; mode_x <= coarse.points_x / 2; ++mode_x)
      symbol.push_back(long_wave(
          compliance,
          compliance.blocks[static_cast<std::size_t>(std::abs(
                                signed_wavenumber(row, coarse.points_y))) *
                                static_cast<std::size_t>(compliance.columns()) +
                            static_cast<std::size_t>(mode_x)]));
  return std::make_unique<contact::FourierOperator>(coarse, std::move(symbol),
                                                    threads());
}

} // namespace asperity::fem
