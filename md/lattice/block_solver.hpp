#pragma once

// The explicit block solved exactly for given forces: one tree of small blocks
// for each coarse wavevector. Owns the factors.

#include "base/fourier.hpp"
#include "md/lattice/multiscale_block.hpp"
#include "md/lattice/slab_symbol.hpp"

#include <array>
#include <complex>
#include <span>
#include <vector>

namespace asperity::md {

/// What a BlockSolver solves besides the block itself.
struct BlockFooting {
  double contact_stiffness = 0.0; ///< on every atom of the lowest layer, in
                                  ///< each direction [N/m] >= 0
  bool is_height_held = false;    ///< the mean z of the lowest layer is fixed;
                                  ///< its mean x and y always are
};

/// u = (K + k_c)^-1 F with K the stiffness of a MultiscaleBlock, all levels and
/// the plate included.
///
/// Within a level a lateral wave couples the layers as a block tridiagonal
/// matrix. Interpolation between two levels is the same at every coarse atom,
/// so a coarse wave hangs together with the four fine ones that look alike on
/// the coarse grid and with no other: elimination from the lowest layer up
/// meets no fill, and costs what one level costs.
class BlockSolver {
public:
  /// @throws std::domain_error  no contact stiffness and no height held either:
  ///                            the block could fly off
  BlockSolver(const MultiscaleBlock& block, const BlockFooting& footing,
              int threads = 1);

  const BlockFooting& footing() const { return footing_; }

  /// @param forces  block.size() values [N]
  /// @param answer  block.size() values [m], overwritten; the held means are 0
  /// @par Accuracy  1e-11 of the largest displacement
  void solve(std::span<const double> forces, std::span<double> answer) const;

private:
  using Complex = std::complex<double>;

  struct Level {
    Level(const Grid& grid) : fourier(grid) {}

    RealFourier fourier;
    std::vector<double> share;                  ///< interpolated_share a mode
    std::vector<std::array<double, 9>> upwards; ///< on a layer from the next
    std::vector<SymmetricBlock> inverse; ///< of a layer with all below it gone:
                                         ///< layer by mode
  };

  /// Three spectra a layer, -i x, -i y, z, one layer behind the other.
  using Spectra = std::vector<std::vector<Complex>>;

  std::vector<SymmetricBlock>
  factor_level(int level, const std::vector<SymmetricBlock>& below);
  Spectra spectra_of(std::span<const double> forces) const;
  void fields_of(Spectra& spectra, std::span<double> answer) const;
  std::vector<Complex> eliminate(int level, std::vector<Complex>& layers) const;
  void gather(int level, std::vector<Complex>& lifted,
              std::vector<Complex>& layers) const;
  void substitute(int level, Complex* coarse, double plate,
                  std::vector<Complex>& layers) const;

  const MultiscaleBlock* block_;
  BlockFooting footing_;
  int threads_;
  std::vector<Level> levels_;
  double plate_stiffness_ = 0.0; ///< with everything below it gone [N/m]
};

} // namespace asperity::md
