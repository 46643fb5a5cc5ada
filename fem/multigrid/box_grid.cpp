#include "fem/multigrid/box_grid.hpp"

#include "base/require.hpp"

#include <algorithm>

namespace asperity::fem {

const CellModuli& BoxGrid::moduli_of(int x, int y, int layer) const {
  if (is_layered())
    return moduli[static_cast<std::size_t>(layer)];
  const auto row =
      static_cast<std::size_t>(layer) * static_cast<std::size_t>(cells_y) +
      static_cast<std::size_t>(y);
  return moduli[row * static_cast<std::size_t>(cells_x) +
                static_cast<std::size_t>(x)];
}

void require_box_grid(const BoxGrid& box_grid) {
  require_between("degree", box_grid.degree, 1.0, 2.0, "1");
  require_between("cells_x", box_grid.cells_x, 1.0, 1e6, "1");
  require_between("cells_y", box_grid.cells_y, 1.0, 1e6, "1");
  require_positive("length_x", box_grid.length_x, "m");
  require_positive("length_y", box_grid.length_y, "m");
  require_between("number of layers", box_grid.layers(), 1.0, 1e6, "1");
  for (const double thickness : box_grid.thickness)
    require_positive("thickness", thickness, "m");
  const std::size_t cells = box_grid.thickness.size() *
                            static_cast<std::size_t>(box_grid.cells_x) *
                            static_cast<std::size_t>(box_grid.cells_y);
  if (!box_grid.is_layered() && box_grid.moduli.size() != cells)
    refuse_argument("number of moduli",
                    static_cast<double>(box_grid.moduli.size()),
                    "that of the layers or of the cells");
  for (const CellModuli& moduli : box_grid.moduli) {
    require_positive("shear modulus", moduli.shear, "Pa");
    require_positive("lambda + 2 mu / 3", moduli.lame + 2.0 / 3 * moduli.shear,
                     "Pa");
  }
}

MeshUnits units_of(const BoxGrid& box_grid) {
  MeshUnits units{std::min(box_grid.width_x(), box_grid.width_y()), 0.0};
  for (const double thickness : box_grid.thickness)
    units.length = std::min(units.length, thickness);
  for (const CellModuli& moduli : box_grid.moduli)
    units.modulus = std::max(units.modulus, moduli.shear);
  return units;
}

BoxGrid scaled(const BoxGrid& box_grid, const MeshUnits& units) {
  BoxGrid result = box_grid;
  result.length_x /= units.length;
  result.length_y /= units.length;
  for (double& thickness : result.thickness)
    thickness /= units.length;
  for (CellModuli& moduli : result.moduli)
    moduli = {moduli.lame / units.modulus, moduli.shear / units.modulus};
  return result;
}

NodeLayout::NodeLayout(const BoxGrid& box_grid)
    : NodeLayout(box_grid, box_grid.cells_y, box_grid.is_periodic) {}

NodeLayout::NodeLayout(const BoxGrid& box_grid, int cells_y,
                       bool has_image_slice)
    : degree_(at(box_grid.degree)),
      stride_(at(box_grid.cells_x) + 1),
      slices_(degree_ * at(cells_y) + 1),
      planes_(degree_ * at(box_grid.layers()) + 1),
      has_image_column_(box_grid.is_periodic),
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
