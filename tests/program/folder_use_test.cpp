// Tests of the folder of a run: one writer at a time, nothing of an earlier run
// is attributed to the new one, and a disk error is exit code 4 and loses
// nothing that was finished.
#include "results/result_reader.hpp"
#include "tests/program/program.hpp"
#include "tests/same_bits.hpp"

#include <fstream>
#include <future>
#include <map>
#include <set>
#include <thread>
#include <unistd.h>

namespace asperity::program::folder_use_test {

namespace fs = std::filesystem;
using results::Result;

class FolderUse : public ProgramTest {
protected:
  FolderUse() { write("small.toml", small_case); }

  Result result(const std::string& name) const {
    return results::read_result(folder / name);
  }

  /// The program in parallel with another one; its output goes to a separate
  /// file.
  int run_beside(const std::string& arguments, const std::string& log) const {
    const std::string command = "cd " + folder.string() +
                                " && ASPERITY_CACHE=cache " ASPERITY_PROGRAM
                                " " +
                                arguments + " > " + log + " 2>&1";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  /// The output of the program, followed by "exit CODE", where no file may have
  /// more than this number of KiB.
  std::string with_small_files(const std::string& arguments, int kibibytes) {
    const std::string command = "cd " + folder.string() +
                                " && { ASPERITY_CACHE=cache bash -c 'ulimit "
                                "-f " +
                                std::to_string(kibibytes) +
                                "; exec " ASPERITY_PROGRAM " " + arguments +
                                "'; echo exit $?; } 2>&1 | cat > log.txt";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return text_of(folder / "log.txt");
  }

  std::size_t rows(const std::string& name) const {
    std::size_t rows = 0;
    for (const results::MethodRecord& method : result(name).methods)
      for (const results::Curve& curve : method.realizations)
        rows += curve.points.size();
    return rows;
  }
};

// The theory once, half-space and fem on two realisations, four loads each.
constexpr std::size_t all_rows = 4 + 2 * 4 + 2 * 4;

/// A run whose output has every kind of file.
const char* const reported = "run small.toml --methods theory --out one";

// Of two runs that begin at once, with other heights, one refuses or follows
// the other; the file always belongs to one run. The second one waits half a
// second for the folder, and on a busy machine they may begin that far apart.
TEST_F(FolderUse, TwoRunsAtOnceLeaveOneResult) {
  int n_refused = 0;
  const std::string one = "run small.toml --set surface.points=256 --no-cache "
                          "--no-report --out one";
  for (int trial = 0; trial < 3; ++trial) {
    auto other = std::async(std::launch::async, [&] {
      return run_beside(one + " --set surface.seed=4", "other.txt");
    });
    const int here = run_beside(one, "here.txt");
    const int there = other.get();

    EXPECT_TRUE(here == 0 || there == 0) << here << ' ' << there;
    for (const auto& [end, log] :
         {std::pair(here, "here.txt"), std::pair(there, "other.txt")})
      if (end != 0) {
        ++n_refused;
        EXPECT_EQ(end, 2);
        EXPECT_NE(text_of(folder / log)
                      .find("one is in use by run small ("
                            "process "),
                  std::string::npos)
            << text_of(folder / log);
      }
    EXPECT_EQ(rows("one"), all_rows);
    EXPECT_EQ(result("one").status, "complete");
  }
  EXPECT_GT(n_refused, 0);
}

TEST_F(FolderUse, EveryCommandThatWritesIsRefused) {
  ASSERT_EQ(run("run small.toml --methods theory --no-report --out out/small")
                .exit_code,
            0);
  fs::create_directories(folder / "out/small/bench");
  auto holder = std::async(std::launch::async, [&] {
    return std::system(("cd " + folder.string() +
                        " && flock out/small/.lock flock "
                        "out/small/bench/.lock sh -c "
                        "'touch held; while [ ! -e done ]; do sleep 0.1; "
                        "done'")
                           .c_str());
  });
  while (!fs::exists(folder / "held"))
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  for (const char* command :
       {"run small.toml", "run small.toml --resume", "check small.toml",
        "report out/small", "bench small.toml --quick"}) {
    const Ended refused = run(command);
    EXPECT_EQ(refused.exit_code, 2) << command << refused.output;
    EXPECT_NE(refused.output.find("is in use by"), std::string::npos)
        << command << refused.output;
  }
  EXPECT_EQ(run("report out/small --out elsewhere").exit_code, 0);
  std::ofstream(folder / "done") << "the holder ends\n";
  holder.get();
  EXPECT_EQ(rows("out/small"), 4U);
}

TEST_F(FolderUse, ANewRunLeavesNothingOfTheLast) {
  ASSERT_EQ(run("run small.toml --methods fem --out one").exit_code, 0);
  fs::create_directories(folder / "one/fem-0");
  std::ofstream(folder / "one/fem-0/block.vtu") << "of the last run";
  std::ofstream(folder / "one/notes.txt") << "the user's";
  std::ofstream(folder / "one/figures/mine.png") << "the user's";

  ASSERT_EQ(
      run("run small.toml --no-report --methods halfspace --out one").exit_code,
      0);

  std::set<std::string> left;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "one"))
    if (entry.is_regular_file())
      left.insert(entry.path().filename().string());
  EXPECT_EQ(left,
            (std::set<std::string>{"mine.png", "notes.txt", "result.h5"}));
  EXPECT_TRUE(fs::exists(folder / "one/figures/mine.png"));
}

