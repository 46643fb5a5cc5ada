#include "md/contact/dump.hpp"

#include "base/atomic_file.hpp"
#include "base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

namespace asperity::md {
namespace {

constexpr double in_angstrom = 1e10;
constexpr double in_gigapascal = 1e-9;

/// Adds the atoms of a grid, at their sites plus displacements; z is relative
/// to the plane at `height`.
void add_layer(const Grid& grid, const LayerView& atoms, double height,
               AtomGroup& group) {
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix) {
      const std::size_t i = grid.index(ix, iy);
      group.positions.push_back({ix * grid.spacing_x() + atoms.x[i],
                                 iy * grid.spacing_y() + atoms.y[i],
                                 height + atoms.z[i]});
    }
}

} // namespace

AtomGroup substrate_atoms(const Grid& substrate,
                          std::span<const double> heights) {
  AtomGroup group{"S", {}, {}};
  const std::vector<double> none(substrate.size(), 0.0);
  add_layer(substrate, {none, none, heights}, 0.0, group);
  return group;
}

AtomGroup contact_atoms(const System& system, std::span<const double> state,
                        std::span<const double> pressures) {
  AtomGroup group{"B", {}, {pressures.begin(), pressures.end()}};
  add_layer(system.layer(), layer_of(system, state), 0.0, group);
  return group;
}

std::vector<AtomGroup> inner_atoms(const MultiscaleBlock& block,
                                   std::span<const double> state) {
  std::vector<AtomGroup> groups;
  for (int level = 0; level < block.shape().levels; ++level) {
    AtomGroup& group = groups.emplace_back();
    group.species = fmt::format("B{}", level);
    const Grid grid = block.level_grid(level);
    const std::size_t n = grid.size();
    for (int layer = level == 0 ? 1 : 0; layer < block.shape().layers;
         ++layer) {
      const auto planes = state.subspan(block.begin_of(level, layer), 3 * n);
      add_layer(grid,
                {planes.subspan(0, n), planes.subspan(n, n),
                 planes.subspan(2 * n, n)},
                block.height_of(level, layer), group);
    }
  }
  return groups;
}

void write_atoms(const std::filesystem::path& path, const Grid& cell,
                 std::span<const AtomGroup> groups) {
  std::size_t n_atoms = 0;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const AtomGroup& group : groups) {
    n_atoms += group.positions.size();
    if (!group.pressures.empty() &&
        group.pressures.size() != group.positions.size())
      refuse_argument("number of pressures",
                      static_cast<double>(group.pressures.size()),
                      "0 or the number of atoms");
    for (const auto& position : group.positions) {
      lowest = std::min(lowest, position[2]);
      highest = std::max(highest, position[2]);
    }
  }

  std::string text = fmt::format(
      "{}\nLattice=\"{:.6f} 0 0 0 {:.6f} 0 0 0 {:.6f}\" Origin=\"0 0 {:.6f}\" "
      "Properties=species:S:1:pos:R:3:pressure:R:1 pbc=\"T T F\" "
      "units=\"angstrom, GPa\"\n",
      n_atoms, cell.length_x * in_angstrom, cell.length_y * in_angstrom,
      (highest - lowest) * in_angstrom, lowest * in_angstrom);
  for (const AtomGroup& group : groups)
    for (std::size_t i = 0; i < group.positions.size(); ++i) {
      const auto& [x, y, z] = group.positions[i];
      const double pressure =
          group.pressures.empty() ? 0.0 : group.pressures[i];
      text += fmt::format("{} {:.6f} {:.6f} {:.6f} {:.6f}\n", group.species,
                          x * in_angstrom, y * in_angstrom, z * in_angstrom,
                          pressure * in_gigapascal);
    }
  std::filesystem::create_directories(path.parent_path());
  write_file_atomically(path, text);
}

} // namespace asperity::md
