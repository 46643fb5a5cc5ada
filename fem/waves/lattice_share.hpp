#pragma once

// How ranks divide the work on a lattice: its fields among them for the
// transforms, the rows of waves for the elimination. Owns the division and
// what is sent in between; computes nothing.

#include "fem/waves/kind_spectra.hpp"

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace asperity::fem {

/// begin <= i < end.
struct Range {
  std::size_t begin = 0, end = 0;

  std::size_t size() const { return end - begin; }

  bool contains(std::size_t i) const { return begin <= i && i < end; }
};

/// Number `part` of `parts` pieces of 0..n-1, in order, their sizes equal or
/// one apart.
Range piece_of(std::size_t n, std::size_t part, std::size_t parts);

/// Who shares the work on a lattice.
enum class Among { this_process, all_ranks };

/// Each rank has room for everything and holds what is its own. Every call is
/// collective; on one process alone none does anything.
class LatticeShare {
public:
  /// @param spectra  of one field; outlives this
  /// @param fields   of the lattice
  /// @throws std::domain_error  more modes on a rank than MPI counts, 2^31 - 1
  LatticeShare(const KindSpectra& spectra, std::size_t fields, Among among);

  Range fields() const { return fields_of(own_rank_); }

  Range rows() const { return rows_of(own_rank_); } ///< of |jy|

  std::size_t owner_of(std::size_t field) const;

  std::size_t n_ranks() const { return n_ranks_; }

  /// From whole spectra of the own fields to the own rows of all fields.
  /// @param modes  of all fields, one after the other
  void fields_to_rows(std::span<std::complex<double>> modes);
  /// And back.
  void rows_to_fields(std::span<std::complex<double>> modes);

  /// From the own rows of one field to the whole field on every rank.
  void rows_to_all(std::span<std::complex<double>> field_modes);

  /// The same for values that lie row by row.
  /// @param values  a multiple of spectra.rows() numbers
  void rows_to_all(std::span<double> values) const;

  /// Adds up each value over the ranks; exact where one rank alone holds
  /// something other than 0.
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

  const KindSpectra& spectra_;
  std::size_t n_fields_;
  std::size_t n_ranks_ = 1, own_rank_ = 0;
  std::vector<std::complex<double>> out_, in_;
};

} // namespace asperity::fem
