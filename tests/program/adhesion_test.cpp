// Adhesion as a user asks for it: by an option for a map, up to full contact,
// and by atoms beside a half-space.
#include "tests/program/program.hpp"
#include "tests/rough_case.hpp"

namespace asperity::program::adhesion_test {
namespace {

using AdhesionTest = ProgramTest;

/// A map of one bump, in nm.
std::string bump() {
  std::string text;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      text += (x > 5 && x < 10 && y > 5 && y < 10 ? "4 " : "0 ") +
              std::string(x == 15 ? "\n" : "");
  return text;
}

} // namespace

TEST_F(AdhesionTest, AMapIsPressedAndPulledOff) {
  write("map.txt", bump());
  const std::string command =
      "run map.txt --length \"1 um\" --height-unit nm --contact-modulus \"2 "
      "GPa\" --work-of-adhesion ";
  const Ended pulled = run(command + "\"50 mJ/m^2\" --out pulled");
  ASSERT_EQ(pulled.exit_code, 0) << pulled.output;
  const std::string page = text_of(folder / "pulled/report.html");
  EXPECT_NE(page.find("It sticks: 2.2 % of the work of adhesion is lost on the "
                      "way in and back, and the largest tension is "),
            std::string::npos);
  EXPECT_NE(page.find("adhesion of 50 mJ/m² over 2.5 nm"), std::string::npos);
  EXPECT_NE(page.find("criterion of Pastewka and Robbins"), std::string::npos);
  EXPECT_TRUE(
      std::filesystem::exists(folder / "pulled/figures/adhesion-loop.svg"));
  EXPECT_LT(page.find("Approach and retraction with adhesion"),
            page.find("Pressure against separation")) // and leads the page
      << page.size();

  EXPECT_NE(page.find("29 load steps, mean gaps "), std::string::npos);
  const std::string bound = ", because the path never presses the faces";
  EXPECT_NE(page.find("the largest tension is at least 13.7 MPa" + bound),
            std::string::npos);
  const Ended deep = run(command + "\"50 mJ/m^2\" --out deep "
                                   "--set 'load.mean_gap=[\"1 h_rms\", "
                                   "\"0.4 h_rms\", \"0.01 h_rms\"]'");
  EXPECT_NE(deep.output.find("the largest tension is 1"), std::string::npos)
      << deep.output;
  EXPECT_EQ(deep.output.find(bound), std::string::npos);

  // Faces that the path has not parted are judged by the criterion.
  const Ended held = run(command + "\"50 mJ/m^2\" --out held "
                                   "--set 'load.mean_gap=[\"0.5 h_rms\", "
                                   "\"0.4 h_rms\", \"0.35 h_rms\"]'");
  EXPECT_NE(held.output.find("It sticks: the largest tension is at least "),
            std::string::npos)
      << held.output;

  const Ended pressed =
      run(command + "\"50 mJ/m^2\" --pressure \"100 MPa\" --out pressed");
  EXPECT_NE(pressed.output.find("It sticks: the largest tension is not known, "
                                "because no load of the path pulls"),
            std::string::npos)
      << pressed.output;

  const Ended wrong = run(command + "\"50 mJ\"");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.output.find("--work-of-adhesion = \"50 mJ\" has the unit "
                              "mJ of an energy, but must have one of: J/m^2"),
            std::string::npos)
      << wrong.output;
  const Ended fine = run(command + "\"50 mJ/m^2\" --set halfspace.range=1e-9");
  EXPECT_EQ(fine.exit_code, 2);
  EXPECT_NE(fine.output.find("halfspace.range = 1e-09, but must be at least"),
            std::string::npos)
      << fine.output;
  EXPECT_NE(fine.output.find("or a map with a spacing of at most 4e-08 m"),
            std::string::npos)
      << fine.output;
}

