#pragma once

// The explicit block: layers of cells whose spacing doubles from level to
// level. Owns the order of its atoms, their masses, energy and forces.

#include "base/grid.hpp"
#include "md/lattice/crystal.hpp"
#include "md/lattice/slab_coupling.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace asperity::md {

/// How an explicit block is divided.
struct BlockShape {
  Grid layer;     ///< of the lowest layer of atoms, square cells of the
                  ///< crystal's spacing
  int levels = 1; ///< >= 1
  int layers = 6; ///< of cells a level, >= 1
};

/// Level l = 0..levels-1 is `layers` layers of cells of spacing 2^l a on a grid
/// of N / 2^l atoms a side. A cell's stiffness scales by 2^l, which keeps the
/// moduli, and the mass of its atoms by 8^l, which keeps the density; bonds and
/// mass in a face count half. The layer of atoms between two levels is the
/// coarse one's: the fine atoms there that have no coarse one in their place
/// hang on the coarse ones bilinearly, and the forces on them go to the coarse
/// ones in the same shares. The top is a rigid plate that moves in z alone.
/// After Yang, Tartaglino, Persson, Eur. Phys. J. E 19, 47 (2006).
///
/// The state: planes x, y, z of each free layer of atoms from the lowest up,
/// level after level, each in its own grid's storage order; last the plate. x
/// and y are displacements, z is height less the layer's own height in the
/// block at rest, so the block at rest has one number for all z [m].
class MultiscaleBlock {
public:
  /// @throws std::domain_error  levels or layers < 1, a side of the layer that
  ///                            2^(levels-1) does not divide, spacings of the
  ///                            layer other than the crystal's, a bad crystal
  MultiscaleBlock(const Crystal& crystal, const BlockShape& shape,
                  int threads = 1);

  const BlockShape& shape() const { return shape_; }

  Grid level_grid(int level) const;

  std::size_t size() const { return size_; } ///< unknowns

  std::size_t plate() const { return size_ - 1; } ///< index of the plate's z

  /// Index of the first unknown of layer 0..layers-1 of a level.
  std::size_t begin_of(int level, int layer) const;

  /// Height of that layer over the lowest in the block at rest [m].
  double height_of(int level, int layer) const;

  double depth() const { return height_of(shape_.levels, 0); } ///< [m]

  /// Of one layer of cells of a level.
  const SlabCouplings& couplings(int level) const {
    return couplings_[static_cast<std::size_t>(level)];
  }

  /// Overwrites `forces` with minus the energy's gradient.
  /// @return  elastic energy [J], 0 at rest
  /// @par Accuracy  rounding; the same bits for any number of threads
  double energy_and_forces(std::span<const double> state,
                           std::span<double> forces) const;

  /// Elastic energy without that of the layers' mean displacements, the
  /// uniform compression among them [J].
  double energy_of_waves(std::span<const double> state) const;

  /// Mass of each unknown, `atom_mass` that of an atom inside level 0 [kg].
  std::vector<double> masses(double atom_mass) const;

private:
  /// Three planes of a state or of forces.
  template <class Number>
  AtomPlane<Number> plane_of(std::span<Number> unknowns, int level,
                             int layer) const;

  /// The fine atoms between two levels, displacements and forces, a level
  /// below the last.
  struct Hanging {
    std::vector<double> displacements;
    std::vector<double> forces;
  };

  std::vector<Hanging> hanging_layers(std::span<const double> state) const;
  AtomPlane<const double> hanging_plane(const Hanging& hanging,
                                        int level) const;
  void compute_row(std::span<const double> state, std::vector<Hanging>& hanging,
                   std::size_t job, std::span<double> forces) const;
  void add_plate(std::span<const double> state, std::span<double> forces) const;

  BlockShape shape_;
  int threads_ = 1;
  std::size_t size_ = 0;
  double plate_stiffness_ = 0.0; ///< of the last cell layer, an atom [N/m]

  std::vector<SlabCouplings> couplings_; ///< a level

  struct RowJob {
    int level = 0;
    int layer = 0; ///< layers of a level for the atoms that hang
    int row = 0;
  };

  std::vector<RowJob> rows_;
};

} // namespace asperity::md
