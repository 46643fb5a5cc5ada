// Tests of run/output_folder.hpp by the commands that write: what we wrote
// is replaced, what others wrote is refused before anything is touched, and no
// output is an input or anything but a regular file.
#include "results/result_reader.hpp"
#include "tests/program/program.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace asperity::program::own_outputs_test {

namespace fs = std::filesystem;

constexpr const char* foreign = "written by someone else\n";

class OwnOutputs : public ProgramTest {
protected:
  OwnOutputs() {
    write("small.toml", small_case);
    std::string text;
    for (int i = 0; i < 32 * 32; ++i)
      text += std::to_string(7 * i % 11) + (i % 32 == 31 ? "\n" : " ");
    write("map.txt", text);
  }

  /// A command that must end with exit code 2 and name the file, which stays.
  void expect_refused(const std::string& command, const std::string& file,
                      const std::string& words = "is there already") const {
    const Ended refused = run(command, "timeout 60");
    EXPECT_EQ(refused.exit_code, 2) << command << '\n' << refused.output;
    EXPECT_NE(refused.output.find(file), std::string::npos) << command << '\n'
                                                            << refused.output;
    EXPECT_NE(refused.output.find(words), std::string::npos) << command << '\n'
                                                             << refused.output;
  }

  void expect_good(const std::string& command) const {
    const Ended ended = run(command);
    EXPECT_TRUE(ended.exit_code == 0 || ended.exit_code == 1) << command << '\n'
                                                              << ended.output;
  }

  const std::string quick = "--methods halfspace --set surface.points=32 ";
  const std::string scale = " --length 1um --height-unit nm ";
};

TEST_F(OwnOutputs, FilesOfOthersAreRefusedByEveryCommand) {
  expect_good("run small.toml " + quick + "--no-report --out one");
  const std::pair<std::string, const char*> commands[] = {
      {"run small.toml " + quick + "--out f", "report.html"},
      {"run small.toml " + quick + "--out f", "curves.csv"},
      {"run small.toml " + quick + "--out f", "result.h5"},
      {"run small.toml " + quick + "--out f", "figures/cost.csv"},
      {"run small.toml " + quick + "--out f", "halfspace-0/block.vtu"},
      {"run small.toml " + quick + "--resume --out f", "result.journal"},
      {"run small.toml " + quick + "--out f", ".new-run/notes.txt"},
      {"check small.toml " + quick + "--out f", "summary.json"},
      {"report one --out f", "report.html"},
      {"report one one --out f", "comparison.json"},
      {"report one --figures svg --out f", "journal/mine.svg"},
      {"surface map.txt" + scale + "--out f", "surface.json"},
      {"problem small.toml --set surface.points=32 --out f", "case.toml"},
      {"problem small.toml --set surface.points=32 --out f", "README.md"},
      {"problem small.toml --set surface.points=32 --out f", "SHA256SUMS"},
      {"bench small.toml --quick --out f", "bench.csv"},
      {"bench small.toml --quick --out f", "runs/run-1/notes.txt"},
      {"robustness --instances 2 --out f", "stress.json"}};
  for (const auto& [command, name] : commands) {
    const fs::path file = folder / "f" / name;
    fs::remove_all(folder / "f");
    fs::create_directories(file.parent_path());
    write((fs::path("f") / name).string(), foreign);

    expect_refused(command, name);

    EXPECT_EQ(text_of(file), foreign) << command;
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "f"))
      files += entry.is_regular_file() ? 1 : 0;
    EXPECT_EQ(files, 1U) << command;
  }
}

TEST_F(OwnOutputs, OurFilesAreReplaced) {
  write("swept.toml",
        std::string(small_case) + "[sweep]\n\"surface.seed\" = [1, 2]\n");
  write("quick.toml",
        std::string(small_case) + "[expect]\nkappa = { above = 0.0 }\n");
  for (const std::string& command :
       {"run small.toml " + quick + "--no-cache --out a",
        "check quick.toml " + quick + "--no-cache --out a --junit v.xml",
        std::string("report a"), std::string("report a a --out b"),
        "surface map.txt" + scale + "--out c",
        "surface map.txt" + scale + "--no-report --write d.npy",
        "surface map.txt" + scale + "--no-report --write d.h5",
        std::string("problem small.toml --set surface.points=32 --out e"),
        std::string("robustness --instances 2 --out g"),
        "run swept.toml " + quick + "--out h", std::string("report h"),
        std::string("report h --out i")}) {
    expect_good(command);
    expect_good(command);
  }
}

TEST_F(OwnOutputs, AnEditedFileOfAProblemIsKept) {
  const std::string command =
      "problem small.toml --set surface.points=32 --out e";
  expect_good(command);
  write("e/README.md", foreign);

  expect_refused(command, "e/README.md");

  EXPECT_EQ(text_of(folder / "e/README.md"), foreign);
}