// The full block of the second run is refused when its cells are assembled: the
// factor is negative at the centres of the first layer only, which no check
// before the run examines. The theory is computed before.
class RefusedRun : public FolderUse {
protected:
  static constexpr const char* hidden = "one/.new-run/";

  const std::string refused_late =
      "run small.toml --no-cache --out one --set surface.points=16 --set "
      "fem.contact=hard --set fem.solver=full --set fem.surface_cell_depth=0.7 "
      "--set 'material.variation={ kind = \"function\", factor = \"1 - 2 * "
      "(abs(z - 0.04375) < 1e-6)\" }' --set surface.wavelength_short=\"4 h\"";

  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> texts;
    if (fs::exists(folder / "one"))
      for (const auto& entry : fs::recursive_directory_iterator(folder / "one"))
        if (entry.is_regular_file())
          texts[fs::relative(entry.path(), folder).string()] =
              text_of(entry.path());
    return texts;
  }
};

TEST_F(RefusedRun, LeavesTheOutputOfTheLastOne) {
  ASSERT_EQ(run(reported).exit_code, 0);
  fs::create_directories(folder / "one/fem-0");
  std::ofstream(folder / "one/fem-0/block.vtu") << "of the last run";
  const auto before = files();

  const Ended refused = run(refused_late);

  EXPECT_EQ(refused.exit_code, 2) << refused.output;
  EXPECT_NE(refused.output.find("factor of the modulus"), std::string::npos)
      << refused.output;
  auto after = files();
  std::erase_if(after, [](const auto& file) { // steps of the theory
    return file.first.starts_with(hidden);
  });
  EXPECT_EQ(after, before);
}

// So does one that a full disk, here a limit on the size of a file, ends while
// it writes its report.
TEST_F(RefusedRun, LikeAFullDiskTouchesNoFileOfTheLastOne) {
  ASSERT_EQ(run(reported).exit_code, 0);
  auto before = files();

  const Ended full = run(reported, "bash -c 'ulimit -f 32; exec \"$@\"' -");

  EXPECT_EQ(full.exit_code, 4);
  EXPECT_NE(full.output.find(std::string(hidden)), std::string::npos)
      << full.output;
  for (const auto& [path, text] : files())
    EXPECT_TRUE(path.starts_with(hidden) || before.at(path) == text) << path;
}

// A killed run has touched nothing of the last one, and replaces it when it is
// resumed.
TEST_F(RefusedRun, LikeAKilledOneTouchesNoFileOfTheLastOne) {
  ASSERT_EQ(run(reported).exit_code, 0);
  const auto before = files();
  const std::string large =
      "run small.toml --set surface.points=128 --no-cache --no-report "
      "--out one ";
  ASSERT_EQ(run(large, "timeout -s KILL 0.4").exit_code, 137);
  for (const auto& [path, text] : before)
    EXPECT_TRUE(text_of(folder / path) == text) << path;

  EXPECT_EQ(run(large + "--resume").exit_code, 0);

  EXPECT_EQ(result("one").surfaces.front().grid.points_x, 128);
  EXPECT_EQ(rows("one"), all_rows);
  EXPECT_FALSE(fs::exists(folder / hidden));
}

