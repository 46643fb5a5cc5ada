#include "md/contact/dump.hpp"
#include "tests/md/rough_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

namespace asperity::md::dump_test {

using problems::angstrom;
using problems::RoughContact;

struct Atom {
  std::string species;
  double x = 0.0, y = 0.0, z = 0.0; // angstrom
  double pressure = 0.0;            // GPa
};

struct Picture {
  std::string head;
  std::vector<Atom> atoms;
};

/// Reads extended XYZ as any other program would.
Picture read(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  Picture picture;
  picture.atoms.resize(std::stoul(line));
  std::getline(file, picture.head);
  for (Atom& atom : picture.atoms) {
    std::getline(file, line);
    std::istringstream(line) >> atom.species >> atom.x >> atom.y >> atom.z >>
        atom.pressure;
  }
  EXPECT_TRUE(file.good());
  EXPECT_EQ(file.peek(), std::ifstream::traits_type::eof());
  return picture;
}

class Dump : public ::testing::Test {
protected:
  ~Dump() override { std::filesystem::remove(path); }

  std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      ("asperity-dump-" + std::to_string(::getpid()) + ".xyz");
};

// Verifies that every atom is in the file, at its position and with its
// pressure. Tolerance: six printed decimals.
TEST_F(Dump, HoldsEveryAtomOfAnExplicitBlock) {
  RoughContact problem{16, 2, 2};
  const ExplicitSystem system = problem.system();
  std::vector<double> state = system.undeformed(5.0 * angstrom);
  for (std::size_t i = 0; i < state.size(); ++i)
    state[i] += 1e-12 * std::sin(static_cast<double>(i));
  const std::vector<double> pressures =
      problems::random_numbers(system.layer().size(), 0.0, 1e9, 5);

  std::vector<AtomGroup> groups{
      substrate_atoms(problem.substrate(), problem.heights()),
      contact_atoms(system, state, pressures)};
  for (AtomGroup& group : inner_atoms(system.block(), state))
    groups.push_back(std::move(group));
  write_atoms(path, system.layer(), groups);

  const Picture picture = read(path);
  EXPECT_TRUE(
      picture.head.starts_with("Lattice=\"41.600000 0 0 0 41.600000 0 0 0 "))
      << picture.head;
  EXPECT_NE(picture.head.find("Properties=species:S:1:pos:R:3:pressure:R:1 "
                              "pbc=\"T T F\""),
            std::string::npos);
  std::map<std::string, int> counts;
  for (const Atom& atom : picture.atoms)
    ++counts[atom.species];
  EXPECT_EQ(counts, (std::map<std::string, int>{
                        {"S", 26 * 26}, {"B", 256}, {"B0", 256}, {"B1", 128}}));

  const double printed = 0.5001e-6;
  const std::vector<double> heights = problem.heights();
  EXPECT_NEAR(picture.atoms[30].x, 4 * 41.6 / 26, printed);
  EXPECT_NEAR(picture.atoms[30].y, 41.6 / 26, printed);
  EXPECT_NEAR(picture.atoms[30].z, heights[30] * 1e10, printed);
  const Atom& contact = picture.atoms[26 * 26 + 35];
  EXPECT_NEAR(contact.x, 3 * 2.6 + 1e10 * state[35], printed);
  EXPECT_NEAR(contact.y, 2 * 2.6 + 1e10 * state[256 + 35], printed);
  EXPECT_NEAR(contact.z, 1e10 * state[512 + 35], printed);
  EXPECT_NEAR(contact.pressure, 1e-9 * pressures[35], printed);
  const Atom& coarse = picture.atoms.back(); // (7, 7) of the last layer
  const std::size_t last = system.block().begin_of(1, 1) + 63;
  EXPECT_NEAR(coarse.x, 7 * 5.2 + 1e10 * state[last], printed);
  EXPECT_NEAR(coarse.z, 4 * 2.6 + 1e10 * state[last + 128], printed);
  EXPECT_EQ(coarse.pressure, 0.0);
}

TEST_F(Dump, RefusesPressuresThatDoNotFit) {
  const std::vector<AtomGroup> groups{{"B", {{0.0, 0.0, 0.0}}, {1.0, 2.0}}};

  EXPECT_THROW(write_atoms(path, {1, 1, 1e-9, 1e-9}, groups),
               std::domain_error);
  EXPECT_FALSE(std::filesystem::exists(path));
}

} // namespace asperity::md::dump_test
