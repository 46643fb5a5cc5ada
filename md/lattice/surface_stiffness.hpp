#pragma once

// The block seen from its lowest layer of atoms: all wavevectors of the layer
// at once. Owns the symbol of the surface and its way between the two spaces.

#include "base/fourier.hpp"
#include "cases/types/case.hpp"
#include "md/interface/interface.hpp"
#include "md/lattice/crystal.hpp"
#include "md/lattice/slab_symbol.hpp"

#include <complex>
#include <span>
#include <string>
#include <vector>

namespace asperity::md {

/// Stiffness that stands for the interface in front of every atom [N/m] >= 0.
struct ContactStiffness {
  double lateral = 0.0;
  double normal = 0.0;
};

/// K of the layer: forces that hold displacements u against the block above,
/// whose top is clamped. The uniform displacement, q = 0, costs nothing here
/// and is left to the caller.
///
/// Modes::vector keeps all three directions. Modes::normal keeps u_z alone,
/// with no tangential forces on the layer: K_n(q) = 1 / (K(q)^-1)_zz; planes x
/// and y then neither act nor are acted on.
///
/// An instance holds scratch: one thread at a time.
class SurfaceStiffness {
public:
  /// @param layer  square, even, its spacing that of the crystal
  /// @param cells  layers of cells above, >= 1
  /// @throws std::domain_error  as cell_stiffness; a layer that is not square,
  ///                            odd or of another spacing; cells < 1
  SurfaceStiffness(const Crystal& crystal, const Grid& layer, int cells,
                   cases::AtomModes modes, int threads = 1);

  const Grid& layer() const { return fourier_.grid(); }

  cases::AtomModes modes() const { return modes_; }

  /// forces = K u [N]; returns the energy u K u / 2 [J].
  double apply(const LayerView& displacement, const LayerForces& forces);

  /// displacement = (K + contact)^-1 forces without the mean of the forces;
  /// the mean of the displacement is 0.
  /// @param contact  its lateral part may be 0, and so may the normal one
  void solve(const LayerView& forces, const ContactStiffness& contact,
             const LayerForces& displacement);

  /// What one atom meets that is pushed down alone [N/m]: the mean of zz over
  /// all wavevectors.
  double local_stiffness() const;

  /// K of the half spectrum's wavevector (column jx, row jy); with Modes::
  /// normal, zz alone.
  const SymmetricBlock& at(int jx, int jy) const;

private:
  void to_spectra(const LayerView& planes);
  void from_spectra(const LayerForces& planes);

  cases::AtomModes modes_;
  RealFourier fourier_;
  std::vector<SymmetricBlock> symbol_; ///< in the order of the half spectrum
  std::vector<std::complex<double>> x_;
  std::vector<std::complex<double>> y_;
  std::vector<std::complex<double>> z_;
};

} // namespace asperity::md
