// Tests of md/lammps/lammps_block.hpp: the input of LAMMPS is the central
// crystal of md/lattice/crystal.hpp and the pair law of
// md/interface/interaction.hpp. The bonds are read back from the text of the
// data file, as LAMMPS does.
#include "input/input_error.hpp"
#include "md/lammps/lammps_block.hpp"
#include "md/lammps/lammps_units.hpp"
#include "tests/md/lammps_requests.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <sstream>

namespace asperity::md::lammps_block_test {

constexpr int points = 8;
constexpr int cells = 3;

LammpsBlock small_block() {
  return lammps_block(problems::small_request(points, cells, 0.05));
}

struct BondType {
  double energy_factor = 0.0; // K of K (r - r_0)^2 [eV/angstrom^2]
  double rest_length = 0.0;   // [angstrom]
};

struct Bond {
  int type = 0;
  std::size_t first = 0;
  std::size_t second = 0;
};

struct DataFile {
  std::map<int, BondType> types;
  std::vector<Bond> bonds;
  BlockVectors positions; // [angstrom]
  std::vector<int> atom_types;
};

DataFile read(const std::string& text) {
  DataFile data;
  std::istringstream lines(text);
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty())
      continue;
    std::istringstream words(line);
    int number = 0;
    if (std::isalpha(static_cast<unsigned char>(line[0]))) {
      section = line;
    } else if (section == "Bond Coeffs") {
      words >> number;
      words >> data.types[number].energy_factor >>
          data.types[number].rest_length;
    } else if (section == "Atoms # bond") {
      int molecule = 0;
      int type = 0;
      std::array<double, 3> position{};
      words >> number >> molecule >> type >> position[0] >> position[1] >>
          position[2];
      data.atom_types.push_back(type);
      data.positions.push_back(position);
    } else if (section == "Bonds") {
      Bond bond;
      words >> number >> bond.type >> bond.first >> bond.second;
      data.bonds.push_back(bond);
    }
  }
  return data;
}

/// (1/2) K' (elongation)^2 summed over the bonds, linear in the displacements
/// u [m] of the atoms [J].
double bond_energy(const DataFile& data, const LammpsBlock& block,
                   const BlockVectors& displacements) {
  double sum = 0.0;
  for (const Bond& bond : data.bonds) {
    const BondType& type = data.types.at(bond.type);
    double elongation = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double apart = data.positions[bond.second - 1][axis] -
                     data.positions[bond.first - 1][axis];
      if (axis < 2)
        apart = std::remainder(apart, block.layer.length_x / metal::length);
      elongation += apart / type.rest_length *
                    (displacements[bond.second - 1][axis] -
                     displacements[bond.first - 1][axis]);
    }
    sum += type.energy_factor * metal::stiffness * elongation * elongation;
  }
  return sum;
}

/// The same from the stiffness of a cell, cell by cell.
double cell_energy(const LammpsBlock& block,
                   const BlockVectors& displacements) {
  const CellStiffness stiffness = cell_stiffness(block.crystal);
  double sum = 0.0;
  for (int k = 0; k < cells; ++k)
    for (int iy = 0; iy < points; ++iy)
      for (int ix = 0; ix < points; ++ix) {
        std::array<double, 24> u{};
        for (std::size_t c = 0; c < 8; ++c) {
          const int x = (ix + static_cast<int>(c & 1)) % points;
          const int y = (iy + static_cast<int>((c >> 1) & 1)) % points;
          const std::size_t layer = static_cast<std::size_t>(k) + (c >> 2);
          const std::size_t atom =
              layer * block.layer.size() + block.layer.index(x, y);
          for (std::size_t axis = 0; axis < 3; ++axis)
            u[3 * c + axis] = displacements[atom][axis];
        }
        for (std::size_t i = 0; i < 24; ++i)
          for (std::size_t j = 0; j < 24; ++j)
            sum += 0.5 * u[i] * stiffness[24 * i + j] * u[j];
      }
  return sum;
}

// Tolerance: some 10^4 terms of 1e-16 of the sum, added one after the other.
TEST(LammpsBlockData, BondsStoreTheEnergyOfTheCells) {
  const LammpsBlock block = small_block();
  const DataFile data = read(data_file(block, 10e-10));
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> number(-1e-11, 1e-11);
  BlockVectors displacements(block.atoms());
  for (std::size_t atom = 0; atom < block.atoms() - block.layer.size(); ++atom)
    for (double& component : displacements[atom])
      component = number(generator);

  const double bonds = bond_energy(data, block, displacements);
  const double from_cells = cell_energy(block, displacements);

  EXPECT_NEAR(bonds / from_cells, 1.0, 1e-12);
}

