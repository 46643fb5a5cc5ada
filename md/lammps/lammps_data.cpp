// Generates the text of the files that LAMMPS reads before the first step.
#include "md/lammps/lammps_block.hpp"
#include "md/lammps/lammps_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace asperity::md {
namespace {

/// Bonds in the free lower surface belong to half as many cells as bonds
/// inside.
enum class BondType {
  edge = 1,
  face_edge = 2,
  diagonal = 3,
  face_diagonal = 4
};

struct Bond {
  BondType type;
  std::size_t first;
  std::size_t second;
};

/// Returns the number in LAMMPS of the block's atom (ix, iy) of layer k,
/// periodic in x and y.
std::size_t number_of(const LammpsBlock& block, int ix, int iy, int k) {
  const int nx = block.layer.points_x;
  const int ny = block.layer.points_y;
  return static_cast<std::size_t>(k) * block.layer.size() +
         block.layer.index((ix + nx) % nx, (iy + ny) % ny) + 1;
}

/// Adds the bonds of one atom with its neighbours beside and above it. Bonds
/// within the uppermost layer never stretch and are omitted.
void add_bonds(const LammpsBlock& block, int ix, int iy, int k,
               std::vector<Bond>& bonds) {
  const std::size_t self = number_of(block, ix, iy, k);
  const auto add = [&](BondType type, int dx, int dy, int dk) {
    bonds.push_back({type, self, number_of(block, ix + dx, iy + dy, k + dk)});
  };
  const bool is_face = k == 0;
  const BondType edge = is_face ? BondType::face_edge : BondType::edge;
  const BondType diagonal =
      is_face ? BondType::face_diagonal : BondType::diagonal;
  add(edge, 1, 0, 0);
  add(edge, 0, 1, 0);
  add(diagonal, 1, 1, 0);
  add(diagonal, -1, 1, 0);
  add(BondType::edge, 0, 0, 1);
  add(BondType::diagonal, 1, 0, 1);
  add(BondType::diagonal, -1, 0, 1);
  add(BondType::diagonal, 0, 1, 1);
  add(BondType::diagonal, 0, -1, 1);
}

std::vector<Bond> bonds_of(const LammpsBlock& block) {
  std::vector<Bond> bonds;
  for (int k = 0; k < block.cells; ++k)
    for (int iy = 0; iy < block.layer.points_y; ++iy)
      for (int ix = 0; ix < block.layer.points_x; ++ix)
        add_bonds(block, ix, iy, k, bonds);
  return bonds;
}

AtomType type_of_layer(const LammpsBlock& block, int k) {
  if (k == 0)
    return AtomType::lowest;
  return k == block.cells ? AtomType::top : AtomType::inner;
}

/// The harmonic bond energy of LAMMPS is K (r - r_0)^2, so K is half the
/// stiffness. Equilibrium does not depend on the mass, but LAMMPS requires one.
std::string header(const LammpsBlock& block, double height,
                   std::size_t n_bonds) {
  const double half = 0.5 * block.bond_stiffness() / metal::stiffness;
  const double edge = block.crystal.spacing / metal::length;
  const double diagonal = edge * std::numbers::sqrt2;
  const auto [lowest, highest] =
      std::minmax_element(block.heights.begin(), block.heights.end());
  const double top = height + block.cells * block.crystal.spacing;
  return fmt::format(
      "A block of atoms on a rough surface, angstrom and eV\n\n"
      "{} atoms\n{} bonds\n4 atom types\n4 bond types\n\n"
      "0 {:.17g} xlo xhi\n0 {:.17g} ylo yhi\n{:.17g} {:.17g} zlo zhi\n\n"
      "Masses\n\n1 1\n2 1\n3 1\n4 1\n\n"
      "Bond Coeffs\n\n1 {:.17g} {:.17g}\n2 {:.17g} {:.17g}\n"
      "3 {:.17g} {:.17g}\n4 {:.17g} {:.17g}\n\n",
      block.atoms() + block.substrate.size(), n_bonds,
      block.layer.length_x / metal::length,
      block.layer.length_y / metal::length,
      std::min(*lowest, height) / metal::length - 1.0,
      std::max(*highest, top) / metal::length + 1.0, half, edge, 0.5 * half,
      edge, half, diagonal, 0.5 * half, diagonal);
}

} // namespace

std::string data_file(const LammpsBlock& block, double height) {
  const std::vector<Bond> bonds = bonds_of(block);
  std::string text = header(block, height, bonds.size());
  text += "Atoms # bond\n\n";
  const auto add_atom = [&](std::size_t number, AtomType type, double x,
                            double y, double z) {
    text +=
        fmt::format("{} {} {} {:.17g} {:.17g} {:.17g}\n", number,
                    type == AtomType::substrate ? 0 : 1, static_cast<int>(type),
                    x / metal::length, y / metal::length, z / metal::length);
  };
  const BlockVectors positions = undeformed(block, height);
  for (std::size_t atom = 0; atom < positions.size(); ++atom) {
    const int k = static_cast<int>(atom / block.layer.size());
    const auto& [x, y, z] = positions[atom];
    add_atom(atom + 1, type_of_layer(block, k), x, y, z);
  }
  for (int iy = 0; iy < block.substrate.points_y; ++iy)
    for (int ix = 0; ix < block.substrate.points_x; ++ix) {
      const std::size_t node = block.substrate.index(ix, iy);
      add_atom(block.atoms() + node + 1, AtomType::substrate,
               ix * block.substrate.spacing_x(),
               iy * block.substrate.spacing_y(), block.heights[node]);
    }
  text += "\nBonds\n\n";
  for (std::size_t i = 0; i < bonds.size(); ++i)
    text += fmt::format("{} {} {} {}\n", i + 1, static_cast<int>(bonds[i].type),
                        bonds[i].first, bonds[i].second);
  return text;
}

std::string pair_table(const Interaction& interaction) {
  const double inner = 0.3 * interaction.distance;
  const double inner_square = inner * inner;
  const double step = (interaction.cutoff * interaction.cutoff - inner_square) /
                      (table_points - 1);
  std::string text =
      fmt::format("# r [angstrom], energy [eV], force [eV/angstrom]\n\n"
                  "{}\nN {} RSQ {:.17g} {:.17g}\n\n",
                  table_section, table_points, inner / metal::length,
                  interaction.cutoff / metal::length);
  for (int i = 0; i < table_points; ++i) {
    const double distance = std::sqrt(inner_square + i * step);
    const PairTerm term = pair_term(interaction, distance);
    text += fmt::format("{} {:.17g} {:.17g} {:.17g}\n", i + 1,
                        distance / metal::length, term.energy / metal::energy,
                        term.force_over_distance * distance / metal::force);
  }
  return text;
}

std::string positions_file(const LammpsBlock& block,
                           const BlockVectors& positions) {
  const double length = block.layer.length_x / metal::length;
  std::string text =
      fmt::format("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{0}\n"
                  "ITEM: BOX BOUNDS pp pp ss\n0 {1:.17g}\n0 {1:.17g}\n0 1\n"
                  "ITEM: ATOMS id x y z\n",
                  positions.size(), length);
  for (std::size_t atom = 0; atom < positions.size(); ++atom) {
    const auto& [x, y, z] = positions[atom];
    text +=
        fmt::format("{} {:.17g} {:.17g} {:.17g}\n", atom + 1, x / metal::length,
                    y / metal::length, z / metal::length);
  }
  return text;
}

} // namespace asperity::md
