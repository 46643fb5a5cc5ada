// Tests of [sweep] (input/sweeps/sweep.hpp): which points a file has, that each
// is an ordinary case, and that every mistake names file, line and key.
#include "base/temporary_folder.hpp"
#include "input/input_error.hpp"
#include "input/reader/read_case.hpp"
#include "input/sweeps/sweep.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "case_samples.hpp"

namespace asperity::cases::sweep_test {

namespace fs = std::filesystem;

class Sweep : public ::testing::Test {
private:
  TemporaryFolder temporary_{"sweep"};

protected:
  const fs::path folder = temporary_.path();

  /// Writes the sample case with these lines in its [sweep].
  std::string with(const std::string& lines) const {
    const std::string file = (folder / "rough.toml").string();
    std::ofstream(file) << contact_case << "\n[sweep]\n" << lines;
    return file;
  }

  CaseSweep read(const std::string& lines,
                 const std::vector<std::string>& overrides = {}) const {
    return read_sweep(with(lines), overrides);
  }

  std::string mistake(const std::string& lines,
                      const std::vector<std::string>& overrides = {}) const {
    return tests::message_of<input::InputError>(
        [&] { (void)read(lines, overrides); });
  }

  void expect_mistake(const std::string& lines,
                      const std::vector<std::string>& words) const {
    const std::string found = mistake(lines);
    for (const std::string& word : words)
      EXPECT_NE(found.find(word), std::string::npos) << word << "\n" << found;
  }
};

TEST_F(Sweep, MakesEveryPairOfAProduct) {
  const CaseSweep sweep = read("\"surface.hurst\" = [0.5, 0.7]\n"
                               "\"surface.seed\" = [1, 2, 3]\n");

  ASSERT_EQ(sweep.points.size(), 6U);
  EXPECT_EQ(sweep.points[4].contact_case.surface.hurst, 0.7);
  EXPECT_EQ(sweep.points[4].contact_case.surface.seed, 2U);
  EXPECT_EQ(point_label(sweep.keys, sweep.points[4].choice),
            "surface.hurst = 0.7, surface.seed = 2");
}

TEST_F(Sweep, ZipsTheListsSideBySide) {
  const CaseSweep sweep = read("combine = \"zip\"\nsurface.hurst = [0.5, 0.7]\n"
                               "surface.points = [64, 128]\n");

  ASSERT_EQ(sweep.points.size(), 2U);
  EXPECT_EQ(sweep.points[1].contact_case.surface.hurst, 0.7);
  EXPECT_EQ(sweep.points[1].contact_case.surface.points, 128);
}

// A point is an ordinary case: its text alone gives it again.
TEST_F(Sweep, HasOrdinaryCasesAsPoints) {
  const CaseSweep sweep = read("surface.hurst = [0.5, 0.7]\n");
  const Case& point = sweep.points[1].contact_case;

  const Case again = read_case_text(point.text, point.path);

  EXPECT_EQ(again.surface.hurst, 0.7);
  EXPECT_EQ(again.title, sweep.title + ": surface.hurst = 0.7");
}

// The values are those that --set and a base case accept: a list, an empty
// string that removes the key, and a quantity with its unit.
TEST_F(Sweep, TakesAnyValueOfAKey) {
  const CaseSweep sweep = read(
      "combine = \"zip\"\nload.nominal_pressure = [[\"1 MPa\", \"2 MPa\"], "
      "[\"3 MPa\"]]\nsurface.rms_slope = [0.1, \"\"]\n"
      "surface.rms_height = [\"\", \"5 nm\"]\n");

  EXPECT_EQ(sweep.points[0].contact_case.load.targets.size(), 2U);
  EXPECT_FALSE(sweep.points[1].contact_case.surface.rms_slope);
  EXPECT_EQ(sweep.points[1].contact_case.surface.rms_height, 5e-9);
  EXPECT_EQ(sweep.points[0].contact_case.surface.rms_slope, 0.1);
}

TEST_F(Sweep, RefusesAKeyWithoutATable) {
  expect_mistake("combin = \"zip\"\n", {"rough.toml:", "nearest: combine"});
  expect_mistake("hurst = [0.5]\n",
                 {"sweep.hurst is unknown", "nearest: \"surface.hurst\""});
  expect_mistake("\"sweep.combine\" = [1]\n", {"not a key of the case"});
}

TEST_F(Sweep, RefusesWhatIsNotAListOfValues) {
  expect_mistake("surface.hurst = 0.5\n",
                 {"rough.toml:", "surface.hurst = 0.5", "a list of values"});
  expect_mistake("surface.hurst = []\n",
                 {"the list of surface.hurst is empty"});
  expect_mistake("surface.hurst = [0.5, 0.5]\n", {"the value 0.5 twice"});
  expect_mistake("combine = \"all\"\nsurface.hurst = [0.5]\n",
                 {"combine = \"all\"", "product"});
  expect_mistake("", {"no key to sweep"});
  expect_mistake("surface.hurst = [0.5]\n\"surface.hurst\" = [0.6]\n",
                 {"surface.hurst twice"});
}

TEST_F(Sweep, RefusesListsThatDoNotMatch) {
  expect_mistake("combine = \"zip\"\nsurface.hurst = [0.5, 0.6]\n"
                 "surface.seed = [1, 2, 3]\n",
                 {"surface.hurst has 2 values and surface.seed has 3"});
}

// The number of points is limited, however many keys multiply.
TEST_F(Sweep, RefusesTooManyPoints) {
  std::string list = "[0";
  for (int i = 1; i < 101; ++i)
    list += ", " + std::to_string(i);
  list += "]\n";
  expect_mistake("surface.seed = " + list + "surface.points = " + list,
                 {"more than 1000 points"});
}

// A point that is no valid case is named with its values; the line is that of
// the value in the list.
TEST_F(Sweep, NamesThePointThatIsInvalid) {
  expect_mistake("surface.hurst = [0.5, 1.5]\n",
                 {"1 of the 2 points", "Point 1, surface.hurst = 1.5",
                  "rough.toml:", "surface.hurst = 1.5, but must"});
  expect_mistake("surface.hurts = [0.5, 0.6]\n",
                 {"2 of the 2 points", "surface.hurts", "nearest: hurst"});
}

// A mistake of the file itself is reported as for any case.
TEST_F(Sweep, ReportsAMistakeOfTheFile) {
  EXPECT_NE(mistake("surface.hurst = [0.5]\n", {"load.cyle=load"})
                .find("load.cyle is not a key"),
            std::string::npos);
}

TEST_F(Sweep, IsChangedBySet) {
  const std::string quoted = "\"surface.hurst\" = [0.5, 0.7]\n";

  EXPECT_EQ(read(quoted, {"sweep.\"surface.hurst\"=[0.4]"}).points.size(), 1U);
  EXPECT_EQ(read(quoted, {"sweep.surface.hurst=[0.4]"}).points.size(), 1U);
  EXPECT_NE(mistake(quoted, {"surface.hurst=0.4"}).find("sweeps this key"),
            std::string::npos);
  EXPECT_FALSE(is_sweep(with(quoted), {"sweep="}));
  EXPECT_EQ(read_case(with(quoted), {"sweep="}).surface.hurst,
            read_case_text(contact_case, "rough.toml").surface.hurst);
}

TEST_F(Sweep, IsNoSingleCase) {
  const std::string file = with("surface.hurst = [0.5, 0.7]\n");

  EXPECT_TRUE(is_sweep(file));
  EXPECT_THROW((void)read_case(file), input::InputError);
}

// A case with a base may sweep it, and may sweep other values.
TEST_F(Sweep, MayHaveABase) {
  with("\"surface.hurst\" = [0.5, 0.7]\n");
  const std::string file = (folder / "other.toml").string();
  std::ofstream(file) << "base = \"rough.toml\"\n[sweep]\n"
                         "surface.hurst = [0.2, 0.3, 0.4]\n";

  EXPECT_EQ(read_sweep(file).points.at(2).contact_case.surface.hurst, 0.4);
}

} // namespace asperity::cases::sweep_test