// Tolerance: printed with 17 digits.
TEST(LammpsBlockData, AtomsAreTheCrystalAndTheSurface) {
  const AtomRequest request = problems::small_request(points, cells, 0.05);
  const LammpsBlock block = lammps_block(request);

  const DataFile data = read(data_file(block, 10e-10));

  ASSERT_EQ(data.positions.size(), block.atoms() + request.heights.size());
  const BlockVectors sites = undeformed(block, 10e-10);
  for (std::size_t atom = 0; atom < block.atoms(); ++atom) {
    const std::size_t k = atom / block.layer.size();
    EXPECT_EQ(data.atom_types[atom], k == 0 ? 1 : k == cells ? 3 : 2);
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(data.positions[atom][axis] * metal::length, sites[atom][axis],
                  1e-24);
  }
  for (std::size_t node = 0; node < request.heights.size(); ++node) {
    EXPECT_EQ(data.atom_types[block.atoms() + node], 4);
    EXPECT_NEAR(data.positions[block.atoms() + node][2] * metal::length,
                request.heights[node], 1e-24);
  }
}

// Between the points of the table, too, the force is that of pair_term().
// Tolerance: a linear interpolation in r^2 has in the middle of a step d the
// error d^2/8 times the second derivative of (r^2)^-7, relative 7 d^2/r^4.
TEST(LammpsBlockTable, InterpolatedInTheSquareIsThePairLaw) {
  const Interaction interaction = small_block().interaction;
  std::istringstream text(pair_table(interaction));
  std::string word;
  while (text >> word && word != "RSQ") {
  }
  double inner = 0.0;
  double outer = 0.0;
  text >> inner >> outer;
  std::vector<std::array<double, 2>> table; // r^2, force over r
  double number = 0.0;
  double distance = 0.0;
  double energy = 0.0;
  double force = 0.0;
  while (text >> number >> distance >> energy >> force)
    table.push_back({distance * distance, force / distance});

  ASSERT_EQ(table.size(), static_cast<std::size_t>(table_points));
  EXPECT_DOUBLE_EQ(outer * metal::length, interaction.cutoff);
  const double step = (outer * outer - inner * inner) / (table_points - 1);
  for (std::size_t i = 0; i + 1 < table.size(); i += 37) {
    const double square = 0.5 * (table[i][0] + table[i + 1][0]);
    if (square > 0.64 * outer * outer)
      break; // from here on the taper adds its own curvature
    const double middle = 0.5 * (table[i][1] + table[i + 1][1]);
    const double expected =
        pair_term(interaction, std::sqrt(square) * metal::length)
            .force_over_distance /
        metal::stiffness;
    EXPECT_NEAR(middle / expected, 1.0, 7.5 * step * step / (square * square));
  }
}

/// The refusal of a request after a change.
template <class Spoil>
std::string refusal(const Spoil& spoil) {
  AtomRequest request = problems::small_request(points, cells, 0.05);
  spoil(request);
  return tests::message_of<std::exception>([&] { lammps_block(request); });
}

TEST(LammpsBlockRefusals, NameWhatLammpsCannotDo) {
  const auto expect = [](const std::string& message, const char* words) {
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  expect(refusal([](AtomRequest& r) {
           r.settings.lattice = mechanics::AtomLattice::isotropic;
         }),
         "[md] engine = \"lammps\" needs lattice = \"central\"");
  expect(refusal([](AtomRequest& r) { r.poisson_ratio = 0.42; }),
         "poisson_ratio = 0.25");
  expect(refusal([](AtomRequest& r) {
           r.settings.modes = mechanics::AtomModes::normal;
         }),
         "modes = \"normal\"");
  expect(refusal([](AtomRequest& r) {
           r.settings.bulk = mechanics::AtomBulk::explicit_layers;
         }),
         "bulk = \"explicit\"");
  expect(refusal([](AtomRequest& r) {
           r.settings.minimizer = mechanics::AtomMinimizer::dynamics;
         }),
         "minimizer = \"dynamics\"");
  expect(refusal([](AtomRequest& r) { r.heights.pop_back(); }), "heights = ");
}

} // namespace asperity::md::lammps_block_test
