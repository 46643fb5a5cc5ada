#pragma once

// The algebra of one mode of one layer: three amplitudes, of which x and y are
// multiplied by -i, and the real symmetric matrices that act on them. It also
// defines how both transform from the mode q to the mode -q.

#include "md/lattice/slab_symbol.hpp"

#include <Eigen/Core>

#include <array>
#include <complex>
#include <cstddef>

namespace asperity::md {

using WaveBlock = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using WaveVector = Eigen::Matrix<std::complex<double>, 3, 1>;

inline WaveBlock full(const SymmetricBlock& block) {
  WaveBlock matrix;
  matrix << block.xx, block.xy, block.xz, block.xy, block.yy, block.yz,
      block.xz, block.yz, block.zz;
  return matrix;
}

inline WaveBlock full(const std::array<double, 9>& block) {
  return Eigen::Map<const WaveBlock>(block.data());
}

inline SymmetricBlock packed(const WaveBlock& matrix) {
  return {matrix(0, 0),
          matrix(1, 1),
          matrix(2, 2),
          0.5 * (matrix(0, 1) + matrix(1, 0)),
          0.5 * (matrix(0, 2) + matrix(2, 0)),
          0.5 * (matrix(1, 2) + matrix(2, 1))};
}

/// Adds the block, or the block of the mode -q, to the sum.
inline void add(SymmetricBlock& sum, const SymmetricBlock& block,
                bool is_conjugate) {
  const double sign = is_conjugate ? -1.0 : 1.0;
  sum.xx += block.xx;
  sum.yy += block.yy;
  sum.zz += block.zz;
  sum.xy += block.xy;
  sum.xz += sign * block.xz;
  sum.yz += sign * block.yz;
}

/// Returns the amplitudes of the same real fields at -q if `is_conjugate` is
/// set, and the vector itself otherwise.
inline WaveVector conjugated(const WaveVector& vector, bool is_conjugate) {
  if (!is_conjugate)
    return vector;
  return {-std::conj(vector(0)), -std::conj(vector(1)), std::conj(vector(2))};
}

/// Three spectra of a layer, each with n modes, stored contiguously.
struct WavePlanes {
  std::complex<double>* x = nullptr;
  std::size_t n = 0;

  WaveVector at(std::size_t mode) const {
    return {x[mode], x[n + mode], x[2 * n + mode]};
  }

  void set(std::size_t mode, const WaveVector& vector) const {
    x[mode] = vector(0);
    x[n + mode] = vector(1);
    x[2 * n + mode] = vector(2);
  }
};

} // namespace asperity::md
