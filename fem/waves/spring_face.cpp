#include "fem/waves/spring_face.hpp"

#include "base/parallel_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::fem {
namespace {

constexpr int most_iterations = 500;

/// Computes (block + diag(added))^-1, with all entries stored.
template <std::size_t n_classes>
void invert_block(const SimdBatch* block, const double* added,
                  SimdBatch* inverse) {
  std::array<SimdBatch, triangle(n_classes)> factor;
  for (std::size_t j = 0; j < n_classes; ++j) {
    for (std::size_t i = j; i < n_classes; ++i)
      factor[in_triangle(n_classes, i, j)] = block[i * n_classes + j];
    factor[in_triangle(n_classes, j, j)] += added[j];
  }
  factorise<n_classes>(factor.data());
  std::fill_n(inverse, n_classes * n_classes, SimdBatch{});
  for (std::size_t j = 0; j < n_classes; ++j)
    inverse[j * n_classes + j] += 1.0;
  solve_lower<n_classes, n_classes>(factor.data(), inverse);
  solve_diagonal<n_classes, n_classes>(factor.data(), inverse);
  solve_upper<n_classes, n_classes>(factor.data(), inverse);
}

} // namespace

SpringFace::SpringFace(const NodeClassSpectra& spectra,
                       const LatticeFactors& factors, const LatticeShare& share,
                       bool shifts_freely, int threads)
    : spectra_(spectra),
      shifts_freely_(shifts_freely),
      threads_(threads),
      compliance_(spectra.rows() * spectra.batches() * spectra.node_classes() *
                  spectra.node_classes()),
      modes_(spectra.size()) {
  const std::size_t block_size =
      spectra.node_classes() * spectra.node_classes();
  const Range rows = share.rows();
  SimdBatch* block = &compliance_[rows.begin * spectra.batches() * block_size];
  for (std::size_t row = rows.begin; row < rows.end; ++row)
    for (std::size_t number = 0; number < spectra.batches(); ++number) {
      factors.face_compliance(spectra.batch(row, number), block);
      block += block_size;
    }
  share.rows_to_all({reinterpret_cast<double*>(compliance_.data()),
                     compliance_.size() * lanes});
}

std::size_t SpringFace::bytes() const {
  return (compliance_.size() + inverse_.size()) * sizeof(SimdBatch) +
         modes_.size() * sizeof(modes_[0]) +
         (nodes_.size() + local_.size() + of_ones_.size() + whole_.size() +
          r_.size() + z_.size() + d_.size() + cd_.size()) *
             sizeof(double);
}

void SpringFace::set_springs(std::span<const double> springs) {
  const Grid& grid = spectra_.grid();
  const std::size_t degree = spectra_.node_classes() == 1 ? 1 : 2;
  const auto width = static_cast<std::size_t>(grid.points_x);
  nodes_.clear();
  local_.clear();
  std::array<double, 5> sum{}, count{}; // by node class, then of all nodes
  for (std::size_t i = 0; i < springs.size(); ++i) {
    if (springs[i] <= 0.0)
      continue;
    nodes_.push_back(i);
    local_.push_back(1.0 / springs[i]);
    const std::size_t node_class =
        i % width % degree + 2 * (i / width % degree);
    for (const std::size_t at : {node_class, std::size_t{4}}) {
      sum[at] += local_.back();
      count[at] += 1.0;
    }
  }
  if (nodes_.empty())
    return;
  std::array<double, 4> mean{};
  for (std::size_t node_class = 0; node_class < 4; ++node_class) {
    const std::size_t at = count[node_class] > 0.0 ? node_class : 4;
    mean[node_class] = sum[at] / count[at];
  }
  for (auto* field : {&whole_, &r_, &z_, &d_, &cd_})
    field->assign(grid.size(), 0.0);
  invert(mean);
  if (!shifts_freely_)
    return;
  for (const std::size_t node : nodes_)
    r_[node] = 1.0;
  of_ones_.assign(grid.size(), 0.0);
  sum_of_ones_ = 0.0;
  estimate(r_, of_ones_);
  for (const std::size_t node : nodes_)
    sum_of_ones_ += of_ones_[node];
}

void SpringFace::invert(std::span<const double> local_compliance) {
  inverse_.resize(compliance_.size());
  const std::size_t step = spectra_.node_classes() * spectra_.node_classes();
  for (std::size_t i = 0; i < compliance_.size(); i += step)
    if (step == 1)
      invert_block<1>(&compliance_[i], local_compliance.data(), &inverse_[i]);
    else
      invert_block<4>(&compliance_[i], local_compliance.data(), &inverse_[i]);
}

