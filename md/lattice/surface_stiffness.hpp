#pragma once

// The surface stiffness of the block, i.e. its response at the lowest layer of
// atoms for all lateral wavevectors. It stores the symbol and transforms
// between real space and Fourier space.

#include "base/fourier.hpp"
#include "md/interface/interface.hpp"
#include "md/lattice/crystal.hpp"
#include "md/lattice/slab_symbol.hpp"
#include "mechanics/md_settings.hpp"

#include <complex>
#include <span>
#include <string>
#include <vector>

namespace asperity::md {

/// Stiffness on every atom that represents the interface [N/m], >= 0.
struct ContactStiffness {
  double lateral = 0.0;
  double normal = 0.0;
};

/// K is the surface stiffness of the lowest layer: it yields the forces that
/// maintain the displacements u against the block above, whose far boundary is
/// clamped. The uniform displacement, q = 0, has no stiffness here and is left
/// to the caller.
///
/// AtomModes::vector includes all three directions. AtomModes::normal includes
/// only u_z, with no tangential forces on the layer: K_n(q) = 1 / (K(q)^-1)_zz.
/// The planes x and y then have no effect, and no forces act on them.
///
/// An instance contains work arrays and must be used by one thread at a time.
class SurfaceStiffness {
public:
  /// @param layer  square grid, even number of points per side, with the
  ///               spacing of the crystal
  /// @param cells  number of layers of cells above, >= 1
  /// @throws std::domain_error  as cell_stiffness; or the layer is not square,
  ///                            has an odd number of points or another spacing;
  ///                            or cells < 1
  SurfaceStiffness(const Crystal& crystal, const Grid& layer, int cells,
                   mechanics::AtomModes modes, int threads = 1);

  const Grid& layer() const { return fourier_.grid(); }

  mechanics::AtomModes modes() const { return modes_; }

  /// Computes forces = K u [N] and returns the energy u K u / 2 [J].
  double apply(const LayerView& displacement, const LayerForces& forces);

  /// Computes displacement = (K + contact)^-1 forces, ignoring the mean of the
  /// forces; the mean of the displacement is 0.
  /// @param contact  contact stiffness; its lateral and normal parts may be 0
  void solve(const LayerView& forces, const ContactStiffness& contact,
             const LayerForces& displacement);

  /// Returns the stiffness of a single atom that is displaced normally [N/m],
  /// which is the mean of K_zz over all wavevectors.
  double local_stiffness() const;

  /// Returns K at a wavevector of the half spectrum (column jx, row jy). With
  /// AtomModes::normal, only the entry zz is set.
  const SymmetricBlock& at(int jx, int jy) const;

private:
  void to_spectra(const LayerView& planes);
  void from_spectra(const LayerForces& planes);

  mechanics::AtomModes modes_;
  RealFourier fourier_;
  std::vector<SymmetricBlock> symbol_; ///< in the order of the half spectrum
  std::vector<std::complex<double>> x_;
  std::vector<std::complex<double>> y_;
  std::vector<std::complex<double>> z_;
};

} // namespace asperity::md
