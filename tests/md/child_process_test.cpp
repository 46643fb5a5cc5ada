// Claims about md/child_process.hpp: what a child says and how it ends reaches
// us, and nothing of it outlives us.
#include "md/child_process.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>
#include <unistd.h>

namespace asperity::md {
namespace {

constexpr double patience = 20.0; // seconds, for a busy machine

class ChildProcessTest : public testing::Test {
protected:
  ChildProcessTest() { std::filesystem::create_directories(folder); }

  ~ChildProcessTest() override { std::filesystem::remove_all(folder); }

  std::string said() const {
    std::ifstream file(output);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  ChildProcess shell(const std::string& script) const {
    return ChildProcess({"/bin/sh", "-c", script}, folder, output);
  }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("asperity-child-" + std::to_string(::getpid()));
  std::filesystem::path output = folder / "output";
};

/// Waits until no process of that number is left.
bool is_gone(pid_t process) {
  for (int i = 0; i < 400; ++i) {
    if (::kill(process, 0) != 0)
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

TEST_F(ChildProcessTest, WorksInItsFolderAndBothOutputsAreKept) {
  ChildProcess child = shell("pwd; echo trouble >&2");

  ASSERT_TRUE(child.has_ended(patience));
  EXPECT_EQ(child.failure(), "");
  EXPECT_EQ(said(),
            std::filesystem::canonical(folder).string() + "\ntrouble\n");
}

TEST_F(ChildProcessTest, SaysHowItFailed) {
  ChildProcess gave_up = shell("exit 3");
  ASSERT_TRUE(gave_up.has_ended(patience));
  EXPECT_EQ(gave_up.failure(), "exit code 3");

  ChildProcess killed = shell("kill -9 $$");
  ASSERT_TRUE(killed.has_ended(patience));
  EXPECT_EQ(killed.failure(), "signal 9");
}

TEST_F(ChildProcessTest, ItsOwnChildrenEndWithIt) {
  ChildProcess child = shell("sleep 1000 & echo $! > grandchild; wait");
  pid_t grandchild = 0;
  for (int i = 0; i < 400 && grandchild == 0; ++i) {
    std::ifstream(folder / "grandchild") >> grandchild;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  ASSERT_GT(grandchild, 0);

  child.stop();

  EXPECT_TRUE(is_gone(grandchild));
  EXPECT_EQ(child.failure(), "signal 15");
}

TEST_F(ChildProcessTest, SeesNothingOfAnMpiOfThisProcess) {
  ::setenv("PMIX_RANK", "0", 1);
  ::setenv("OMPI_COMM_WORLD_SIZE", "7", 1);
  ::setenv("ASPERITY_SEEN", "yes", 1);

  ChildProcess child =
      shell("echo \"$PMIX_RANK$OMPI_COMM_WORLD_SIZE$ASPERITY_SEEN\"");

  ASSERT_TRUE(child.has_ended(patience));
  EXPECT_EQ(said(), "yes\n");
  ::unsetenv("PMIX_RANK");
  ::unsetenv("OMPI_COMM_WORLD_SIZE");
  ::unsetenv("ASPERITY_SEEN");
}

TEST_F(ChildProcessTest, ThatCannotStartIsAnError) {
  EXPECT_THROW(ChildProcess({"/nowhere/lmp"}, folder, output),
               std::system_error);
}

TEST_F(ChildProcessTest, ProgramsAreFoundAlongPathAlone) {
  EXPECT_EQ(program_on_path("sh").filename(), "sh");
  EXPECT_TRUE(program_on_path("no-such-program").empty());
  // A file that cannot be executed is no program.
  std::ofstream(folder / "plain") << "text";
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", folder.c_str(), 1);

  EXPECT_TRUE(program_on_path("sh").empty());
  EXPECT_TRUE(program_on_path("plain").empty());

  ::setenv("PATH", before.c_str(), 1);
}

} // namespace
} // namespace asperity::md
