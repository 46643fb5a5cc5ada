#pragma once

// The direct solver of the explicit block for given forces. The solver
// factorises one tree of small matrix blocks per coarse wavevector and stores
// the factors.

#include "base/fourier.hpp"
#include "md/lattice/multiscale_block.hpp"
#include "md/lattice/slab_symbol.hpp"

#include <array>
#include <complex>
#include <span>
#include <vector>

namespace asperity::md {

/// Support conditions that a BlockSolver adds to the stiffness of the block.
struct BlockSupport {
  double contact_stiffness = 0.0; ///< stiffness on every atom of the lowest
                                  ///< layer, in each direction [N/m], >= 0
  bool is_height_held = false;    ///< whether the mean z of the lowest layer is
                                  ///< fixed; its mean x and y always are
};

/// Computes u = (K + k_c)^-1 F, where K is the stiffness of a MultiscaleBlock
/// with all levels and the plate, and k_c is the contact stiffness.
///
/// Within a level, each lateral wavevector couples the layers through a block
/// tridiagonal matrix. The interpolation between two levels is the same at
/// every coarse atom, so a coarse mode couples only to the four fine modes that
/// alias to it. Block elimination from the lowest layer upwards therefore
/// produces no fill-in, and its cost per level is the cost of a single-level
/// block.
class BlockSolver {
public:
  /// @throws std::domain_error  the contact stiffness is zero and the mean
  ///                            height is not held, so that the rigid
  ///                            translation in z is not determined
  BlockSolver(const MultiscaleBlock& block, const BlockSupport& support,
              int threads = 1);

  const BlockSupport& support() const { return support_; }

  /// @param forces  block.size() values [N]
  /// @param answer  block.size() values [m], overwritten; the held means are 0
  /// @par Accuracy  1e-11 of the largest displacement
  void solve(std::span<const double> forces, std::span<double> answer) const;

private:
  using Complex = std::complex<double>;

  struct Level {
    Level(const Grid& grid) : fourier(grid) {}

    RealFourier fourier;
    std::vector<double> share;                  ///< interpolated_share per mode
    std::vector<std::array<double, 9>> upwards; ///< coupling to the next layer
    std::vector<SymmetricBlock> inverse; ///< of a layer, with all layers below
                                         ///< it eliminated; layer by mode
  };

  /// Three spectra per layer, -i x, -i y and z, stored contiguously layer by
  /// layer.
  using Spectra = std::vector<std::vector<Complex>>;

  // `at` is the number of a level, from the finest one.
  std::vector<SymmetricBlock>
  factor_level(int at, const std::vector<SymmetricBlock>& below);
  Spectra spectra_of(std::span<const double> forces) const;
  void fields_of(Spectra& spectra, std::span<double> answer) const;
  std::vector<Complex> eliminate(int at, std::vector<Complex>& layers) const;
  void gather(int at, std::vector<Complex>& lifted,
              std::vector<Complex>& layers) const;
  void substitute(int at, Complex* coarse, double plate,
                  std::vector<Complex>& layers) const;

  const MultiscaleBlock* block_;
  BlockSupport support_;
  int threads_;
  std::vector<Level> levels_;
  double plate_stiffness_ = 0.0; ///< all layers below eliminated [N/m]
};

} // namespace asperity::md
