// Several measured maps in one command: what is read of a folder, what a
// refusal leaves, and how the maps are shared.
#include "tests/program/program.hpp"

#include <fmt/format.h>

#include <sys/stat.h>

namespace asperity::program::maps_test {

namespace fs = std::filesystem;

class Maps : public ProgramTest {
protected:
  Maps() {
    fs::create_directories(folder / "maps");
    for (int map = 1; map <= 2; ++map)
      write(fmt::format("maps/{}.txt", map), map_text(map));
  }

  static std::string map_text(int number) {
    std::string text = "# Channel: Z\n# Width: 4 um\n# Height: 4 um\n"
                       "# Value units: m\n";
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i)
        text += fmt::format("{}e-9{}", (3 * i + 5 * j + number * i * j) % 7,
                            i == 7 ? "\n" : " ");
    return text;
  }

  Ended press(const std::string& words) const {
    return run("run " + words + " --contact-modulus '2 GPa'");
  }

  void expect_refusal(const Ended& ended, const std::string& words) const {
    EXPECT_EQ(ended.exit_code, 2) << ended.output;
    EXPECT_NE(ended.output.find(words), std::string::npos) << ended.output;
  }
};

TEST_F(Maps, ARefusedRunLeavesNothing) {
  write("maps/notes.txt", "measured in 2024\n");
  expect_refusal(press("maps --out o"), "notes.txt:1");
  EXPECT_FALSE(fs::exists(folder / "o"));
  expect_refusal(press("maps --out o --part 1/2"), "notes.txt:1");
  EXPECT_FALSE(fs::exists(folder / "o"));
  fs::remove(folder / "maps/notes.txt");

  const Ended ended = press("maps --out o");

  EXPECT_EQ(ended.exit_code, 0) << ended.output;
  EXPECT_TRUE(fs::exists(folder / "o/maps.toml"));
  EXPECT_TRUE(fs::exists(folder / "o/points/001/report.html"));
}

TEST_F(Maps, ARefusedPartLeavesNothing) {
  expect_refusal(press("maps/1.txt --out o --part 1/1 --set "
                       "halfspace.contact=exponential --set "
                       "halfspace.work_of_adhesion=50 --set "
                       "halfspace.range=1e-12"),
                 "halfspace.range");
  EXPECT_FALSE(fs::exists(folder / "o"));
}

TEST_F(Maps, AreNotMixedWithResults) {
  for (int repeat = 0; repeat < 2; ++repeat)
    expect_refusal(press("maps --out maps/"), "is the folder of the maps");
  for (const fs::path& entry : fs::directory_iterator(folder / "maps"))
    EXPECT_EQ(entry.extension(), ".txt") << entry;
}

TEST_F(Maps, CaseFilesAndFoldersAmongThemAreLeftOutWithAWarning) {
  write("maps/note.toml", "schema = 1\n");
  fs::create_directories(folder / "maps/raw");

  const Ended ended = press("maps --dry-run");

  EXPECT_EQ(ended.exit_code, 0) << ended.output;
  EXPECT_NE(ended.output.find("2 points, "), std::string::npos) << ended.output;
  for (const char* left_out : {"maps/note.toml", "maps/raw"})
    EXPECT_NE(ended.output.find(left_out), std::string::npos) << ended.output;
}

TEST_F(Maps, NoEntryIsLostWithoutAWord) {
  fs::create_symlink("nowhere", folder / "maps/3.txt");
  expect_refusal(press("maps --dry-run"),
                 "maps/3.txt: is a link to a file that does not exist");
  expect_refusal(press("maps/3.txt --dry-run"),
                 "maps/3.txt: is a link to a file that does not exist");
  fs::remove(folder / "maps/3.txt");
  ASSERT_EQ(mkfifo((folder / "maps/3.txt").c_str(), 0600), 0);
  expect_refusal(press("maps --dry-run"),
                 "maps/3.txt: is a pipe, but must be a regular file");
  fs::remove(folder / "maps/3.txt");
  for (const char* name : {"maps/1.txt", "maps/2.txt"})
    fs::remove(folder / name);
  expect_refusal(press("maps --dry-run"), "maps: is a folder without maps");
}

// The case file of maps is written when they run, so that no refusal names it.
TEST_F(Maps, NoRefusalNamesTheCaseThatIsMadeForThem) {
  for (const std::string words : {"maps", "maps/1.txt"})
    for (const std::string wrong :
         {"--methods md", "--set halfspace.thickness=-1",
          "--set fem={} --methods fem --set fem.depth=1e-12"}) {
      const Ended ended = press(words + " --dry-run " + wrong);
      EXPECT_EQ(ended.exit_code, 2) << ended.output;
      EXPECT_EQ(ended.output.find("maps.toml"), std::string::npos)
          << ended.output;
      EXPECT_EQ(ended.output.find("maps/1:"), std::string::npos)
          << ended.output;
    }
}

// E* h' of these maps is some 10 MPa.
TEST_F(Maps, AreNotPressedBeyondTheirHardness) {
  for (const std::string words : {"maps/1.txt --out one", "maps --out all"}) {
    const Ended ended = press(words + " --hardness '5 MPa'");
    EXPECT_EQ(ended.exit_code, 0) << ended.output;
  }

  for (const char* csv : {"one/curves.csv", "all/points/000/curves.csv"}) {
    auto columns = columns_of(text_of(folder / csv), "halfspace");
    const std::vector<std::string>& loads = columns["nominal_pressure [Pa]"];
    ASSERT_EQ(loads.size(), 12U) << csv;
    EXPECT_GT(std::stod(loads.back()), 2e6); // the other map may be steeper
    EXPECT_LT(std::stod(loads.back()), 5e6);
  }
}

TEST_F(Maps, PartsJoinToTheUndividedRun) {
  ASSERT_EQ(press("maps --out whole/maps").exit_code, 0);
  for (const char* part : {"2/2", "1/2"}) {
    const Ended ended =
        press("maps --out parts/maps --no-cache --part " + std::string(part));
    EXPECT_EQ(ended.exit_code, 0) << ended.output;
  }

  const Ended merged = run("merge parts/maps");

  EXPECT_EQ(merged.exit_code, 0) << merged.output;
  for (const char* name : {"sweep.csv", "sweep.json", "maps.toml"})
    EXPECT_EQ(text_of(folder / "parts/maps" / name),
              text_of(folder / "whole/maps" / name))
        << name;
  EXPECT_TRUE(fs::exists(folder / "parts/maps/points/001/report.html"));
  const Ended again = run("run parts/maps/maps.toml --out parts/maps");
  EXPECT_EQ(again.exit_code, 0) << again.output;
}

TEST_F(Maps, ArePlannedForSlurmAndRunInTheSameFolder) {
  const Ended planned =
      run("plan maps --contact-modulus '2 GPa' --slurm --out o");
  EXPECT_EQ(planned.exit_code, 0) << planned.output;
  EXPECT_NE(text_of(folder / "o/slurm/parts.sh").find("o/maps.toml"),
            std::string::npos);

  EXPECT_EQ(press("maps --out o").exit_code, 0);
}

} // namespace asperity::program::maps_test
