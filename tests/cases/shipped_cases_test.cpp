// Tests of the folders in cases/: each is read without a mistake and is
// complete.
#include "cases/reader/collection.hpp"
#include "cases/reader/read_case.hpp"
#include "cases/sweeps/sweep.hpp"
#include "cases/types/reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace asperity::cases::shipped_cases_test {

const std::set<std::string> shipped = {
    "hertz",       "layered", "polymer", "polymer-nominal",
    "self-affine", "wave-1d", "wave-2d"};

const std::set<std::string> adhesive = {"adhesive-rough", "adhesive-sphere",
                                        "adhesive-wave", "adhesive-atoms",
                                        "challenge"};

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
                                              "fe-coated",
                                              "fe-hertz",
                                              "fe-punch",
                                              "fe-rough-32",
                                              "fe-rough-64",
                                              "fe-rounded-punch",
                                              "free-cone",
                                              "free-punch",
                                              "free-rough",
                                              "free-rounded-punch",
                                              "free-sphere",
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

const std::set<std::string> parts_of_peers = {"full-contact", "gfmd-zhou",
                                              "hertz", "westergaard"};

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

/// The overrides of a folder's quick.set; none without one.
std::vector<std::string> quick_lines(const std::string& folder) {
  std::vector<std::string> quick;
  std::ifstream lines(folder + "/quick.set");
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line.front() != '#')
      quick.push_back(line);
  return quick;
}

/// True if `folder` has all of `names`; a user may keep more cases beside them.
bool has_folders(const std::string& folder,
                 const std::set<std::string>& names) {
  return std::ranges::includes(folders_in(folder), names);
}

TEST(ShippedCases, AreFolders) {
  std::set<std::string> expected = shipped;
  expected.insert(blocks_of_atoms.begin(), blocks_of_atoms.end());
  expected.insert(full_blocks.begin(), full_blocks.end());
  expected.insert(adhesive.begin(), adhesive.end());
  expected.insert({"adhesion-numbers", "board", "gamma", "hardness", "paper",
                   "peers", "sweep-hurst"});

  EXPECT_TRUE(has_folders("cases", expected));
  EXPECT_TRUE(has_folders("cases/board", parts_of_board));
  EXPECT_TRUE(has_folders("cases/peers", parts_of_peers));
  EXPECT_TRUE(has_folders("cases/paper", parts_of_paper));
  EXPECT_FALSE(has_folders("cases", {"no-such-case"}));
}

// Every part of the collection has its claim, its figures and its published
// numbers, and is read in full and with its quick.set. A series of parts has
// the figures of its first.
TEST(ShippedCases, ReadThePaperPartByPart) {
  const Collection collection =
      read_collection("cases/paper/collection.toml",
                      {parts_of_paper.begin(), parts_of_paper.end()});
  for (const std::string& part : parts_of_paper) {
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
// half-space or meshed block in hard contact, nominal pressures, and the
// solution at each load is saved.
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
    EXPECT_EQ(read.methods.front().name,
              part.starts_with("fe-") ? "fem" : "halfspace")
        << part;
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

TEST(ShippedCases, OfAdhesionAreApproachedAndParted) {
  for (const std::string& name : adhesive) {
    const Case read = shipped_case(name);

    EXPECT_TRUE(read.methods.back().is_adhesive()) << name;
    EXPECT_TRUE(read.load.is_unloading.back()) << name;
    EXPECT_FALSE(read.expectations.empty()) << name;
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

TEST(ShippedCases, ReadOtherSweepsInFullAndQuickly) {
  struct Expected {
    std::string name;
    std::size_t points, quick_points;
  };

  for (const Expected& expected :
       {Expected{"gamma", 64, 8}, {"adhesion-numbers", 7, 7}}) {
    const std::string folder = "cases/" + expected.name;
    const std::string file = folder + "/case.toml";
    EXPECT_EQ(read_sweep(file).points.size(), expected.points);
    EXPECT_EQ(read_sweep(file, quick_lines(folder)).points.size(),
              expected.quick_points);
    EXPECT_FALSE(read_reference(folder + "/reference.csv").empty());
    EXPECT_TRUE(std::filesystem::exists(folder + "/README.md"));
  }
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

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// No shipped case passes because its surfaces decide nothing.
TEST(ShippedCases, PassNothingUndecided) {
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator("cases"))
    if (entry.path().filename() == "case.toml") {
      EXPECT_EQ(text_of(entry.path()).find("if_undecided"), std::string::npos)
          << entry.path();
    }
}

TEST(ReadCase, TakesUndecidedForPassedWhereTheCaseSaysSo) {
  const std::string text = text_of("cases/polymer/case.toml");
  const std::string lenient = ", if_undecided = \"pass\" }";
  const std::size_t end = text.find(" }", text.find("gamma_matched = "));

  EXPECT_FALSE(read_case_text(text, "case.toml")
                   .expectations.front()
                   .passes_if_undecided);
  EXPECT_TRUE(
      read_case_text(std::string(text).replace(end, 2, lenient), "case.toml")
          .expectations.front()
          .passes_if_undecided);
}

} // namespace asperity::cases::shipped_cases_test