// With free edges loads are pressures, and go on to tensions until the faces
// part; the case that `new` writes has what --set says.
TEST_F(AdhesionTest, AMapWithFreeEdgesIsPulledUntilItParts) {
  write("map.txt", bump());
  const Ended made =
      run("new free --map map.txt --length \"1 um\" --height-unit nm "
          "--contact-modulus \"2 GPa\" --work-of-adhesion \"50 mJ/m^2\" "
          "--set surface.edges=free");
  ASSERT_EQ(made.exit_code, 0) << made.output;
  const std::string text = text_of(folder / "free/case.toml");
  EXPECT_NE(text.find("\nedges = \"free\"\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("[theory]"), std::string::npos) << text;
  const Ended pulled = run("run free --out pulled");
  ASSERT_EQ(pulled.exit_code, 0) << pulled.output;
  EXPECT_NE(pulled.output.find("detached: the contact does not hold"),
            std::string::npos)
      << pulled.output;
  EXPECT_NE(pulled.output.find("the largest tension is 1"), std::string::npos)
      << pulled.output;
  const Ended held =
      run("run free --out held --set 'load.nominal_pressure=[\"1 MPa\", "
          "\"-0.1 MPa\"]'");
  EXPECT_NE(held.output.find("the largest tension is at least 100 kPa, because "
                             "the faces hold it at the end of the path"),
            std::string::npos)
      << held.output;
}

// Several maps have gaps of their own as loads: the page leads with the tension
// of each, and compares them at equal gaps over their rms heights.
TEST_F(AdhesionTest, SeveralMapsStateTheirLargestTension) {
  std::filesystem::create_directory(folder / "maps");
  write("maps/a.txt", bump());
  write("maps/b.txt", "9" + bump().substr(1));
  const Ended ended =
      run("run maps --length \"1 um\" --height-unit nm --contact-modulus \"2 "
          "GPa\" --work-of-adhesion \"50 mJ/m^2\" --out both");
  ASSERT_EQ(ended.exit_code, 0) << ended.output;
  EXPECT_NE(ended.output.find("The largest tension is at least 1"),
            std::string::npos)
      << ended.output;
  EXPECT_NE(
      ended.output.find("over 2 maps (mean and standard deviation), because "
                        "some paths end in tension or never press the faces."),
      std::string::npos)
      << ended.output;
  const std::string page = text_of(folder / "both/report.html");
  EXPECT_EQ(page.find("states no expectation"), std::string::npos);
  EXPECT_NE(page.find("b.txt</a></td>"), std::string::npos);
  EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);

  const std::string table = text_of(folder / "both/loads.csv");
  auto mean = columns_of(table, "mean");
  ASSERT_EQ(mean["mean_gap_over_rms_height [1]"].size(), 29U);
  EXPECT_EQ(mean["mean_gap_over_rms_height [1]"][1], "3.5");
  for (const char* column : {"nominal_pressure [Pa]", "mean_gap [m]"}) {
    double sum = 0.0;
    for (const std::string point : {"000", "001"}) {
      auto rows = columns_of(
          text_of(folder / "both/points" / point / "curves.csv"), "halfspace");
      sum += std::stod(rows[column][14]); // at 0.1 h_rms
    }
    EXPECT_NE(sum, 0.0);
    EXPECT_NEAR(std::stod(mean[column][14]), 0.5 * sum, 1e-8 * std::abs(sum))
        << column;
  }
}

// Without an open node there is no smallest stiffness, and the result can be
// read.
TEST_F(AdhesionTest, FullContactIsAResult) {
  write("full.toml", tests::rough_case("Full", 32, "[ \"0.01 E*\", \"1 E*\" ]",
                                       "[halfspace]\ncontact = \"cubic\"\n"
                                       "work_of_adhesion = \"50 mJ/m^2\"\n"));
  const Ended full = run("run full.toml --out full");
  ASSERT_EQ(full.exit_code, 0) << full.output;
  EXPECT_NE(full.output.find("A = 100.000 %"), std::string::npos)
      << full.output;
}

// Atoms that attract are the half-space with the law of their layers: the loads
// at equal gaps differ by 0.4 % of the largest tension, which is the product of
// slope and lateral displacement. 5 % of w are seen.
TEST_F(AdhesionTest, AtomsActAsTheLawOfTheirLayers) {
  write("atoms.toml", R"(schema = 1
[surface]
kind = "wave-2d"
length = "12.48 nm"
points = 78
amplitude = "0.15 nm"
wavelength = "1 length"
[material]
youngs_modulus = "77.2 GPa"
poisson_ratio = 0.42
[load]
mean_gap = ["0.4 nm", "0.2 nm", "0.1 nm"]
cycle = "load-unload"
[halfspace]
contact = "lennard-jones-10-4"
work_of_adhesion = "596.06 mJ/m^2"
range = "2.92215 angstrom"
[md]
atoms = 48
potential = "lennard-jones"
interaction_energy = "20 meV"
interaction_distance = "3.28 angstrom"
cutoff = "2 nm"
contact_distance = "2.92215 angstrom"
[expect]
adhesive_difference = { below = 0.01, methods = ["md"] }
)");
  const Ended described = run("describe atoms.toml");
  EXPECT_NE(described.output.find("0.596059 J/m^2  (w of md)"),
            std::string::npos)
      << described.output;

  const Ended same = run("run atoms.toml --out same");
  EXPECT_EQ(same.exit_code, 0) << same.output;
  EXPECT_EQ(same.output.find("figure not drawn"), std::string::npos)
      << same.output; // though no step is pressed
  const std::string csv = text_of(folder / "same/curves.csv");
  auto half = columns_of(csv, "halfspace");
  auto atoms = columns_of(csv, "md");
  for (const auto& [column, most] :
       {std::pair("area_fraction [1]", 0.006),
        std::pair("repulsive_area [1]", 0.006),
        std::pair("tensile_area [1]", 0.002),
        std::pair("attractive_load [Pa]", 2e7),
        std::pair("elastic_energy [J/m^2]", 1e-3),
        std::pair("adhesive_energy [J/m^2]", 5e-3)}) {
    ASSERT_EQ(atoms[column].size(), 5U);
    EXPECT_NE(std::stod(atoms[column][2]), 0.0) << column;
    EXPECT_NEAR(std::stod(half[column][2]), std::stod(atoms[column][2]), most)
        << column;
  }
  // All but the contact is in tension.
  EXPECT_GT(std::stod(atoms["tensile_area [1]"][2]), 0.9);
  EXPECT_GT(std::stod(atoms["attractive_load [Pa]"][2]),
            -std::stod(atoms["nominal_pressure [Pa]"][2]));
  const Ended other = run("run atoms.toml --out other --set "
                          "\"halfspace.work_of_adhesion=626 mJ/m^2\"");
  EXPECT_NE(other.exit_code, 0) << other.output;
}

} // namespace asperity::program::adhesion_test
