// Tests of md/lammps/lammps_run.hpp: LAMMPS is found along PATH or its package
// is named, and its own error message is reported. Tests that need the program
// are skipped where the Debian package lammps is not installed.
#include "base/child_process.hpp"
#include "input/input_error.hpp"
#include "md/lammps/lammps_run.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <unistd.h>

namespace asperity::md::lammps_run_test {

class LammpsRunTest : public testing::Test {
protected:
  LammpsRunTest() {
    std::filesystem::create_directories(folder);
    path = std::getenv("PATH");
  }

  ~LammpsRunTest() override {
    ::setenv("PATH", path.c_str(), 1);
    std::filesystem::remove_all(folder);
  }

  void write(const char* name, const std::string& text) const {
    std::ofstream(folder / name) << text;
  }

  std::string refusal(int ranks) const {
    return tests::message_of<input::InputError>(
        [&] { find_lammps(ranks, folder); });
  }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("asperity-lammps-run-" + std::to_string(::getpid()));
  std::string path;
};

#define NEEDS_LAMMPS()                                                         \
  if (program_on_path("lmp").empty())                                          \
  GTEST_SKIP() << "skipped: needs lammps"

TEST_F(LammpsRunTest, NamesThePackageOfAMissingProgram) {
  ::setenv("PATH", folder.c_str(), 1);

  EXPECT_EQ(refusal(1), "[md] engine = \"lammps\" needs the program lmp; "
                        "install the Debian package lammps");

  write("lmp", "#!/bin/sh\necho I am another lmp\n");
  std::filesystem::permissions(folder / "lmp", std::filesystem::perms::all);
  EXPECT_NE(refusal(2).find("mpirun"), std::string::npos) << refusal(2);
  EXPECT_NE(refusal(1).find("does not print a LAMMPS version"),
            std::string::npos)
      << refusal(1);
}

// LAMMPS must not see an MPI that this process has started, or it would regard
// itself as one of its ranks.
TEST_F(LammpsRunTest, IsIndependentOfAnMpiOfThisProcess) {
  ::setenv("PMIX_RANK", "0", 1);
  ::setenv("OMPI_COMM_WORLD_SIZE", "7", 1);
  ::setenv("ASPERITY_SEEN", "yes", 1);
  write("lmp", "#!/bin/sh\n"
               "echo \"$PMIX_RANK$OMPI_COMM_WORLD_SIZE$ASPERITY_SEEN\"\n"
               "exit 3\n");
  std::filesystem::permissions(folder / "lmp", std::filesystem::perms::all);

  const LammpsRun run =
      run_lammps({folder / "lmp", {}, 1, {}}, folder, "in", "log");

  EXPECT_EQ(run.note, "LAMMPS ended with exit code 3: yes (see " +
                          (folder / "log").string() + ")");
  ::unsetenv("PMIX_RANK");
  ::unsetenv("OMPI_COMM_WORLD_SIZE");
  ::unsetenv("ASPERITY_SEEN");
}

// Ranks that spin while they wait take whole time slices from the rank that
// they wait for, once other work shares the cores.
TEST_F(LammpsRunTest, RanksThatWaitYieldTheirCore) {
  write("lmp", "#!/bin/sh\necho \"$OMPI_MCA_mpi_yield_when_idle\"\nexit 3\n");
  std::filesystem::permissions(folder / "lmp", std::filesystem::perms::all);

  const LammpsRun run =
      run_lammps({folder / "lmp", {}, 1, {}}, folder, "in", "log");

  EXPECT_EQ(run.note, "LAMMPS ended with exit code 3: 1 (see " +
                          (folder / "log").string() + ")");
}

TEST_F(LammpsRunTest, VersionIsADate) {
  NEEDS_LAMMPS();

  const std::string version = find_lammps(1, folder).version;

  ASSERT_FALSE(version.empty());
  EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(version[0]))) << version;
}

TEST_F(LammpsRunTest, FailureHasTheMessageOfLammps) {
  NEEDS_LAMMPS();
  write("wrong.in", "units metal\natom_style no_such_style\n");

  const LammpsRun run =
      run_lammps(find_lammps(1, folder), folder, "wrong.in", "wrong.log");

  EXPECT_FALSE(run.finished);
  EXPECT_NE(run.note.find("ERROR: Unrecognized atom style 'no_such_style'"),
            std::string::npos)
      << run.note;
  EXPECT_NE(run.note.find((folder / "wrong.log").string()), std::string::npos)
      << run.note;
}

TEST_F(LammpsRunTest, IsStoppedOnRequest) {
  NEEDS_LAMMPS();
  write("long.in", "units metal\nshell sleep 1000\n");
  int questions = 0;

  const LammpsRun run =
      run_lammps(find_lammps(1, folder), folder, "long.in", "long.log",
                 [&](const std::string&) { return ++questions < 3; });

  EXPECT_FALSE(run.finished);
  EXPECT_EQ(run.note, "stopped while LAMMPS was running");
  EXPECT_EQ(questions, 3);
}

TEST_F(LammpsRunTest, SeveralProcessesAreOneRun) {
  NEEDS_LAMMPS();
  if (program_on_path("mpirun").empty())
    GTEST_SKIP() << "skipped: needs mpi-default-bin";
  write("two.in", "region box block 0 2 0 1 0 1\ncreate_box 1 box\n");

  const LammpsRun run =
      run_lammps(find_lammps(2, folder), folder, "two.in", "two.log");

  EXPECT_TRUE(run.finished) << run.note;
  std::ifstream log(folder / "two.log");
  const std::string text{std::istreambuf_iterator<char>(log), {}};
  EXPECT_NE(text.find("2 by 1 by 1 MPI processor grid"), std::string::npos)
      << text;
}

} // namespace asperity::md::lammps_run_test