TEST_F(OwnOutputs, NoOutputIsAnInput) {
  expect_good("surface map.txt" + scale +
              "--no-report --level none "
              "--write m.npy");
  const std::string before = text_of(folder / "m.npy");
  fs::create_symlink("m.npy", folder / "link.npy");
  fs::create_hard_link(folder / "m.npy", folder / "hard.npy");
  for (const char* name : {"m.npy", "link.npy", "hard.npy", "./m.npy"})
    expect_refused("surface m.npy --length 1um --height-unit m --no-report "
                   "--write " +
                       std::string(name),
                   name);
  EXPECT_EQ(text_of(folder / "m.npy"), before);

  expect_refused("check small.toml --junit small.toml", "small.toml");
  EXPECT_EQ(text_of(folder / "small.toml"), small_case);

  expect_good("problem small.toml --set surface.points=32 --out e");
  expect_refused("problem e/case.toml --out e", "case.toml", "is read by");

  expect_good("run small.toml " + quick + "--out a");
  fs::remove(folder / "a/curves.csv");
  fs::rename(folder / "map.txt", folder / "a/curves.csv");
  expect_refused("run a/curves.csv --contact-modulus \"1 GPa\" --set "
                 "surface.length=1e-6 --set surface.height_unit=1e-9 --out a",
                 "a/curves.csv", "holds the input");
}

// Opening a pipe waits for its other end.
TEST_F(OwnOutputs, OnlyRegularFilesAreReplaced) {
  expect_good("run small.toml " + quick + "--out a");
  for (const char* name :
       {"report.html", "curves.csv", "summary.json", "methods.txt"}) {
    const fs::path file = folder / "a" / name;
    const std::string kept = text_of(file);
    const auto expect_all_refused = [&](const char* words) {
      for (const std::string command :
           {"report a", "run small.toml --resume --out a",
            "run small.toml --out a"})
        expect_refused(command + (command[1] == 'u' ? " " + quick : ""), name,
                       words);
      fs::remove(file);
    };
    fs::remove(file);
    ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
    expect_all_refused("is a pipe, but must be a regular file");
    fs::create_directory(file);
    expect_all_refused("is a folder, but must be a regular file");
    fs::create_symlink("../small.toml", file);
    expect_all_refused("is a symbolic link");
    write((fs::path("a") / name).string(), kept);
  }
  EXPECT_EQ(text_of(folder / "small.toml"), small_case);
  ASSERT_EQ(::mkfifo((folder / "pipe.npy").c_str(), 0600), 0);
  expect_refused("surface map.txt" + scale + "--write pipe.npy", "pipe.npy",
                 "is a pipe");
}

// The folder of a method's own files is emptied of these, and of nothing else.
TEST_F(OwnOutputs, FilesOfTheUserStayBesideThoseOfAMethod) {
  const std::string block =
      "run small.toml --methods fem --set surface.points=32 --set "
      "fem.solver=full --set fem.growth=2.0 --set report.vtu=true --no-report "
      "--out a";
  expect_good(block);
  ASSERT_TRUE(fs::exists(folder / "a/fem-0/block.pvd"));
  fs::create_directories(folder / "a/fem-0/mine");
  for (const char* name : {"a/fem-0/notes.txt", "a/fem-0/block.vtu.txt",
                           "a/fem-0/mine/block_0000.vtu"})
    write(name, foreign);

  expect_good("run small.toml " + quick + "--no-report --out a");

  std::set<std::string> left;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "a/fem-0"))
    if (entry.is_regular_file())
      left.insert(entry.path().lexically_relative(folder / "a/fem-0"));
  EXPECT_EQ(left, (std::set<std::string>{"notes.txt", "block.vtu.txt",
                                         "mine/block_0000.vtu"}));
}

TEST_F(OwnOutputs, TheFolderOfAMethodGoesWithItsFiles) {
  const std::string atoms =
      "--methods md --set md.dump=true --no-report --out a";
  fs::copy_file(ASPERITY_CASES "/md-small/case.toml", folder / "atoms.toml");
  expect_good("run atoms.toml --quick " + atoms);
  ASSERT_TRUE(fs::exists(folder / "a/md-0/step-0000.xyz"));

  expect_good("run small.toml " + quick + "--no-report --out a");

  EXPECT_FALSE(fs::exists(folder / "a/md-0"));
}

// A folder "points" of the user is not that of a sweep.
TEST_F(OwnOutputs, ResultsThatTheUserPutsBesideOursStay) {
  ASSERT_EQ(run("run small.toml --no-report --out f").exit_code, 0);
  fs::create_directories(folder / "f/points/mine");
  for (const char* name : {"result.h5", "curves.csv"})
    fs::copy(folder / "f/result.h5", folder / "f/points/mine" / name);
  ASSERT_EQ(run("run small.toml --no-report --out f").exit_code, 0);
  for (const char* name : {"result.h5", "curves.csv"})
    EXPECT_TRUE(fs::exists(folder / "f/points/mine" / name)) << name;
}

TEST_F(OwnOutputs, ALockFileOfOthersIsNotOverwritten) {
  fs::create_directory(folder / "a");
  write("a/.lock", foreign);

  expect_refused("run small.toml " + quick + "--out a", "a/.lock");

  EXPECT_EQ(text_of(folder / "a/.lock"), foreign);
}

} // namespace asperity::program::own_outputs_test
