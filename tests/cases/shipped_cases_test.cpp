// Tests of the folders in cases/: each is read without a mistake and is
// complete, and its exact references follow from its own numbers.
#include "cases/reader/collection.hpp"
#include "cases/reader/read_case.hpp"
#include "cases/reader/vocabulary.hpp"
#include "cases/sweeps/sweep.hpp"
#include "cases/types/reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>
#include <string>

namespace asperity::cases {
namespace {

constexpr double pi = std::numbers::pi;

const std::set<std::string> shipped = {
    "hertz",       "layered", "polymer", "polymer-nominal",
    "self-affine", "wave-1d", "wave-2d"};

// Full 3-D blocks, which are also read with their quick.set.
const std::set<std::string> full_blocks = {
    "elastic-sphere", "hertz-3d",  "hertz-adaptive",
    "heterogeneous",  "inclusion", "punch",
    "rough-3d",       "step42",    "two-blocks"};

// Atomistic blocks, whose claims are in the collection paper.
const std::set<std::string> blocks_of_atoms = {
    "md-lammps", "md-small", "md-verify", "md-zeta216", "md-zeta4"};

const std::set<std::string> parts_of_paper = {"adhesion",
                                              "finite-size-1",
                                              "finite-size-2",
                                              "finite-size-4",
                                              "finite-size-8",
                                              "magnification-atoms",
                                              "magnification-polymer",
                                              "polymer",
                                              "pressures-atoms",
                                              "separation-atoms",
                                              "surface-atoms",
                                              "surface-polymer"};

const std::set<std::string> parts_of_board = {"challenge",
                                              "hertz",
                                              "layered",
                                              "near-full-contact",
                                              "polymer",
                                              "self-affine-h03",
                                              "self-affine-h08-16",
                                              "self-affine-h08-4",
                                              "self-affine-h08-8",
                                              "self-affine-peer",
                                              "wave-1d",
                                              "wave-2d"};

const std::set<std::string> parts_of_peers = {"full-contact", "hertz",
                                              "westergaard"};

/// Names of the sub-folders that hold a case or a collection; the sources of
/// the module lie beside them.
std::set<std::string> folders_in(const std::string& folder) {
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (exists(entry.path() / "case.toml") ||
        exists(entry.path() / "collection.toml"))
      found.insert(entry.path().filename().string());
  return found;
}

Case shipped_case(const std::string& name) {
  return read_case("cases/" + name + "/case.toml");
}

double reference_of(const std::string& name, const std::string& quantity) {
  for (const ReferenceValue& reference :
       read_reference("cases/" + name + "/reference.csv"))
    if (reference.quantity == quantity)
      return reference.value;
  ADD_FAILURE() << name << " has no reference " << quantity;
  return NAN;
}

double pressure_of(const Case& read, std::size_t step) {
  return read.load.targets.at(step).in_si(
      {.contact_modulus = read.material.contact_modulus});
}

/// The overrides of a folder's quick.set; none without one.
std::vector<std::string> quick_lines(const std::string& folder) {
  std::vector<std::string> quick;
  std::ifstream lines(folder + "/quick.set");
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line.front() != '#')
      quick.push_back(line);
  return quick;
}

TEST(ShippedCases, AreTheFoldersThatAreThere) {
  std::set<std::string> expected = shipped;
  expected.insert(blocks_of_atoms.begin(), blocks_of_atoms.end());
  expected.insert(full_blocks.begin(), full_blocks.end());
  expected.insert({"board", "paper", "peers", "sweep-hurst"});

  EXPECT_EQ(folders_in("cases"), expected);
  EXPECT_EQ(folders_in("cases/board"), parts_of_board);
  EXPECT_EQ(folders_in("cases/peers"), parts_of_peers);
  for (const std::string& part : parts_of_paper)
    EXPECT_TRUE(folders_in("cases/paper").contains(part)) << part;
}

// Every part of the collection has its claim, its figures and its published
// numbers, and is read in full and with its quick.set. A series of parts has
// the figures of its first.
TEST(ShippedCases, ReadThePaperPartByPart) {
  const std::set<std::string> folders = folders_in("cases/paper");
  const Collection collection = read_collection(
      "cases/paper/collection.toml", {folders.begin(), folders.end()});
  for (const std::string& part : folders) {
    const std::string folder = "cases/paper/" + part;
    const std::vector<std::string> quick = quick_lines(folder);
    std::ostringstream readme;
    readme << std::ifstream(folder + "/README.md").rdbuf();

    EXPECT_EQ(read_case(folder + "/case.toml").name, part);
    EXPECT_EQ(read_case(folder + "/case.toml", quick).name, part);
    const bool has_figures =
        std::ranges::any_of(collection.figures, [&](const ShownFigure& figure) {
          return figure.part == part;
        });
    const bool is_later_of_series =
        part.starts_with("finite-size-") && part != "finite-size-1";
    EXPECT_EQ(has_figures, !is_later_of_series) << part;
    if (part != "finite-size-2" && part != "finite-size-4") { // none printed
      EXPECT_FALSE(read_reference(folder + "/reference.csv").empty()) << part;
    }
    for (const char* word : {"**Claim.**", "**Run.**"})
      EXPECT_NE(readme.str().find(word), std::string::npos) << part << word;
  }
}

TEST(ShippedCases, ReadThePeersProblems) {
  for (const std::string& part : parts_of_peers) {
    const std::string folder = "cases/peers/" + part;
    std::ostringstream readme;
    readme << std::ifstream(folder + "/README.md").rdbuf();

    EXPECT_EQ(read_case(folder + "/case.toml").name, part);
    if (part != "full-contact") { // no count is published
      EXPECT_FALSE(read_reference(folder + "/reference.csv").empty()) << part;
    }
    for (const char* word : {"**Claim.**", "**Shown.**", "**Run.**"})
      EXPECT_NE(readme.str().find(word), std::string::npos) << part << word;
  }
}

// Each benchmark problem can be solved by other programs: one surface, one
// half-space in hard contact, nominal pressures, and the solution at each load
// is saved.
TEST(ShippedCases, ReadTheBenchmarkProblems) {
  const Collection collection =
      read_collection("cases/board/collection.toml",
                      {parts_of_board.begin(), parts_of_board.end()});
  EXPECT_EQ(collection.parts.size(), parts_of_board.size());
  for (const std::string& part : parts_of_board) {
    const std::string folder = "cases/board/" + part;
    const Case read = read_case(folder + "/case.toml");
    std::ostringstream readme;
    readme << std::ifstream(folder + "/README.md").rdbuf();

    EXPECT_EQ(read.name, part);
    ASSERT_EQ(read.methods.size(), 1U) << part;
    EXPECT_EQ(read.methods.front().name, "halfspace") << part;
    EXPECT_EQ(read.load.control, mechanics::Control::nominal_pressure) << part;
    EXPECT_GE(read.report.fields, std::ssize(read.load.targets)) << part;
    EXPECT_EQ(read.surface.realizations, 1) << part;
    EXPECT_EQ(read_case(folder + "/case.toml", quick_lines(folder)).name, part);
    if (part != "near-full-contact") { // no number is published
      EXPECT_FALSE(read_reference(folder + "/reference.csv").empty()) << part;
      EXPECT_FALSE(read.expectations.empty()) << part;
    }
    for (const char* word : {"**Claim.**", "**Shown.**", "**Run.**"})
      EXPECT_NE(readme.str().find(word), std::string::npos) << part << word;
  }
}

TEST(ShippedCases, ReadWithoutAMistakeAndAreComplete) {
  for (const std::string& name : shipped) {
    const Case read = shipped_case(name);

    EXPECT_EQ(read.name, name);
    EXPECT_GE(read.methods.size(), 2U) << name;
    EXPECT_EQ(read.surface.points, 512) << name;
    EXPECT_FALSE(read_reference("cases/" + name + "/reference.csv").empty());
    EXPECT_TRUE(std::filesystem::exists("cases/" + name + "/README.md"));
  }
}

TEST(ShippedCases, ReadTheSweepWithAllItsPoints) {
  const CaseSweep sweep = read_sweep("cases/sweep-hurst/case.toml");

  EXPECT_EQ(sweep.name, "sweep-hurst");
  EXPECT_EQ(sweep.points.size(), 8U);
  EXPECT_FALSE(read_reference("cases/sweep-hurst/reference.csv").empty());
  EXPECT_TRUE(std::filesystem::exists("cases/sweep-hurst/README.md"));
}

TEST(ShippedCases, ReadTheFullBlocksInFullAndQuickly) {
  for (const std::string& name : full_blocks) {
    const std::string folder = "cases/" + name;

    EXPECT_EQ(shipped_case(name).name, name);
    EXPECT_EQ(read_case(folder + "/case.toml", quick_lines(folder)).name, name);
    EXPECT_FALSE(read_reference(folder + "/reference.csv").empty());
    EXPECT_TRUE(std::filesystem::exists(folder + "/README.md"));
  }
}

// "Undecided" passes only where a case says so.
TEST(ShippedCases, StateWhatUndecidedCountsAs) {
  EXPECT_TRUE(shipped_case("polymer").expectations.front().passes_if_undecided);
  EXPECT_FALSE(
      shipped_case("layered").expectations.front().passes_if_undecided);
}

// The cut-offs of the polymer are 2, 4.5 and 128 times 2 pi / 10 um, those of
// the nominal one 1, 5.88 and 128. Tolerance: the 16 digits written.
TEST(ShippedCases, HaveThePolymersSpectra) {
  const double unit = 2.0 * pi / 10e-6;
  const mechanics::SurfaceSpec surrogate = shipped_case("polymer").surface;
  const mechanics::SurfaceSpec nominal =
      shipped_case("polymer-nominal").surface;

  EXPECT_NEAR(surrogate.wavevector_low / unit, 2.0, 1e-14);
  EXPECT_NEAR(surrogate.wavevector_roll_off / unit, 4.5, 1e-14);
  EXPECT_NEAR(surrogate.wavevector_high / unit, 128.0, 1e-12);
  EXPECT_NEAR(nominal.wavevector_low / unit, 1.0, 1e-14);
  EXPECT_NEAR(nominal.wavevector_roll_off / unit, 5.88, 1e-14);
  EXPECT_NEAR(nominal.wavevector_high / unit, 128.0, 1e-12);
}

// a^3 = 3 F R / (4 E*) at the loads of the case. Tolerance: roundoff.
TEST(ShippedCases, GiveHertzsReferences) {
  const Case hertz = shipped_case("hertz");
  const double area = *hertz.surface.length * *hertz.surface.length;
  const std::size_t last = hertz.load.targets.size() - 1;
  for (const auto& [step, name] :
       {std::pair<std::size_t, std::string>{0, "first_step"},
        std::pair<std::size_t, std::string>{last, "last_step"}}) {
    const double radius =
        std::cbrt(0.75 * pressure_of(hertz, step) * area *
                  hertz.surface.radius / hertz.material.contact_modulus);

    EXPECT_NEAR(reference_of("hertz", "contact_radius_" + name) / radius, 1.0,
                1e-14);
    EXPECT_NEAR(reference_of("hertz", "approach_" + name) /
                    (radius * radius / hertz.surface.radius),
                1.0, 1e-14);
  }
}

// The mean gaps of board/hertz are those of a paraboloid in a square array,
// crest minus a^2/R' - F/(pi E* L) (S - T a^2/(10 L^2)), with the crest and the
// rms height of the case's nodes and 1/R' = 1/R + T F/(2 pi E* L^3). Tolerance:
// the six decimals written.
TEST(ShippedCases, GiveTheMeanGapsOfTheSquareArray) {
  const Case read = shipped_case("board/hertz");
  const mechanics::SurfaceSpec& surface = read.surface;
  const double side = *surface.length, modulus = read.material.contact_modulus;
  double square = 0.0, fourth = 0.0; // means of x^2 and x^4
  const int n = *surface.points;
  for (int i = 0; i < n; ++i) {
    const double x = side * (static_cast<double>(i) / n - 0.5);
    square += x * x / n;
    fourth += x * x * x * x / n;
  }
  const double crest = square / surface.radius;
  const double rms_height =
      std::sqrt((fourth - square * square) / 2.0) / surface.radius;
  constexpr double s = 3.9002649200019564, t = 9.03362168310095;

  for (const auto& [step, load] :
       {std::pair<std::size_t, std::string>{1, "10 kPa"},
        std::pair<std::size_t, std::string>{3, "300 kPa"}}) {
    const double displacement = // F/(pi E* L)
        pressure_of(read, step) * side / (pi * modulus);
    const double radius =
        1.0 / (1.0 / surface.radius + 0.5 * t * displacement / (side * side));
    const double a = std::cbrt(0.75 * pi * displacement * side * radius);
    const double approach =
        a * a / radius - displacement * (s - t * a * a / (10.0 * side * side));

    EXPECT_NEAR(reference_of("board/hertz", "reduced_mean_gap@p=" + load),
                (crest - approach) / rms_height, 1e-6);
  }
}

// The loads of the waves are P = 0.01 to 0.95 of the pressure of full contact.
TEST(ShippedCases, LoadTheWavesFromOneToNinetyFivePerCent) {
  for (const std::string name : {"wave-1d", "wave-2d"}) {
    const Case wave = shipped_case(name);
    const double full_contact = (name == "wave-1d" ? 1.0 : std::sqrt(2.0)) *
                                pi * wave.material.contact_modulus *
                                wave.surface.amplitude /
                                wave.surface.wavelength;

    EXPECT_NEAR(pressure_of(wave, 0) / full_contact, 0.01, 1e-15);
    EXPECT_NEAR(pressure_of(wave, 11) / full_contact, 0.95, 1e-13);
  }
}

TEST(ShippedCases, GiveTheWavesReferences) {
  for (const auto& [reduced_pressure, digits] :
       {std::pair<double, std::string>{0.01, "0.01"},
        std::pair<double, std::string>{0.5, "0.5"},
        std::pair<double, std::string>{0.95, "0.95"}}) {
    const std::string end = "_at_reduced_pressure_" + digits;

    // sin^2 of a quarter turn times the fraction is P: the formula inverted.
    const double fraction = reference_of("wave-1d", "area_fraction" + end);
    EXPECT_NEAR(std::pow(std::sin(pi / 2.0 * fraction), 2), reduced_pressure,
                1e-15);
    // The gap is the integral of -ln from P to 1: -dg/dP = -ln P, g(1) = 0.
    const double gap = reference_of("wave-1d", "mean_gap_over_amplitude" + end);
    double sum = 0.0;
    const int n_steps = 20000; // midpoint rule: error 1e-6 at P = 0.01
    const double step = (1.0 - reduced_pressure) / n_steps;
    for (int i = 0; i < n_steps; ++i)
      sum -= std::log(reduced_pressure + (i + 0.5) * step) * step;
    EXPECT_NEAR(gap, sum, 1e-6);
  }
}

// The block of keys that was agreed on is read as it stands, and the list below
// is what the vocabulary has beyond it, so that a key cannot be added
// unnoticed. (A key counts as agreed where the block contains its word.) Later
// additions have their own tests: md_case_test.cpp, studies_test.cpp,
// block_test.cpp.
TEST(Vocabulary, HasTheAgreedBlockAndTheseKeysBeyondIt) {
  const Case agreed = read_case("tests/cases/agreed_block.toml");
  EXPECT_EQ(agreed.methods.size(), 3U);

  const std::set<std::string> later = {"md",
                                       "magnification",
                                       "magnification.leak",
                                       "adhesion",
                                       "mesh",
                                       "mesh.counter",
                                       "material.layer",
                                       "material.inclusion",
                                       "material.variation"};
  std::set<std::string> beyond;
  const std::string block = agreed.text;
  for (const Table& table : vocabulary())
    for (const Key& key : table.keys)
      if (table.name != "expect" && !later.contains(table.name) &&
          key.name != "magnification" &&
          block.find(key.name) == std::string::npos)
        beyond.insert(table.name + "." + key.name);

  EXPECT_EQ(beyond, (std::set<std::string>{".base",
                                           "expect.band.above",
                                           "expect.band.below",
                                           "expect.band.if_undecided",
                                           "halfspace.boundaries",
                                           "halfspace.max_iterations",
                                           "fem.max_iterations",
                                           "fem.mesh",
                                           "fem.sides",
                                           "fem.linear_solver",
                                           "fem.contact_at",
                                           "fem.height_interpolation",
                                           "fem.bodies",
                                           "fem.stiffness",
                                           "surface.form_radius",
                                           "surface.recess",
                                           "surface.tilt",
                                           "material.layers",
                                           "report.fields",
                                           "report.stress_inside",
                                           "report.vtu",
                                           "surface.align_lines",
                                           "surface.amplitudes",
                                           "surface.channel",
                                           "surface.crop_length_x",
                                           "surface.crop_length_y",
                                           "surface.crop_x",
                                           "surface.crop_y",
                                           "surface.fill",
                                           "surface.height_unit",
                                           "surface.length_unit",
                                           "surface.length_y",
                                           "surface.max_missing",
                                           "surface.press_windowed_map",
                                           "surface.remove_spikes",
                                           "surface.rescale",
                                           "sweep.combine",
                                           "winkler.stiffness"}));
}

} // namespace
} // namespace asperity::cases
