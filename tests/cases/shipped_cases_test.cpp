// Tests of the folders in cases/: each is read without a mistake and is
// complete.
#include "input/reader/collection.hpp"
#include "input/reader/read_case.hpp"
#include "input/sweeps/sweep.hpp"
#include "input/types/reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace asperity::cases::shipped_cases_test {

namespace fs = std::filesystem;

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// The folders of all shipped cases, as "board/hertz". A user may keep more
/// cases beside them, without a README.md.
std::vector<std::string> shipped() {
  std::vector<std::string> folders;
  for (const auto& entry : fs::recursive_directory_iterator("cases"))
    if (entry.path().filename() == "case.toml" &&
        fs::exists(entry.path().parent_path() / "README.md"))
      folders.push_back(
          fs::relative(entry.path().parent_path(), "cases").string());
  std::ranges::sort(folders);
  return folders;
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

// A case is read in full and with its quick.set, under the name of its folder.
TEST(ShippedCases, AreReadInFullAndQuickly) {
  const std::vector<std::string> folders = shipped();

  EXPECT_GE(folders.size(), 72U);
  for (const std::string& name : folders) {
    const std::string file = "cases/" + name + "/case.toml";
    const std::vector<std::string> quick = quick_lines("cases/" + name);
    const std::string folder_name = fs::path(name).filename().string();
    if (is_sweep(file)) {
      EXPECT_EQ(read_sweep(file).name, folder_name);
      EXPECT_GT(read_sweep(file, quick).points.size(), 1U) << name;
    } else {
      EXPECT_EQ(read_case(file).name, folder_name);
      EXPECT_EQ(read_case(file, quick).name, folder_name);
    }
  }
  EXPECT_EQ(read_sweep("cases/gamma/case.toml").points.size(), 64U);
  EXPECT_EQ(read_sweep("cases/gamma/case.toml", quick_lines("cases/gamma"))
                .points.size(),
            8U);
  EXPECT_EQ(read_sweep("cases/sweep-hurst/case.toml").points.size(), 8U);
}

// A case has its claim, and the published numbers, unless none are published.
TEST(ShippedCases, HaveTheirClaimAndTheirReferences) {
  const std::set<std::string> without_numbers = {"adhesive-atoms",
                                                 "adhesive-rough",
                                                 "board/near-full-contact",
                                                 "cattaneo",
                                                 "challenge",
                                                 "conductance",
                                                 "hardness",
                                                 "paper/finite-size-2",
                                                 "paper/finite-size-4",
                                                 "peers/full-contact",
                                                 "plastic-rough",
                                                 "seal",
                                                 "board/self-affine-adhesive"};
  for (const std::string& name : shipped()) {
    const std::string folder = "cases/" + name;
    const std::string readme = text_of(folder + "/README.md");
    std::vector<std::string> words;
    if (name.find('/') != std::string::npos) // of a collection
      words = {"**Claim.**", "**Run.**"};
    if (words.size() > 0U && !name.starts_with("paper/"))
      words.emplace_back("**Shown.**");

    for (const std::string& word : words)
      EXPECT_NE(readme.find(word), std::string::npos) << name << word;
    if (!without_numbers.contains(name)) {
      EXPECT_FALSE(read_reference(folder + "/reference.csv").empty()) << name;
    }
  }
}

// A collection names all of its parts. A series of parts of the paper has the
// figures of its first.
TEST(ShippedCases, AreThePartsOfTheirCollections) {
  for (const std::string name : {"board", "paper", "peers"}) {
    std::vector<std::string> parts;
    for (const std::string& folder : shipped())
      if (folder.starts_with(name + "/"))
        parts.push_back(fs::path(folder).filename().string());
    const Collection collection =
        read_collection("cases/" + name + "/collection.toml", parts);

    EXPECT_EQ(collection.parts.size(), parts.size()) << name;
    for (const std::string& part : parts) {
      const bool has_figures =
          std::ranges::count(collection.figures, part, &ShownFigure::part) > 0;
      const bool is_later_of_series =
          part.starts_with("finite-size-") && part != "finite-size-1";
      if (name == "paper") {
        EXPECT_EQ(has_figures, !is_later_of_series) << part;
      }
    }
  }
}

// Each benchmark problem can be solved by other programs: one surface, one
// half-space or meshed block in hard contact, nominal pressures (a path of mean
// gaps with adhesion), and the solution at each load is saved.
TEST(ShippedCases, OfTheBoardCanBeSolvedByOthers) {
  for (const std::string& name : shipped()) {
    if (!name.starts_with("board/"))
      continue;
    const Case read = read_case("cases/" + name + "/case.toml");

    ASSERT_EQ(read.methods.size(), 1U) << name;
    EXPECT_EQ(read.methods.front().name,
              name.starts_with("board/fe-") ? "fem" : "halfspace")
        << name;
    const bool is_adhesive = name == "board/self-affine-adhesive";
    EXPECT_EQ(read.methods.front().is_adhesive(), is_adhesive) << name;
    EXPECT_EQ(read.load.control, is_adhesive
                                     ? mechanics::Control::mean_gap
                                     : mechanics::Control::nominal_pressure)
        << name;
    EXPECT_GE(read.report.fields, std::ssize(read.load.targets)) << name;
    EXPECT_EQ(read.surface.realizations, 1) << name;
    EXPECT_EQ(read.expectations.empty(),
              is_adhesive || name == "board/near-full-contact")
        << name; // no number is published
  }
}

TEST(ShippedCases, CompareMethodsOnFineGrids) {
  for (const std::string name :
       {"hertz", "layered", "polymer", "polymer-nominal", "self-affine",
        "wave-1d", "wave-2d"}) {
    const Case read = read_case("cases/" + name + "/case.toml");

    EXPECT_GE(read.methods.size(), 2U) << name;
    EXPECT_EQ(read.surface.points, 512) << name;
  }
}

TEST(ShippedCases, OfAdhesionAreApproachedAndParted) {
  for (const std::string name :
       {"adhesive-rough", "adhesive-sphere", "adhesive-wave", "adhesive-atoms",
        "challenge"}) {
    const Case read = read_case("cases/" + name + "/case.toml");

    EXPECT_TRUE(read.methods.back().is_adhesive()) << name;
    EXPECT_TRUE(read.load.is_unloading.back()) << name;
    EXPECT_FALSE(read.expectations.empty()) << name;
  }
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