// What a kill has left while a complete output replaced the last one follows
// with the next command.
TEST_F(RefusedRun, LikeAKillWhileItReplacesLosesNothing) {
  const std::string run_small = "run small.toml --no-report --methods ";
  ASSERT_EQ(run(run_small + "theory --out one").exit_code, 0);
  ASSERT_EQ(run(run_small + "halfspace --out two").exit_code, 0);
  const Result newer = result("two");
  fs::rename(folder / "two", folder / hidden);
  fs::remove(folder / hidden / ".lock");
  ASSERT_EQ(run(run_small + "halfspace --resume --out one").exit_code, 0);
  tests::expect_same_bits(newer, result("one"));

  fs::create_directories(folder / hidden / "fem-0");
  std::ofstream(folder / hidden / "fem-0/block.vtu") << "of the result";
  ASSERT_EQ(run("run small.toml --resume --no-report --out one").exit_code, 0);
  EXPECT_EQ(text_of(folder / "one/fem-0/block.vtu"), "of the result");
  EXPECT_FALSE(fs::exists(folder / hidden));
}

TEST_F(RefusedRun, LeavesNoResultOfItsOwn) {
  const Ended refused = run(refused_late + " --methods fem");

  EXPECT_EQ(refused.exit_code, 2) << refused.output;
  EXPECT_EQ(files(), (std::map<std::string, std::string>{}));
}

// A result that continued after its map changed would contain rows of two maps.
TEST_F(FolderUse, ResumeRefusesAChangedMap) {
  const auto write_map = [&](double last) {
    std::string text;
    for (int i = 0; i < 64; ++i)
      text += std::to_string(i == 63 ? last : 1e-2 * (7 * i % 11)) +
              (i % 8 == 7 ? "\n" : " ");
    write("map.txt", text);
  };
  const std::string map_case = std::string(small_case)
                                   .replace(0, small_case.find("[material]"),
                                            "schema = 1\ntitle = \"map\"\n"
                                            "[surface]\nkind = \"measured\"\n"
                                            "file = \"map.txt\"\n"
                                            "length = \"1 um\"\n"
                                            "height_unit = \"1 um\"\n"
                                            "level = \"none\"\n"
                                            "edges = \"periodic\"\n");
  write("map.toml", map_case);
  write_map(0.02);
  const Ended first =
      run("run map.toml --methods halfspace --no-report --out one");
  ASSERT_EQ(first.exit_code, 0) << first.output;
  const Result before = result("one");

  write_map(0.03);
  const Ended refused = run("run map.toml --resume --no-report --out one");

  EXPECT_EQ(refused.exit_code, 2) << refused.output;
  EXPECT_NE(
      refused.output.find(
          "the file given by surface.file has different content (SHA-256 "),
      std::string::npos)
      << refused.output;
  tests::expect_same_bits(before, result("one"));
  write_map(0.02);
  EXPECT_EQ(run("run map.toml --resume --no-report --out one").exit_code, 0);
}

/// A shell that limits the size of files to this number of KiB, as a full disk
/// would.
std::string with_limit(int kibibytes) {
  return "bash -c 'ulimit -f " + std::to_string(kibibytes) +
         "; exec \"$0\" \"$@\"'";
}

TEST_F(FolderUse, AFullDiskIsAnErrorAndLosesNothing) {
  const std::string run_it = "run small.toml --no-cache --no-report --out one";
  ASSERT_EQ(run(run_it).exit_code, 0);
  const Result whole = result("one");

  const Ended full = run(run_it + " --methods halfspace,fem", with_limit(60));

  EXPECT_EQ(full.exit_code, 4) << full.output;
  EXPECT_TRUE(fs::exists(folder / "one/.new-run/result.h5"));
  EXPECT_NE(full.output.find("asperity: "), std::string::npos) << full.output;
  EXPECT_NE(full.output.find("one/"), std::string::npos) << full.output;
  tests::expect_same_bits(whole, result("one"));

  const Ended done = run(run_it + " --resume");
  ASSERT_EQ(done.exit_code, 0) << done.output;
  tests::expect_same_bits(whole, result("one"));
}

/// A map of 32 x 32 points, of which none is flat.
std::string matrix() {
  std::string text;
  for (int i = 0; i < 32 * 32; ++i)
    text += std::to_string(7 * i % 11) + (i % 32 == 31 ? "\n" : " ");
  return text;
}

