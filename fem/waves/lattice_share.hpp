#pragma once

// Distribution of the work on a node grid over ranks: the fields for the
// transforms, the rows of wavevectors for the elimination. This file defines
// the distribution and the communication; it does no computation.

#include "fem/waves/node_class_spectra.hpp"

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace asperity::fem {

/// The indices begin <= i < end.
struct Range {
  std::size_t begin = 0, end = 0;

  std::size_t size() const { return end - begin; }

  bool contains(std::size_t i) const { return begin <= i && i < end; }
};

/// Range number `part` if 0..n-1 is split in order into `parts` ranges whose
/// sizes differ by at most one.
Range piece_of(std::size_t n, std::size_t part, std::size_t parts);

/// The processes that share the work on a node grid.
enum class Among { this_process, all_ranks };

/// Each rank has memory for all data and stores its own part. Every call is
/// collective; on a single process the calls do nothing.
class LatticeShare {
public:
  /// @param spectra  spectra of one field; must outlive this object
  /// @param fields   number of fields on the node grid
  /// @throws std::domain_error  a rank has more modes than MPI can count,
  ///                            2^31 - 1
  LatticeShare(const NodeClassSpectra& spectra, std::size_t fields,
               Among among);

  Range fields() const { return fields_of(own_rank_); }

  Range rows() const { return rows_of(own_rank_); } ///< rows of |jy|

  std::size_t owner_of(std::size_t field) const;

  std::size_t n_ranks() const { return n_ranks_; }

  /// Redistributes from complete spectra of the own fields to the own rows of
  /// all fields.
  /// @param modes  modes of all fields, one field after the other
  void fields_to_rows(std::span<std::complex<double>> modes);
  /// Reverses fields_to_rows().
  void rows_to_fields(std::span<std::complex<double>> modes);

  /// Collects the own rows of one field into the complete field on every rank.
  void rows_to_all(std::span<std::complex<double>> field_modes);

  /// As above, for values that are stored row by row.
  /// @param values  a multiple of spectra.rows() numbers
  void rows_to_all(std::span<double> values) const;

  /// Sums each value over the ranks. The sum is exact if only one rank holds a
  /// nonzero value.
  void add_up(std::span<double> values) const;

private:
  struct Box {
    Range fields, rows;
  };

  Range fields_of(std::size_t rank) const {
    return piece_of(n_fields_, rank, n_ranks_);
  }

  Range rows_of(std::size_t rank) const {
    return piece_of(spectra_.rows(), rank, n_ranks_);
  }

  template <class Sent, class Received>
  void exchange(std::span<std::complex<double>> modes, const Sent& sent,
                const Received& received);
  template <class Visit>
  void each_stretch(const Box& box, const Visit& visit) const;

  const NodeClassSpectra& spectra_;
  std::size_t n_fields_;
  std::size_t n_ranks_ = 1, own_rank_ = 0;
  std::vector<std::complex<double>> out_, in_;
};

} // namespace asperity::fem
