#include "base/ranks/convolution.hpp"

#include "base/parallel_rows.hpp"

#include <algorithm>
#include <cassert>

namespace asperity {

template <class Real>
Convolution<Real>::Convolution(const Grid& grid, int threads)
    : Convolution(grid, grid, threads) {}

template <class Real>
Convolution<Real>::Convolution(const Grid& held, const Grid& grid, int threads)
    : held_(held),
      grid_(grid),
      threads_(threads),
      columns_{0, grid.half_spectrum_columns()},
      transforms_(std::make_shared<const PairTransforms<Real>>(
          grid, held.points_y, held.points_x)) {}

template <class Real>
Convolution<Real>::Convolution(const SharedRows& rows, int threads)
    : held_(rows.grid()), grid_(rows.grid()), threads_(threads) {
  if (rows.ranks() == nullptr) {
    *this = Convolution(grid_, threads);
    return;
  }
  rows.ranks()->make_transforms(grid_, rows.bounds()[1], slabs_);
  columns_ = slabs_->columns();
}

template <class Real>
auto Convolution<Real>::arranged(const EvenColumn& multipliers) const
    -> Symbol {
  const std::size_t half = half_height();
  Symbol symbol;
  symbol.values_.resize(columns_.count * half);
  parallel_rows(static_cast<int>(columns_.count), threads_, [&](int k) {
    take_column(static_cast<int>(columns_.first) + k, multipliers,
                &symbol.values_[static_cast<std::size_t>(k) * half]);
  });
  return symbol;
}

template <class Real>
void Convolution<Real>::take_column(int jx, const EvenColumn& multipliers,
                                    Real* half) const {
  const double normalise = 1.0 / static_cast<double>(grid_.size());
  std::vector<double> values(half_height());
  multipliers(jx, values);
  for (std::size_t jy = 0; jy < values.size(); ++jy)
    half[jy] = static_cast<Real>(normalise * values[jy]);
}

template <class Real>
void Convolution<Real>::mirror(Real* column) const {
  for (std::size_t jy = half_height(); jy < height(); ++jy)
    column[jy] = column[height() - jy];
}

template <class Real>
void Convolution<Real>::apply(std::span<const Real> field, const Symbol& symbol,
                              std::span<Real> answer) {
  transform(field,
            [&](std::size_t k, Real* memory) {
              std::copy_n(&symbol.values_[k * half_height()], half_height(),
                          memory);
            },
            answer, {});
}

template <class Real>
void Convolution<Real>::apply(std::span<const Real> field,
                              const EvenColumn& multipliers,
                              std::span<Real> answer,
                              std::span<std::byte> lent) {
  transform(
      field,
      [&](std::size_t k, Real* memory) {
        take_column(static_cast<int>(columns_.first + k), multipliers, memory);
      },
      answer, lent);
}

template <class Real>
template <class PutMultipliers>
void Convolution<Real>::transform(std::span<const Real> field,
                                  const PutMultipliers& put_multipliers,
                                  std::span<Real> answer,
                                  std::span<std::byte> lent) {
  if (slabs_) {
    slabs_->forward(field);
    each_slab_column([&](std::size_t k, std::span<Complex> column) {
      std::vector<Real> multipliers(height());
      put_multipliers(k, multipliers.data());
      mirror(multipliers.data());
      for (std::size_t jy = 0; jy < height(); ++jy)
        column[jy] *= multipliers[jy];
    });
    slabs_->backward(answer);
    return;
  }
  assert(field.size() == held_.size() && answer.size() == held_.size());
  prepare();
  const std::size_t stride = transforms_->column_stride();
  const std::size_t block_size = block_width * stride;
  scratch_.multipliers.resize(static_cast<std::size_t>(threads_) * block_size);
  const Spectrum spectrum = spectrum_in(answer, lent);
  transforms_->forward(field, threads_, scratch_.pairs.data(), spectrum);
  each_block(spectrum, {},
             [&](std::size_t first, std::size_t n, Complex* columns,
                 std::size_t worker) {
               Real* const multipliers =
                   &scratch_.multipliers[worker * block_size];
               for (std::size_t k = 0; k < n; ++k) {
                 put_multipliers(first + k, multipliers + k * stride);
                 mirror(multipliers + k * stride);
               }
               transforms_->convolve(columns, multipliers);
             });
  transforms_->backward(spectrum, threads_, scratch_.pairs.data(), answer);
}

template <class Real>
void Convolution<Real>::synthesise(const FillColumn& fill,
                                   std::span<Real> answer) {
  if (slabs_) {
    each_slab_column([&](std::size_t k, std::span<Complex> column) {
      std::ranges::fill(column, Complex{});
      fill(static_cast<int>(columns_.first + k), column);
    });
    slabs_->backward(answer);
    return;
  }
  assert(answer.size() == held_.size());
  prepare();
  const std::size_t stride = transforms_->column_stride();
  const Spectrum spectrum = spectrum_in(answer);
  each_block(
      spectrum, {false, true},
      [&](std::size_t first, std::size_t n, Complex* columns, std::size_t) {
        std::fill(columns, columns + block_width * stride, Complex{});
        for (std::size_t k = 0; k < n; ++k)
          fill(static_cast<int>(first + k), {columns + k * stride, height()});
        transforms_->transform_columns_back(columns);
      });
  transforms_->backward(spectrum, threads_, scratch_.pairs.data(), answer);
}

template <class Real>
void Convolution<Real>::analyse(std::span<const Real> field,
                                const TakeColumn& take) {
  if (slabs_) {
    slabs_->forward(field);
    each_slab_column([&](std::size_t k, std::span<Complex> column) {
      take(static_cast<int>(columns_.first + k), column);
    });
    return;
  }
  assert(field.size() == held_.size());
  prepare();
  const std::size_t stride = transforms_->column_stride();
  scratch_.beyond.resize(transforms_->spectrum_size());
  const Spectrum spectrum = transforms_->spectrum_in(scratch_.beyond.data());
  transforms_->forward(field, threads_, scratch_.pairs.data(), spectrum);
  each_block(
      spectrum, {true, false},
      [&](std::size_t first, std::size_t n, Complex* columns, std::size_t) {
        transforms_->transform_columns(columns);
        for (std::size_t k = 0; k < n; ++k)
          take(static_cast<int>(first + k), {columns + k * stride, height()});
      });
}

template <class Real>
void Convolution<Real>::change(std::span<const Real> field,
                               const ChangeColumn& change,
                               std::span<Real> answer) {
  assert(!slabs_ && field.size() == held_.size() &&
         answer.size() == held_.size());
  prepare();
  const std::size_t stride = transforms_->column_stride();
  const Spectrum spectrum = spectrum_in(answer);
  transforms_->forward(field, threads_, scratch_.pairs.data(), spectrum);
  each_block(
      spectrum, {},
      [&](std::size_t first, std::size_t n, Complex* columns, std::size_t) {
        transforms_->transform_columns(columns);
        for (std::size_t k = 0; k < n; ++k)
          change(static_cast<int>(first + k), {columns + k * stride, height()});
        transforms_->transform_columns_back(columns);
      });
  transforms_->backward(spectrum, threads_, scratch_.pairs.data(), answer);
}

template <class Real>
void Convolution<Real>::prepare() {
  const auto workers = static_cast<std::size_t>(threads_);
  scratch_.pairs.resize(workers * transforms_->pair_scratch());
  scratch_.columns.resize(workers * block_width * transforms_->column_stride());
}

template <class Real>
auto Convolution<Real>::spectrum_in(std::span<Real> answer,
                                    std::span<std::byte> lent) -> Spectrum {
  const std::size_t size = transforms_->size_beyond_field();
  if (lent.size() >= size * sizeof(Complex))
    return transforms_->spectrum_in(answer,
                                    reinterpret_cast<Complex*>(lent.data()));
  scratch_.beyond.resize(size);
  return transforms_->spectrum_in(answer, scratch_.beyond.data());
}

template <class Real>
template <class Change>
void Convolution<Real>::each_slab_column(const Change& change) {
  const std::span<Complex> spectrum = slabs_->spectrum();
  parallel_rows(static_cast<int>(columns_.count), threads_, [&](int number) {
    const auto k = static_cast<std::size_t>(number);
    change(k, spectrum.subspan(k * height(), height()));
  });
}

template <class Real>
template <class Change>
void Convolution<Real>::each_block(const Spectrum& spectrum, const Ways& ways,
                                   const Change& change) {
  const std::size_t stride = transforms_->column_stride();
  parallel_turns(static_cast<int>(transforms_->n_columns() / block_width),
                 threads_, [&](int turn, int worker_number) {
                   const auto worker = static_cast<std::size_t>(worker_number);
                   const std::size_t first =
                       static_cast<std::size_t>(turn) * block_width;
                   const std::size_t n =
                       std::min(block_width, columns_.count - first);
                   Complex* const columns =
                       &scratch_.columns[worker * block_width * stride];
                   if (ways.from_rows) {
                     transforms_->separate(spectrum, first, n, stride, columns);
                     clear_rest(columns, n);
                   }
                   change(first, n, columns, worker);
                   if (ways.to_rows)
                     transforms_->join(columns, first, n, stride, spectrum);
                 });
}

template <class Real>
void Convolution<Real>::clear_rest(Complex* columns, std::size_t n) const {
  const std::size_t stride = transforms_->column_stride();
  const auto held = static_cast<std::size_t>(held_.points_y);
  for (std::size_t k = 0; k < n; ++k)
    std::fill(columns + k * stride + held, columns + k * stride + height(),
              Complex{});
  std::fill(columns + n * stride, columns + block_width * stride, Complex{});
}

template class Convolution<float>;
template class Convolution<double>;

} // namespace asperity
