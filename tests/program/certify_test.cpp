// Tests of `asperity certify`: our own fields are certified to the tolerance of
// the solver, damage appears in the right column, and a field without a bound
// is reported as such.
#include "results/result_reader.hpp"
#include "tests/program/program.hpp"

#include <map>
#include <sstream>
#include <vector>

namespace asperity::program::certify_test {

using Row = std::vector<double>; ///< columns after the name of the method

/// The rows of the table, by the name of the method.
std::map<std::string, std::vector<Row>> rows_of(const std::string& output) {
  std::map<std::string, std::vector<Row>> rows;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name;
    words >> name;
    Row row;
    for (double number = 0.0; words >> number;)
      row.push_back(number);
    if (row.size() == 10 && words.eof())
      rows[name].push_back(row);
  }
  return rows;
}

/// A case with one method; `surface` and `load` are the lines of these tables.
std::string case_of(const std::string& surface, const std::string& load,
                    const std::string& method) {
  return "schema = 1\ntitle = \"one load\"\n[surface]\nlength = \"1 um\"\n" +
         surface +
         "[material]\nyoungs_modulus = \"2 GPa\"\npoisson_ratio = 0.3\n"
         "[load]\n" +
         load + "[" + method + "]\ncontact = \"hard\"\n";
}

const std::string sphere =
    "kind = \"sphere\"\npoints = 64\nradius = \"2 um\"\n";
const std::string small_load = "nominal_pressure = [\"1e-3 E*\"]\n";

using CertifyCommand = ProgramTest;

// Fields in single precision have a load error and a complementarity error of
// 1e-7; the mean gap of a row is that of the solver, exact to 1e-8 h_rms.
TEST_F(CertifyCommand, CertifiesOurOwnFields) {
  write("small.toml", small_case);
  const Ended made = run("run small.toml --no-report --out result");
  ASSERT_EQ(made.exit_code, 0) << made.output;

  const Ended done = run("certify result");

  ASSERT_EQ(done.exit_code, 0) << done.output;
  const auto rows = rows_of(done.output);
  ASSERT_FALSE(rows.empty()) << done.output;
  ASSERT_TRUE(rows.contains("halfspace") && rows.contains("fem"))
      << done.output;
  for (const auto& [method, of_method] : rows)
    for (const Row& row : of_method) {
      EXPECT_LT(std::abs(row[2]), 1e-7) << done.output; // load
      EXPECT_EQ(row[3], 0.0) << done.output;            // tension
      EXPECT_LT(row[5], 1e-6) << done.output;           // complementarity
      EXPECT_LT(row[6], 1e-5) << done.output;           // energy
      EXPECT_LT(row[7], 1e-2) << done.output;           // pressure
      EXPECT_LT(row[9], 1e-6) << done.output;           // mean gap
    }
  EXPECT_NE(
      done.output.find("theory           as submitted: no pressure field"),
      std::string::npos)
      << done.output;
}

// The same holds for fields of second-order elements on a surface whose mean,
// weighted by the areas of the nodes, is not 0.
TEST_F(CertifyCommand, CertifiesUnequalNodes) {
  write("sphere.toml", case_of(sphere, small_load, "fem"));
  const Ended run_it = run("run sphere.toml --no-report --out sphere");
  ASSERT_EQ(run_it.exit_code, 0) << run_it.output;

  const Ended done = run("certify sphere");

  const auto rows = rows_of(done.output);
  ASSERT_TRUE(rows.contains("fem")) << done.output;
  EXPECT_LT(rows.at("fem").at(0)[9], 1e-6) << done.output;
}

// A result is sufficient: the map of its case may be absent.
TEST_F(CertifyCommand, NeedsNoInputFile) {
  std::string map;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x)
      map += std::to_string((7 * x * x + 5 * y * y + 3 * x * y) % 17) + " ";
    map += "\n";
  }
  write("map.txt", map);
  write("measured.toml", case_of("kind = \"measured\"\nfile = \"map.txt\"\n"
                                 "height_unit = \"1 nm\"\nlevel = \"none\"\n",
                                 small_load, "halfspace"));
  const Ended done = run("run measured.toml --no-report --out measured");
  ASSERT_EQ(done.exit_code, 0) << done.output;
  std::filesystem::remove(folder / "map.txt");

  const Ended certified = run("certify measured");

  EXPECT_EQ(certified.exit_code, 0) << certified.output;
  const auto rows = rows_of(certified.output);
  ASSERT_TRUE(rows.contains("halfspace")) << certified.output;
  EXPECT_LT(rows.at("halfspace").at(0)[9], 1e-6) << certified.output;
}

// A field without contact has no bound, and the others keep theirs.
TEST_F(CertifyCommand, ContinuesAfterAFieldWithoutContact) {
  write("away.toml", case_of(sphere, "mean_gap = [\"9 h_rms\", \"1 h_rms\"]\n",
                             "halfspace"));
  const Ended done = run("run away.toml --no-report --out away");
  ASSERT_EQ(done.exit_code, 0) << done.output;

  const Ended certified = run("certify away");

  EXPECT_EQ(certified.exit_code, 0) << certified.output;
  EXPECT_NE(certified.output.find("as submitted: step 0: "), std::string::npos)
      << certified.output;
  EXPECT_EQ(rows_of(certified.output)["halfspace"].size(), 1U)
      << certified.output;
}

TEST_F(CertifyCommand, RefusesAFileWithoutFields) {
  write("small.toml", small_case);
  const Ended done = run("run small.toml --methods halfspace --no-report "
                         "--out bare --set report.fields=0");
  ASSERT_EQ(done.exit_code, 0) << done.output;

  const Ended bare = run("certify bare");

  EXPECT_EQ(bare.exit_code, 2) << bare.output;
  EXPECT_NE(bare.output.find("no field could be certified"), std::string::npos);
}

} // namespace asperity::program::certify_test
