// Tests of [md] and of the magnification of a method: what is read, and the
// messages about invalid values.
#include "base/physical_constants.hpp"
#include "input/reader/vocabulary.hpp"
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>

namespace asperity::cases::md_case_test {

const std::string atoms_case = R"(schema = 1
[surface]
kind = "self-affine"
length = "104 nm"
points = 648
seed = 7
rms_height = "1 nm"
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.3333333333333333 length"
wavelength_short = "0.08333333333333333 length"
[material]
youngs_modulus = "77.2 GPa"
poisson_ratio = 0.42
[load]
nominal_pressure = "0.0129 E*"
[md]
atoms = 400
interaction_energy = "74.4 meV"
interaction_distance = "3.28 angstrom"
cutoff = "10 angstrom"
contact_distance = "4.3615 angstrom"
)";

std::string mistakes_in(const std::vector<std::string>& overrides) {
  return mistakes_of(atoms_case, overrides);
}

mechanics::MdSettings
read_settings(const std::vector<std::string>& overrides = {}) {
  const Case read = read_case_text(atoms_case, "case.toml", overrides);
  return std::get<mechanics::MdSettings>(read.methods.at(0).settings);
}

// Tolerance: two roundings of a conversion, one of the constant.
TEST(MdCase, IsReadInSi) {
  const mechanics::MdSettings md = read_settings(
      {"md.mass=197 u", "md.damping=2 1/ps", "md.time_step=10 fs"});

  EXPECT_EQ(md.atoms, 400);
  EXPECT_EQ(md.substrate_atoms, std::nullopt);
  EXPECT_NEAR(md.interaction_energy / (0.0744 * electronvolt), 1.0, 1e-15);
  EXPECT_EQ(md.interaction_distance, 3.28e-10);
  EXPECT_NEAR(md.mass / (197.0 * atomic_mass_unit), 1.0, 1e-15);
  EXPECT_EQ(md.damping, 2e12);
  EXPECT_EQ(md.time_step, 10e-15);
  EXPECT_EQ(md.lattice, mechanics::AtomLattice::isotropic);
  EXPECT_EQ(md.bulk, mechanics::AtomBulk::green);
  EXPECT_EQ(md.tolerance, 1e-4);
}

// Every example of the vocabulary is valid where its condition holds.
TEST(MdCase, TakesEveryExampleOfTheVocabulary) {
  for (const Key& key : vocabulary_table("md").keys)
    EXPECT_EQ(mistakes_in({"md." + key.name + "=" + key.example}), "")
        << key.name;
}

TEST(MdCase, NamesIncompatibleKeys) {
  EXPECT_EQ(mistakes_in({"md.engine=lammps"}),
            "  --set: md.engine = \"lammps\" needs lattice = \"central\": its "
            "bonds are central springs\n");
  EXPECT_EQ(mistakes_in({"md.lattice=central"}),
            "  --set: md.lattice = \"central\" has Poisson's ratio 1/4, but "
            "material.poisson_ratio = 0.42\n");
  EXPECT_EQ(
      mistakes_in({"md.cutoff=4 angstrom"}),
      "  --set: md.cutoff = \"4 angstrom\", but must be > contact_distance = "
      "4.3615e-10 m: otherwise atoms in contact would not interact\n");
  EXPECT_EQ(mistakes_in({"md.minimizer=dynamics"}),
            "  --set: md.minimizer needs bulk = \"explicit\": the atoms of a "
            "condensed block have no mass\n"
            "  case.toml:17: md.mass is missing, which this minimizer needs: a "
            "number [kg] or a string with one of: kg, u\n"
            "  case.toml:17: md.time_step is missing, which this minimizer "
            "needs: a number [s] or a string with one of: s, ps, fs\n"
            "  case.toml:17: md.damping is missing, which this minimizer "
            "needs: a number [1/s] or a string with one of: 1/s, 1/ps\n"
            "  case.toml:17: md.duration is missing, which this minimizer "
            "needs: a number [s] or a string with one of: s, ps, fs\n");
  EXPECT_EQ(mistakes_in({"md.temperature=300 K"}),
            "  case.toml:17: md.seed is missing, which a temperature needs: a "
            "whole number\n");
  EXPECT_EQ(mistakes_in({"md.atoms=401"}),
            "  --set: md.atoms = 401, but must be "
            "even\n");
  EXPECT_EQ(mistakes_in({"md.bulk=explicit", "md.levels=6"}),
            "  case.toml:18: md.atoms = 400, but must be a multiple of 32 for "
            "6 levels, each twice as coarse as the one before\n");
}

TEST(MdCase, NeedsThePotentialSpelledOut) {
  EXPECT_EQ(mistakes_in({"md.interaction_energy="}),
            "  case.toml:17: md.interaction_energy is missing: a number [J] or "
            "a string with one of: J, eV, meV\n");
}

TEST(Magnification, IsEveryMethodsOwn) {
  const Case read =
      read_case_text(atoms_case, "case.toml",
                     {"md.zoom.magnification=2", "theory.gamma=0.42"});

  ASSERT_EQ(read.methods.size(), 3U);
  EXPECT_EQ(read.methods[0].magnification, std::nullopt);
  EXPECT_EQ(read.methods[2].name, "md.zoom");
  EXPECT_EQ(read.methods[2].magnification, 2.0);
}

TEST(Magnification, IsRefusedWhereItLeavesNothing) {
  EXPECT_EQ(mistakes_in({"md.magnification=0.25"}),
            "  --set: md.magnification = 0.25, but must be >= 0.333333: below "
            "it the surface has no roughness\n");
  EXPECT_NE(mistakes_of(shape_case("kind = \"wave-1d\"\nlength = 1e-6\n"
                                   "points = 64\namplitude = 1e-8\n"
                                   "wavelength = 1e-6\n"),
                        {"halfspace.magnification=4"})
                .find("relative to their roll-off wavevector"),
            std::string::npos);
}

} // namespace asperity::cases::md_case_test
