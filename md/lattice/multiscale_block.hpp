#pragma once

// The explicit block, which consists of layers of cells whose spacing doubles
// from level to level. The class defines the order of the atoms and computes
// their masses, energy and forces.

#include "base/grid.hpp"
#include "md/lattice/crystal.hpp"
#include "md/lattice/slab_coupling.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace asperity::md {

/// Shape of an explicit block.
struct BlockShape {
  Grid layer;     ///< grid of the lowest layer of atoms; its cells are squares
                  ///< of the crystal's spacing
  int levels = 1; ///< number of levels, >= 1
  int layers = 6; ///< layers of cells per level, >= 1
};

/// A block of atoms that is coarsened away from the contact.
///
/// Level l = 0..levels-1 consists of `layers` layers of cells of spacing 2^l a
/// on a grid of N / 2^l atoms per side. The stiffness of a cell scales with
/// 2^l, which preserves the elastic moduli, and the mass of its atoms with 8^l,
/// which preserves the density. Bonds and masses in a boundary plane of a level
/// count half. The layer of atoms between two levels belongs to the coarse
/// level: the fine atoms in this plane that do not coincide with coarse atoms
/// are hanging nodes, whose displacements are interpolated bilinearly and whose
/// forces are distributed to the coarse atoms with the same weights. The far
/// boundary is a rigid plate that moves only in z. The scheme follows Yang,
/// Tartaglino and Persson, Eur. Phys. J. E 19, 47 (2006).
///
/// The state vector contains the planes x, y, z of each free layer of atoms
/// from the lowest layer upwards, level after level, each in the storage order
/// of its own grid, and finally the height of the plate. The values x and y are
/// displacements; z is the height minus the height of the layer above the
/// lowest one in the block at rest, so that z has the same value everywhere in
/// the block at rest [m].
class MultiscaleBlock {
public:
  /// @throws std::domain_error  levels or layers < 1, a side of the layer is
  ///                            not divisible by 2^(levels-1), the spacings of
  ///                            the layer differ from that of the crystal, or
  ///                            the crystal is invalid
  MultiscaleBlock(const Crystal& crystal, const BlockShape& shape,
                  int threads = 1);

  const BlockShape& shape() const { return shape_; }

  Grid level_grid(int level) const;

  std::size_t size() const { return size_; } ///< number of unknowns

  std::size_t plate() const { return size_ - 1; } ///< index of the plate's z

  /// Returns the index of the first unknown of a layer 0..layers-1 of a level.
  std::size_t begin_of(int level, int layer) const;

  /// Returns the height of that layer above the lowest one in the block at rest
  /// [m].
  double height_of(int level, int layer) const;

  double depth() const { return height_of(shape_.levels, 0); } ///< [m]

  /// Returns the couplings of one layer of cells of a level.
  const SlabCouplings& couplings(int level) const {
    return couplings_[static_cast<std::size_t>(level)];
  }

  /// Overwrites `forces` with the negative gradient of the energy.
  /// @return  elastic energy [J], 0 at rest
  /// @par Accuracy  Roundoff only. The result is bitwise identical for any
  ///                number of threads.
  double energy_and_forces(std::span<const double> state,
                           std::span<double> forces) const;

  /// Returns the elastic energy without the contribution of the mean
  /// displacement of each layer, and hence without uniform compression [J].
  double energy_of_waves(std::span<const double> state) const;

  /// Returns the mass of each unknown [kg]; `atom_mass` is the mass of an atom
  /// in the interior of level 0 [kg].
  std::vector<double> masses(double atom_mass) const;

private:
  /// Returns the three planes of one layer, of a state or of forces.
  template <class Number>
  AtomPlane<Number> plane_of(std::span<Number> unknowns, int level,
                             int layer) const;

  /// Displacements and forces of the fine plane of atoms between two levels.
  /// There is one instance for each level except the last.
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
  double plate_stiffness_ = 0.0; ///< of the last cell layer, per atom [N/m]

  std::vector<SlabCouplings> couplings_; ///< one entry per level

  struct RowJob {
    int level = 0;
    int layer = 0; ///< the value `layers` denotes the plane of hanging nodes
    int row = 0;
  };

  std::vector<RowJob> rows_;
};

} // namespace asperity::md
