#include "fem/waves/lattice_share.hpp"

#include "fem/parallel/ranks.hpp"

#include <mpi.h>

#include <algorithm>

namespace asperity::fem {

Range piece_of(std::size_t n, std::size_t part, std::size_t parts) {
  return {n * part / parts, n * (part + 1) / parts};
}

LatticeShare::LatticeShare(const NodeClassSpectra& spectra, std::size_t fields,
                           Among among)
    : spectra_(spectra), n_fields_(fields) {
  if (among == Among::this_process)
    return;
  n_ranks_ = static_cast<std::size_t>(fem::n_ranks());
  own_rank_ = static_cast<std::size_t>(fem::own_rank());
  mpi_count((fields / n_ranks_ + 1) * spectra.size(),
            "Fourier modes on a rank");
}

std::size_t LatticeShare::owner_of(std::size_t field) const {
  std::size_t rank = 0;
  while (!fields_of(rank).contains(field))
    ++rank;
  return rank;
}

/// Calls visit(first, count) for each contiguous range of the fields' modes
/// that holds wavevectors of the rows.
template <class Visit>
void LatticeShare::each_stretch(const Box& box, const Visit& visit) const {
  for (std::size_t field = box.fields.begin; field < box.fields.end; ++field)
    spectra_.each_stretch(box.rows.begin, box.rows.end,
                          [&](std::size_t first, std::size_t count) {
                            visit(field * spectra_.size() + first, count);
                          });
}

/// @param sent, received  the box that is sent to a rank, or received from it
template <class Sent, class Received>
void LatticeShare::exchange(std::span<std::complex<double>> modes,
                            const Sent& sent, const Received& received) {
  if (n_ranks_ == 1)
    return;
  constexpr const char* exchanged = "modes that a rank exchanges";
  std::vector<int> out_starts, in_starts, out_counts, in_counts;
  out_.clear();
  std::size_t n_in = 0;
  for (std::size_t rank = 0; rank < n_ranks_; ++rank) {
    out_starts.push_back(mpi_count(out_.size(), exchanged));
    in_starts.push_back(mpi_count(n_in, exchanged));
    if (rank != own_rank_) {
      each_stretch(sent(rank), [&](std::size_t first, std::size_t count) {
        const auto from = modes.begin() + static_cast<std::ptrdiff_t>(first);
        out_.insert(out_.end(), from,
                    from + static_cast<std::ptrdiff_t>(count));
      });
      each_stretch(received(rank),
                   [&](std::size_t, std::size_t count) { n_in += count; });
    }
    out_counts.push_back(mpi_count(out_.size(), exchanged) - out_starts.back());
    in_counts.push_back(mpi_count(n_in, exchanged) - in_starts.back());
  }
  in_.resize(n_in);
  MPI_Alltoallv(out_.data(), out_counts.data(), out_starts.data(),
                MPI_C_DOUBLE_COMPLEX, in_.data(), in_counts.data(),
                in_starts.data(), MPI_C_DOUBLE_COMPLEX, MPI_COMM_WORLD);
  auto value = in_.begin();
  for (std::size_t rank = 0; rank < n_ranks_; ++rank)
    if (rank != own_rank_)
      each_stretch(received(rank), [&](std::size_t first, std::size_t count) {
        const auto end = value + static_cast<std::ptrdiff_t>(count);
        std::copy(value, end, &modes[first]);
        value = end;
      });
}

void LatticeShare::fields_to_rows(std::span<std::complex<double>> modes) {
  exchange(
      modes,
      [&](std::size_t to) {
        return Box{fields(), rows_of(to)};
      },
      [&](std::size_t from) {
        return Box{fields_of(from), rows()};
      });
}

void LatticeShare::rows_to_fields(std::span<std::complex<double>> modes) {
  exchange(
      modes,
      [&](std::size_t to) {
        return Box{fields_of(to), rows()};
      },
      [&](std::size_t from) {
        return Box{fields(), rows_of(from)};
      });
}

void LatticeShare::rows_to_all(std::span<std::complex<double>> field_modes) {
  constexpr Range one{0, 1};
  exchange(
      field_modes,
      [&](std::size_t) {
        return Box{one, rows()};
      },
      [&](std::size_t from) {
        return Box{one, rows_of(from)};
      });
}

void LatticeShare::rows_to_all(std::span<double> values) const {
  if (n_ranks_ == 1)
    return;
  constexpr const char* of_face = "entries of the surface compliance";
  const std::size_t row_size = values.size() / spectra_.rows();
  std::vector<int> starts, counts;
  for (std::size_t rank = 0; rank < n_ranks_; ++rank) {
    starts.push_back(mpi_count(rows_of(rank).begin * row_size, of_face));
    counts.push_back(mpi_count(rows_of(rank).size() * row_size, of_face));
  }
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, values.data(),
                 counts.data(), starts.data(), MPI_DOUBLE, MPI_COMM_WORLD);
}

void LatticeShare::add_up(std::span<double> values) const {
  if (n_ranks_ > 1)
    MPI_Allreduce(MPI_IN_PLACE, values.data(),
                  mpi_count(values.size(), "values to sum"), MPI_DOUBLE,
                  MPI_SUM, MPI_COMM_WORLD);
}

} // namespace asperity::fem