// The limit takes effect at the head of a file, in the middle, or when the last
// changes are written.
TEST_F(FolderUse, AWriteThatFailsAnywhereIsAnErrorThatNamesTheFile) {
  write("map.txt", matrix());
  const std::string run_it =
      "run small.toml --methods halfspace --no-cache --no-report --out one";
  ASSERT_EQ(run(run_it + " --set surface.points=32").exit_code, 0);
  const Result whole = result("one");
  const auto expect_error = [&](const std::string& arguments, int limit,
                                const std::string& file) {
    const std::string output = with_small_files(arguments, limit);
    EXPECT_NE(output.find("exit 4"), std::string::npos) << limit << output;
    EXPECT_NE(output.find("File too large"), std::string::npos)
        << limit << output;
    EXPECT_NE(output.find(file), std::string::npos) << limit << output;
  };
  for (const int limit : {0, 2, 16, 200})
    expect_error(run_it, limit, "one/");
  tests::expect_same_bits(whole, result("one"));

  const std::string convert = "surface map.txt --length 1um --height-unit nm "
                              "--no-report --write ";
  for (const char* ending : {"h5", "npy", "gwy", "txt"})
    for (const int limit : {0, 4}) {
      const std::string file = std::string("copy.") + ending;
      expect_error(convert + file, limit, file);
      EXPECT_FALSE(fs::exists(folder / file)) << ending;
    }
}

