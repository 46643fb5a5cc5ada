#include "fem/multigrid/rigid_modes.hpp"

#include "fem/multigrid/box_grid_levels.hpp"

#include <array>
#include <stdexcept>

namespace asperity::fem {
namespace {

enum class RigidMotion { shift_x, shift_y, shift_z, turn };

std::array<double, 3> velocity(RigidMotion motion, double x, double y) {
  switch (motion) {
  case RigidMotion::shift_x:
    return {1.0, 0.0, 0.0};
  case RigidMotion::shift_y:
    return {0.0, 1.0, 0.0};
  case RigidMotion::shift_z:
    return {0.0, 0.0, 1.0};
  case RigidMotion::turn:
    break;
  }
  return {-y, x, 0.0};
}

} // namespace

std::vector<std::vector<double>> rigid_modes(const BoxGrid& box_grid,
                                             const BoxGridSlab& slab,
                                             bool has_contact) {
  if (!box_grid.is_periodic && !box_grid.holds_normal)
    throw std::domain_error("a block with free sides whose far boundary does "
                            "not hold u_z can tilt");
  std::vector<RigidMotion> motions;
  if (!box_grid.holds_lateral)
    motions = {RigidMotion::shift_x, RigidMotion::shift_y};
  if (!box_grid.holds_lateral && !box_grid.is_periodic)
    motions.push_back(RigidMotion::turn);
  if (!box_grid.holds_normal && !has_contact)
    motions.push_back(RigidMotion::shift_z);
  const auto axes = axes_of(box_grid);
  const NodeLayout layout = slab.layout(box_grid);
  const std::size_t first = static_cast<std::size_t>(box_grid.degree) *
                            static_cast<std::size_t>(slab.first());
  std::vector<std::vector<double>> modes;
  for (const RigidMotion motion : motions) {
    std::vector<double>& mode = modes.emplace_back(layout.size(), 0.0);
    for (int k = 0; k < static_cast<int>(layout.planes()); ++k)
      for (int j = 0; j < layout.nodes_y(); ++j)
        for (int i = 0; i < layout.nodes_x(); ++i) {
          const double x =
              axes[0].node(static_cast<std::size_t>(i)) / box_grid.length_x -
              0.5;
          const double y = (axes[1].node(first + static_cast<std::size_t>(j)) -
                            0.5 * box_grid.length_y) /
                           box_grid.length_x;
          const auto own = velocity(motion, x, y);
          for (int c = 0; c < 3; ++c)
            mode[layout.index(i, j, k, c)] = own[static_cast<std::size_t>(c)];
        }
  }
  return modes;
}

} // namespace asperity::fem
