#include "ranks/convolution.hpp"

#include "base/parallel_rows.hpp"
#include "base/require.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>

namespace asperity {
namespace {

/// Number of rounds in which the columns are exchanged: the buffers of a round
/// then take a quarter of the memory of the spectrum, and on a rank with many
/// nodes, whose messages stay long, a sixteenth.
std::size_t wanted_rounds(std::size_t nodes) {
  constexpr std::size_t many_nodes = std::size_t{1} << 23;
  return nodes < many_nodes ? 8 : 32;
}

/// The first block of each rank, then the number of blocks.
std::vector<std::size_t> divided(std::size_t n_blocks, std::size_t n_ranks) {
  std::vector<std::size_t> first(n_ranks + 1);
  for (std::size_t r = 0; r <= n_ranks; ++r)
    first[r] = n_blocks * r / n_ranks;
  return first;
}

} // namespace

template <class Real>
Convolution<Real>::Convolution(SharedRows rows, int threads)
    : Convolution(rows, rows.grid(), threads) {}

template <class Real>
Convolution<Real>::Convolution(SharedRows rows, const Grid& grid, int threads)
    : rows_(std::move(rows)),
      grid_(grid),
      threads_(threads),
      n_columns_(grid.half_spectrum_columns()) {
  for (std::size_t r = 0; r + 1 < rows_.bounds().size(); ++r)
    if (rows_.bounds()[r] % 2 != 0)
      refuse_argument("first row of a rank", rows_.bounds()[r], "even");
  const int width = rows_.grid().points_x;
  is_dense_ = rows_.ranks() != nullptr && rows_.count() % 2 == 0 &&
              width % 2 == 0 && grid.points_x == width;
  transforms_ = std::make_shared<const PairTransforms<Real>>(
      grid, rows_.count(), width, is_dense_);
  if (rows_.ranks() != nullptr) {
    n_ranks_ = static_cast<std::size_t>(rows_.ranks()->size());
    own_ = static_cast<std::size_t>(rows_.ranks()->rank());
  }
  first_blocks_ = divided(transforms_->n_columns() / block_width, n_ranks_);
  std::size_t most = 1; // blocks of a rank
  for (std::size_t r = 0; r < n_ranks_; ++r)
    most = std::max(most, first_blocks_[r + 1] - first_blocks_[r]);
  // All ranks exchange the same number of times, also if shares are uneven.
  const std::size_t rounds = wanted_rounds(grid.size() / n_ranks_);
  blocks_a_round_ =
      std::max(static_cast<std::size_t>(threads), (most + rounds - 1) / rounds);
  n_rounds_ = (most + blocks_a_round_ - 1) / blocks_a_round_;
}

template <class Real>
SpectrumColumns Convolution<Real>::columns() const {
  const std::size_t first =
      std::min(n_columns_, first_blocks_[own_] * block_width);
  const std::size_t end =
      std::min(n_columns_, first_blocks_[own_ + 1] * block_width);
  return {first, end - first};
}

template <class Real>
auto Convolution<Real>::arranged(const EvenColumn& multipliers) const
    -> Symbol {
  const SpectrumColumns own = columns();
  const std::size_t height = half_height();
  Symbol symbol;
  symbol.values_.resize(own.count * height);
  parallel_rows(static_cast<int>(own.count), threads_, [&](int k) {
    take_column(static_cast<int>(own.first) + k, multipliers,
                &symbol.values_[static_cast<std::size_t>(k) * height]);
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
  const auto height = static_cast<std::size_t>(grid_.points_y);
  for (std::size_t jy = half_height(); jy < height; ++jy)
    column[jy] = column[height - jy];
}

template <class Real>
auto Convolution<Real>::blocks_of(std::size_t rank, std::size_t round) const
    -> Blocks {
  const std::size_t end = first_blocks_[rank + 1];
  const std::size_t first =
      std::min(end, first_blocks_[rank] + round * blocks_a_round_);
  return {first, std::min(blocks_a_round_, end - first)};
}

template <class Real>
std::size_t Convolution<Real>::padded_rows(std::size_t rank) const {
  const auto rows =
      static_cast<std::size_t>(rows_.bounds()[rank + 1] - rows_.bounds()[rank]);
  return (rows + 1) / 2 * 2;
}

template <class Real>
std::size_t Convolution<Real>::columns_in(std::size_t block) const {
  return std::min(block_width,
                  n_columns_ - std::min(n_columns_, block * block_width));
}

template <class Real>
void Convolution<Real>::apply(std::span<const Real> field, const Symbol& symbol,
                              std::span<Real> answer) {
  const std::size_t stride = transforms_->column_stride();
  const std::size_t height = half_height();
  transform(
      field,
      [&](std::size_t first, std::size_t n, Real* memory) {
        for (std::size_t k = 0; k < n; ++k)
          std::copy_n(&symbol.values_[(first + k) * height], height,
                      memory + k * stride);
      },
      answer);
}

template <class Real>
void Convolution<Real>::apply(std::span<const Real> field,
                              const EvenColumn& multipliers,
                              std::span<Real> answer) {
  const std::size_t stride = transforms_->column_stride();
  const std::size_t first_own = columns().first;
  transform(
      field,
      [&](std::size_t first, std::size_t n, Real* memory) {
        for (std::size_t k = 0; k < n; ++k)
          take_column(static_cast<int>(first_own + first + k), multipliers,
                      memory + k * stride);
      },
      answer);
}

template <class Real>
template <class PutMultipliers>
void Convolution<Real>::transform(std::span<const Real> field,
                                  const PutMultipliers& put_multipliers,
                                  std::span<Real> answer) {
  assert(field.size() == rows_.size() && answer.size() == rows_.size());
  Complex* const spectrum = prepared(answer);
  const std::size_t block_size = block_width * transforms_->column_stride();
  scratch_.multipliers.resize(static_cast<std::size_t>(threads_) * block_size);
  transforms_->forward(field, threads_, scratch_.pairs.data(), spectrum);
  each_own_block(spectrum, {},
                 [&](std::size_t first, std::size_t n, Complex* columns,
                     std::size_t worker) {
                   Real* const multipliers =
                       &scratch_.multipliers[worker * block_size];
                   put_multipliers(first, n, multipliers);
                   for (std::size_t k = 0; k < n; ++k)
                     mirror(multipliers + k * transforms_->column_stride());
                   transforms_->convolve(columns, multipliers);
                 });
  transforms_->backward(spectrum, threads_, scratch_.pairs.data(), answer);
}

template <class Real>
void Convolution<Real>::synthesise(const FillColumn& fill,
                                   std::span<Real> answer) {
  assert(answer.size() == rows_.size());
  Complex* const spectrum = prepared(answer);
  const std::size_t stride = transforms_->column_stride();
  const auto height = static_cast<std::size_t>(grid_.points_y);
  each_own_block(
      spectrum, {false, true},
      [&](std::size_t first, std::size_t n, Complex* columns, std::size_t) {
        std::fill(columns, columns + block_width * stride, Complex{});
        for (std::size_t k = 0; k < n; ++k)
          fill(static_cast<int>(this->columns().first + first + k),
               {columns + k * stride, height});
        transforms_->transform_columns_back(columns);
      });
  transforms_->backward(spectrum, threads_, scratch_.pairs.data(), answer);
}

template <class Real>
void Convolution<Real>::analyse(std::span<const Real> field,
                                const TakeColumn& take) {
  assert(field.size() == rows_.size());
  Complex* const spectrum = prepared({});
  const std::size_t stride = transforms_->column_stride();
  const auto height = static_cast<std::size_t>(grid_.points_y);
  transforms_->forward(field, threads_, scratch_.pairs.data(), spectrum);
  each_own_block(
      spectrum, {true, false},
      [&](std::size_t first, std::size_t n, Complex* columns, std::size_t) {
        transforms_->transform_columns(columns);
        for (std::size_t k = 0; k < n; ++k)
          take(static_cast<int>(this->columns().first + first + k),
               {columns + k * stride, height});
      });
}

template <class Real>
auto Convolution<Real>::prepared(std::span<Real> answer) -> Complex* {
  const auto workers = static_cast<std::size_t>(threads_);
  scratch_.pairs.resize(workers * transforms_->pair_stride());
  scratch_.columns.resize(workers * block_width * transforms_->column_stride());
  if (!is_alone()) {
    const std::size_t most = blocks_a_round_ * block_width;
    std::size_t all_rows = 0;
    for (std::size_t r = 0; r < n_ranks_; ++r)
      all_rows += padded_rows(r);
    scratch_.by_rows.resize(n_ranks_ * most * padded_rows(own_));
    scratch_.by_ranks.resize(most * all_rows);
  }
  // FFTW plans for arrays on 16-byte boundaries.
  const bool is_aligned =
      reinterpret_cast<std::uintptr_t>(answer.data()) % 16 == 0;
  if (is_dense_ && is_aligned && !answer.empty())
    return reinterpret_cast<Complex*>(answer.data());
  scratch_.spectrum.resize(transforms_->spectrum_size());
  return scratch_.spectrum.data();
}

template <class Real>
template <class Change>
void Convolution<Real>::each_own_block(Complex* spectrum, const Ways& ways,
                                       const Change& change) {
  if (is_alone()) {
    each_block_alone(spectrum, ways, change);
    return;
  }
  std::vector<std::size_t> sent(n_ranks_), received(n_ranks_);
  const std::span<std::byte> rows_side =
      std::as_writable_bytes(std::span(scratch_.by_rows));
  const std::span<std::byte> ranks_side =
      std::as_writable_bytes(std::span(scratch_.by_ranks));
  for (std::size_t round = 0; round < n_rounds_; ++round) {
    const Blocks own = blocks_of(own_, round);
    for (std::size_t r = 0; r < n_ranks_; ++r) {
      sent[r] = blocks_of(r, round).count * block_width * padded_rows(own_) *
                sizeof(Complex);
      received[r] = own.count * block_width * padded_rows(r) * sizeof(Complex);
    }
    if (ways.from_rows) {
      each_block(round, [&](std::size_t block, Complex* columns) {
        transforms_->separate(spectrum, block * block_width, columns_in(block),
                              padded_rows(own_), columns);
      });
      rows_.ranks()->exchange(rows_side, sent, ranks_side, received);
    }
    change_own(own, ways, change);
    if (ways.to_rows) {
      rows_.ranks()->exchange(ranks_side, received, rows_side, sent);
      each_block(round, [&](std::size_t block, Complex* columns) {
        transforms_->join(columns, block * block_width, columns_in(block),
                          padded_rows(own_), spectrum);
      });
    }
  }
}

/// Without the buffers of an exchange.
template <class Real>
template <class Change>
void Convolution<Real>::each_block_alone(Complex* spectrum, const Ways& ways,
                                         const Change& change) {
  const std::size_t stride = transforms_->column_stride();
  parallel_turns(static_cast<int>(transforms_->n_columns() / block_width),
                 threads_, [&](int turn, int worker_number) {
                   const auto block = static_cast<std::size_t>(turn);
                   const auto worker = static_cast<std::size_t>(worker_number);
                   const std::size_t first = block * block_width,
                                     n = columns_in(block);
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
  const auto held = static_cast<std::size_t>(rows_.grid().points_y);
  const auto height = static_cast<std::size_t>(grid_.points_y);
  for (std::size_t k = 0; k < n; ++k)
    std::fill(columns + k * stride + held, columns + k * stride + height,
              Complex{});
  std::fill(columns + n * stride, columns + block_width * stride, Complex{});
}

template <class Real>
template <class DoBlock>
void Convolution<Real>::each_block(std::size_t round, const DoBlock& do_block) {
  std::vector<std::size_t> blocks; // in the order of by_rows
  blocks.reserve(n_ranks_ * blocks_a_round_);
  for (std::size_t r = 0; r < n_ranks_; ++r) {
    const Blocks some = blocks_of(r, round);
    for (std::size_t b = 0; b < some.count; ++b)
      blocks.push_back(some.first + b);
  }
  parallel_rows(static_cast<int>(blocks.size()), threads_, [&](int turn) {
    const auto at = static_cast<std::size_t>(turn);
    do_block(blocks[at],
             &scratch_.by_rows[at * block_width * padded_rows(own_)]);
  });
}

template <class Real>
template <class Change>
void Convolution<Real>::change_own(const Blocks& own, const Ways& ways,
                                   const Change& change) {
  const std::size_t stride = transforms_->column_stride();
  const auto held = static_cast<std::size_t>(rows_.grid().points_y);
  const auto height = static_cast<std::size_t>(grid_.points_y);
  parallel_turns(
      static_cast<int>(own.count), threads_, [&](int turn, int worker_number) {
        const auto block = static_cast<std::size_t>(turn);
        const auto worker = static_cast<std::size_t>(worker_number);
        const std::size_t n = columns_in(own.first + block);
        Complex* const columns =
            &scratch_.columns[worker * block_width * stride];
        if (ways.from_rows) {
          each_piece(block, own.count, n,
                     [&](Complex* piece, std::size_t at, std::size_t rows) {
                       std::copy_n(piece, rows, columns + at);
                     });
          clear_rest(columns, n);
        }
        change((own.first - first_blocks_[own_] + block) * block_width, n,
               columns, worker);
        if (ways.to_rows)
          each_piece(block, own.count, n,
                     [&](Complex* piece, std::size_t at, std::size_t rows) {
                       std::copy_n(columns + at, rows, piece);
                       if (rows % 2 != 0) // the row that completes a pair
                         piece[rows] =
                             held < height ? columns[at + rows] : Complex{};
                     });
      });
}

template <class Real>
template <class Copy>
void Convolution<Real>::each_piece(std::size_t block, std::size_t n_blocks,
                                   std::size_t n, const Copy& copy) {
  const std::size_t stride = transforms_->column_stride();
  Complex* of_rank = scratch_.by_ranks.data();
  for (std::size_t r = 0; r < n_ranks_; ++r) {
    const std::size_t padded = padded_rows(r);
    const auto first = static_cast<std::size_t>(rows_.bounds()[r]);
    const auto rows = static_cast<std::size_t>(rows_.bounds()[r + 1]) - first;
    for (std::size_t k = 0; k < n; ++k)
      copy(of_rank + (block * block_width + k) * padded, k * stride + first,
           rows);
    of_rank += n_blocks * block_width * padded;
  }
}

template class Convolution<float>;
template class Convolution<double>;

} // namespace asperity
