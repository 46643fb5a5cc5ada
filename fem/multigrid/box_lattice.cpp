#include "fem/multigrid/box_lattice.hpp"

#include "base/require.hpp"

#include <algorithm>

namespace asperity::fem {

const CellModuli& BoxLattice::moduli_of(int x, int y, int layer) const {
  if (is_layered())
    return moduli[static_cast<std::size_t>(layer)];
  const auto row =
      static_cast<std::size_t>(layer) * static_cast<std::size_t>(cells_y) +
      static_cast<std::size_t>(y);
  return moduli[row * static_cast<std::size_t>(cells_x) +
                static_cast<std::size_t>(x)];
}

void require_lattice(const BoxLattice& lattice) {
  require_between("degree", lattice.degree, 1.0, 2.0, "1");
  require_between("cells_x", lattice.cells_x, 1.0, 1e6, "1");
  require_between("cells_y", lattice.cells_y, 1.0, 1e6, "1");
  require_positive("length_x", lattice.length_x, "m");
  require_positive("length_y", lattice.length_y, "m");
  require_between("number of layers", lattice.layers(), 1.0, 1e6, "1");
  for (const double thickness : lattice.thickness)
    require_positive("thickness", thickness, "m");
  const std::size_t cells = lattice.thickness.size() *
                            static_cast<std::size_t>(lattice.cells_x) *
                            static_cast<std::size_t>(lattice.cells_y);
  if (!lattice.is_layered() && lattice.moduli.size() != cells)
    refuse_argument("number of moduli",
                    static_cast<double>(lattice.moduli.size()),
                    "that of the layers or of the cells");
  for (const CellModuli& moduli : lattice.moduli) {
    require_positive("shear modulus", moduli.shear, "Pa");
    require_positive("lambda + 2 mu / 3", moduli.lame + 2.0 / 3 * moduli.shear,
                     "Pa");
  }
}

MeshUnits units_of(const BoxLattice& lattice) {
  MeshUnits units{std::min(lattice.width_x(), lattice.width_y()), 0.0};
  for (const double thickness : lattice.thickness)
    units.length = std::min(units.length, thickness);
  for (const CellModuli& moduli : lattice.moduli)
    units.modulus = std::max(units.modulus, moduli.shear);
  return units;
}

BoxLattice scaled(const BoxLattice& lattice, const MeshUnits& units) {
  BoxLattice result = lattice;
  result.length_x /= units.length;
  result.length_y /= units.length;
  for (double& thickness : result.thickness)
    thickness /= units.length;
  for (CellModuli& moduli : result.moduli)
    moduli = {moduli.lame / units.modulus, moduli.shear / units.modulus};
  return result;
}

NodeLayout::NodeLayout(const BoxLattice& lattice)
    : NodeLayout(lattice, lattice.cells_y, lattice.is_periodic) {}

NodeLayout::NodeLayout(const BoxLattice& lattice, int cells_y,
                       bool has_image_slice)
    : degree_(at(lattice.degree)),
      stride_(at(lattice.cells_x) + 1),
      slices_(degree_ * at(cells_y) + 1),
      planes_(degree_ * at(lattice.layers()) + 1),
      has_image_column_(lattice.is_periodic),
      has_image_slice_(has_image_slice) {}

NodeLayout::Node NodeLayout::node(std::size_t index) const {
  const std::size_t line = index / stride_;
  const std::size_t x = index % stride_ * degree_ + line % degree_;
  const std::size_t row = line / degree_ / 3;
  return {static_cast<int>(x), static_cast<int>(row / planes_),
          static_cast<int>(row % planes_),
          static_cast<int>(line / degree_ % 3)};
}

int NodeLayout::nodes_x() const {
  return static_cast<int>(degree_ * (stride_ - 1)) +
         (has_image_column_ ? 0 : 1);
}

int NodeLayout::nodes_y() const {
  return static_cast<int>(slices_) - (has_image_slice_ ? 1 : 0);
}

} // namespace asperity::fem