void SpringFace::apply(const Symbol& symbol, std::span<const double> field,
                       std::span<double> result) {
  const std::size_t n_classes = spectra_.node_classes();
  spectra_.forward(field, modes_, scratch_);
  parallel_rows(static_cast<int>(spectra_.rows()), threads_, [&](int turn) {
    const auto row = static_cast<std::size_t>(turn);
    std::array<SimdBatch, 4 * wave_columns> values, answer;
    for (std::size_t number = 0; number < spectra_.batches(); ++number) {
      const WaveBatch batch = spectra_.batch(row, number);
      const SimdBatch* const block =
          &symbol[(row * spectra_.batches() + number) * n_classes * n_classes];
      spectra_.load(modes_, batch, 1, values.data());
      answer.fill(SimdBatch{});
      for (std::size_t i = 0; i < n_classes; ++i)
        for (std::size_t k = 0; k < n_classes; ++k)
          for (std::size_t j = 0; j < wave_columns; ++j)
            answer[i * wave_columns + j] +=
                block[i * n_classes + k] * values[k * wave_columns + j];
      spectra_.store(answer.data(), batch, 1, modes_);
    }
  });
  spectra_.backward(modes_, result, scratch_);
}

void SpringFace::compliance(std::span<const double> d,
                            std::span<double> result) {
  apply(compliance_, d, whole_);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    result[nodes_[i]] = whole_[nodes_[i]] + local_[i] * d[nodes_[i]];
}

void SpringFace::estimate(std::span<const double> residual,
                          std::span<double> result) {
  apply(inverse_, residual, whole_);
  double sum = 0.0;
  for (const std::size_t node : nodes_) {
    result[node] = whole_[node];
    sum += whole_[node];
  }
  if (shifts_freely_ && sum_of_ones_ > 0.0)
    for (const std::size_t node : nodes_)
      result[node] -= sum / sum_of_ones_ * of_ones_[node];
}

void SpringFace::remove_mean(std::span<double> field) const {
  double sum = 0.0;
  for (const std::size_t node : nodes_)
    sum += field[node];
  for (const std::size_t node : nodes_)
    field[node] -= sum / static_cast<double>(nodes_.size());
}

double SpringFace::dot(std::span<const double> a,
                       std::span<const double> b) const {
  double sum = 0.0;
  for (const std::size_t node : nodes_)
    sum += a[node] * b[node];
  return sum;
}

SpringSolve SpringFace::solve(std::span<const double> free_displacement,
                              double total_force, double tolerance,
                              std::span<double> forces, double& shift) {
  std::fill(forces.begin(), forces.end(), 0.0);
  for (const std::size_t node : nodes_) {
    r_[node] = free_displacement[node];
    d_[node] = 0.0;
  }
  double allowed = dot(r_, r_);
  if (shifts_freely_) { // the initial guess has the required sum, which the
                        // steps preserve
    for (const std::size_t node : nodes_)
      forces[node] = total_force / sum_of_ones_ * of_ones_[node];
    compliance(forces, cd_);
    allowed += dot(cd_, cd_);
    for (const std::size_t node : nodes_)
      r_[node] -= cd_[node];
  }
  allowed *= tolerance * tolerance;
  SpringSolve answer;
  double before = 0.0;
  for (;; ++answer.iterations) {
    if (shifts_freely_)
      remove_mean(r_);
    if (dot(r_, r_) <= allowed)
      break;
    estimate(r_, z_);
    const double slope = dot(r_, z_);
    answer.converged = slope > 0.0 && answer.iterations < most_iterations;
    if (!answer.converged)
      break;
    const double beta = before > 0.0 ? slope / before : 0.0;
    before = slope;
    for (const std::size_t node : nodes_)
      d_[node] = z_[node] + beta * d_[node];
    compliance(d_, cd_);
    const double length = slope / dot(d_, cd_);
    for (const std::size_t node : nodes_) {
      forces[node] += length * d_[node];
      r_[node] -= length * cd_[node];
    }
  }
  shift = 0.0;
  if (shifts_freely_) {
    compliance(forces, cd_);
    for (const std::size_t node : nodes_)
      shift += cd_[node] - free_displacement[node];
    shift /= static_cast<double>(nodes_.size());
  }
  return answer;
}

} // namespace asperity::fem
