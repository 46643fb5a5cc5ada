#include "base/mirrored_convolution.hpp"

#include "base/fourier_plans.hpp"
#include "base/pair_transforms.hpp"
#include "base/parallel_rows.hpp"

#include <algorithm>
#include <cassert>

namespace asperity {
namespace {

/// Values of a line of scratch memory, so that each begins on a cache line.
std::size_t padded_line(int points) {
  return (static_cast<std::size_t>(points) + 15) / 16 * 16;
}

/// The transforms of one line, in place, and back without a factor.
template <class Real>
class CosineLine {
public:
  using Library = Fftw<Real>;

  explicit CosineLine(int points) {
    std::vector<Real> line(padded_line(points)); // only its alignment matters
    const std::lock_guard lock(planner_mutex());
    forward_ = Library::plan_even(points, line.data(), line.data(),
                                  FFTW_REDFT10, FFTW_ESTIMATE);
    backward_ = Library::plan_even(points, line.data(), line.data(),
                                   FFTW_REDFT01, FFTW_ESTIMATE);
  }

  CosineLine(const CosineLine&) = delete;
  CosineLine& operator=(const CosineLine&) = delete;

  ~CosineLine() {
    const std::lock_guard lock(planner_mutex());
    Library::destroy(forward_);
    Library::destroy(backward_);
  }

  void forward(Real* line) const { Library::even(forward_, line, line); }

  void backward(Real* line) const { Library::even(backward_, line, line); }

private:
  typename Library::Plan forward_, backward_;
};

} // namespace

Grid quarter_of(const Grid& cell) {
  assert(cell.points_x % 2 == 0 && cell.points_y % 2 == 0);
  return {cell.points_x / 2, cell.points_y / 2, 0.5 * cell.length_x,
          0.5 * cell.length_y};
}

template <class Real>
struct MirroredConvolution<Real>::Plans {
  CosineLine<Real> row, column;
};

template <class Real>
MirroredConvolution<Real>::MirroredConvolution(const Grid& cell, int threads)
    : quarter_(quarter_of(cell)),
      threads_(threads),
      plans_(new Plans{CosineLine<Real>(quarter_.points_x),
                       CosineLine<Real>(quarter_.points_y)}) {}

template <class Real>
void MirroredConvolution<Real>::apply(std::span<const Real> field,
                                      const Multipliers& multipliers,
                                      std::span<Real> answer) {
  assert(field.size() == quarter_.size() && answer.size() == quarter_.size());
  const auto width = static_cast<std::size_t>(quarter_.points_x);
  const auto height = static_cast<std::size_t>(quarter_.points_y);
  const std::size_t column_stride = padded_line(quarter_.points_y);
  const std::size_t line_stride =
      std::max(padded_line(quarter_.points_x), block_width * column_stride);
  scratch_.spectrum.resize(quarter_.size());
  scratch_.lines.resize(static_cast<std::size_t>(threads_) * line_stride);
  const auto lines_of = [&](int worker) {
    return &scratch_.lines[static_cast<std::size_t>(worker) * line_stride];
  };
  const auto each_row = [&](const Real* from, Real* to, const auto& change) {
    parallel_turns(quarter_.points_y, threads_, [&](int row, int worker) {
      const std::size_t at = static_cast<std::size_t>(row) * width;
      Real* const line = lines_of(worker);
      std::copy_n(from + at, width, line);
      change(line);
      std::copy_n(line, width, to + at);
    });
  };
  Real* const spectrum = scratch_.spectrum.data();
  each_row(field.data(), spectrum,
           [&](Real* line) { plans_->row.forward(line); });
  const double normalise = 0.25 / static_cast<double>(quarter_.size());
  const auto blocks = static_cast<int>((width + block_width - 1) / block_width);
  parallel_turns(blocks, threads_, [&](int block, int worker) {
    const std::size_t first = static_cast<std::size_t>(block) * block_width;
    const std::size_t n = std::min(block_width, width - first);
    Real* const columns = lines_of(worker);
    for (std::size_t y = 0; y < height; ++y)
      for (std::size_t k = 0; k < n; ++k)
        columns[k * column_stride + y] = spectrum[y * width + first + k];
    std::vector<double> factors(height + 1);
    for (std::size_t k = 0; k < n; ++k) {
      Real* const column = columns + k * column_stride;
      plans_->column.forward(column);
      multipliers(static_cast<int>(first + k), factors);
      for (std::size_t y = 0; y < height; ++y)
        column[y] *= static_cast<Real>(normalise * factors[y]);
      plans_->column.backward(column);
    }
    for (std::size_t y = 0; y < height; ++y)
      for (std::size_t k = 0; k < n; ++k)
        spectrum[y * width + first + k] = columns[k * column_stride + y];
  });
  each_row(spectrum, answer.data(),
           [&](Real* line) { plans_->row.backward(line); });
}

template class MirroredConvolution<float>;
template class MirroredConvolution<double>;

} // namespace asperity