// Otherwise a file that is opened gets the number of standard error, and text
// for the terminal is written into it.
TEST_F(FolderUse, ClosedDescriptorsChangeNothing) {
  const std::string program = "cd " + folder.string() +
                              " && ASPERITY_CACHE=cache " ASPERITY_PROGRAM " ";
  const auto exit_code = [&](const std::string& command) {
    const int status = std::system((program + command).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  };
  for (const auto& [command, expected] :
       {std::pair{"list", 0},
        {"describe small.toml", 0},
        {"run small.toml --methods halfspace --no-cache --out one", 0},
        {"certify one", 0},
        {"diff one one", 0},
        {"run no-such-case", 2}})
    EXPECT_EQ(exit_code(std::string(command) + " <&- >&- 2>&-"), expected)
        << command;
  EXPECT_EQ(result("one").status, "complete");
  EXPECT_EQ(exit_code("run no-such-case > /dev/full 2> /dev/full"), 2);
}

TEST_F(FolderUse, AFileInPlaceOfAFolderIsNamed) {
  write("file", "no folder");

  const Ended refused = run("run small.toml --out file/one");

  EXPECT_EQ(refused.exit_code, 2) << refused.output;
  EXPECT_NE(refused.output.find("file is a file, not a folder; name another"),
            std::string::npos)
      << refused.output;
}

// As another user, because root may write everywhere.
TEST_F(FolderUse, AReadOnlyFolderIsAnErrorAndLosesNothing) {
  if (std::system("setpriv --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "skipped: needs util-linux";
  ASSERT_EQ(run("run small.toml --no-report --out one").exit_code, 0);
  const Result before = result("one");
  fs::permissions(folder, fs::perms::owner_all | fs::perms::others_read |
                              fs::perms::others_exec);
  const std::string as_nobody =
      ::geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups"
                       : "";
  if (::geteuid() != 0)
    fs::permissions(folder / "one",
                    fs::perms::owner_read | fs::perms::owner_exec);

  const Ended refused = run("run small.toml --no-cache --out one", as_nobody);

  fs::permissions(folder / "one", fs::perms::owner_all);
  EXPECT_EQ(refused.exit_code, 4) << refused.output;
  EXPECT_NE(refused.output.find("cannot write one/.lock"), std::string::npos)
      << refused.output;
  tests::expect_same_bits(before, result("one"));
}

TEST_F(FolderUse, OutputThatCannotBeWrittenIsAnError) {
  const std::string command = ASPERITY_PROGRAM " list > /dev/full 2>/dev/null";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 4);
}

TEST_F(FolderUse, AnInterruptedCheckStillWritesJunit) {
  write("quick.toml",
        std::string(small_case) + "[expect]\nkappa = { above = 0.0 }\n");
  const Ended done =
      interrupt("check quick.toml small.toml --no-cache --junit verdicts.xml "
                "--set surface.points=512",
                "out/quick/.lock");

  EXPECT_EQ(done.exit_code, 130) << done.output;
  const std::string xml = text_of(folder / "verdicts.xml");
  EXPECT_NE(xml.find("</testsuites>"), std::string::npos) << xml;
  EXPECT_NE(xml.find("interrupted"), std::string::npos) << xml;
}

// Maps of a command or of a folder are the points of one sweep, each with a
// report of its own; two of one name keep their results.
TEST_F(FolderUse, SeveralMapsHaveOneReportAndTheirOwn) {
  for (const char* name :
       {"s1/heights.txt", "s2/heights.txt", "s2/other.txt"}) {
    fs::create_directories((folder / name).parent_path());
    std::string map = "# Channel: Height\n# Width: 8 um\n# Height: 8 um\n"
                      "# Value units: m\n";
    for (int i = 0; i < 16; ++i)
      for (int j = 0; j < 16; ++j)
        map += std::to_string((i * i * (name[1] + name[3]) + j * 3) % 5) +
               (j < 15 ? "e-9 " : "e-9\n");
    write(name, map);
  }
  const std::string modulus = " --contact-modulus '2 GPa' ";

  const Ended ended =
      run("run s1/heights.txt s2/heights.txt --no-report" + modulus);

  EXPECT_EQ(ended.exit_code, 0) << ended.output;
  EXPECT_NE(ended.output.find("surface.file = \"s1/heights.txt\""),
            std::string::npos)
      << ended.output;
  EXPECT_NE(result("out/maps/points/000").surfaces.front().heights,
            result("out/maps/points/001").surfaces.front().heights);
  EXPECT_FALSE(fs::exists(folder / "out/maps/points/000/report.html"));

  ASSERT_EQ(run("run s2" + modulus).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "out/s2/points/001/report.html"));
  const std::string page = text_of(folder / "out/s2/report.html");
  for (const char* words :
       {"Over the samples", "heights.txt", "other.txt", "data:image/svg+xml",
        "<a href=\"points/001/report.html\">"})
    EXPECT_NE(page.find(words), std::string::npos) << words;

  // The case file of the sweep runs by itself, and again over its own output.
  EXPECT_EQ(run("run out/s2/maps.toml --no-report --out again").exit_code, 0);
  EXPECT_EQ(run("run s2 --no-report" + modulus).exit_code, 0);
  fs::create_directories(folder / "out/mine");
  write("out/mine/maps.toml", "# not ours\n");
  EXPECT_EQ(run("run s2 --out out/mine" + modulus).exit_code, 2);
  EXPECT_EQ(text_of(folder / "out/mine/maps.toml"), "# not ours\n");
}

// Two cases of one name in different folders.
TEST_F(FolderUse, CasesOfOneNameHaveFoldersOfTheirOwn) {
  for (const char* name : {"s1", "s2", "a/s1"}) {
    fs::create_directories(folder / name);
    fs::copy_file(folder / "small.toml", folder / name / "small.toml");
  }

  const Ended ended =
      run("run s1/small.toml s2/small.toml --methods theory --no-report");

  EXPECT_EQ(ended.exit_code, 0) << ended.output;
  EXPECT_EQ(result("out/s1-small").case_name, "s1-small");
  EXPECT_EQ(result("out/s2-small").case_name, "s2-small");

  const Ended refused = run("run s1/small.toml a/s1/small.toml --no-report");
  EXPECT_EQ(refused.exit_code, 2) << refused.output;
  EXPECT_NE(refused.output.find("s1/small.toml and a/s1/small.toml would be "
                                "written into one folder, s1-small"),
            std::string::npos)
      << refused.output;
}

// Figures for a journal that somebody has edited outlive a new run; others
// do not.
TEST_F(FolderUse, ARunKeepsEditedFigures) {
  const std::string run_small = std::string(reported) + " --no-report";
  const fs::path journal = folder / "one/journal";
  const fs::path kept = folder / "one/journal.edited";
  ASSERT_EQ(run(run_small).exit_code, 0);
  ASSERT_EQ(run("report one --figures svg").exit_code, 0);
  ASSERT_EQ(run(run_small + " --set theory.gamma=0.5").exit_code, 0);
  EXPECT_FALSE(fs::exists(journal) || fs::exists(kept));

  ASSERT_EQ(run("report one --figures svg").exit_code, 0);
  write("one/journal/pressure-gap.gp", "set title 'mine'\n");
  ASSERT_EQ(run(run_small + " --set theory.gamma=0.6").exit_code, 0);
  EXPECT_FALSE(fs::exists(journal));
  EXPECT_EQ(text_of(kept / "pressure-gap.gp"), "set title 'mine'\n");

  ASSERT_EQ(run("report one --figures svg").exit_code, 0);
  write("one/journal/pressure-gap.gp", "set title 'again'\n");
  ASSERT_EQ(run("report one --figures svg").exit_code, 0);
  EXPECT_TRUE(fs::exists(journal / "pressure-gap.svg"));
  EXPECT_EQ(text_of(folder / "one/journal.edited-2/pressure-gap.gp"),
            "set title 'again'\n");
}

} // namespace asperity::program::folder_use_test
