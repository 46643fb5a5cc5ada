// Tests of base/child_process.hpp: the output and the exit of a child are
// reported, it runs within its limits, and it does not outlive the parent.
#include "base/child_process.hpp"
#include "base/peak_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace asperity::child_process_test {

constexpr double time_limit = 20.0; // seconds, for a busy machine

class ChildProcessTest : public testing::Test {
protected:
  ChildProcessTest() { std::filesystem::create_directories(folder); }

  ~ChildProcessTest() override { std::filesystem::remove_all(folder); }

  ChildCommand shell(const std::string& script) const {
    return {{"/bin/sh", "-c", script}, folder};
  }

  /// The number that a child wrote into a file of the folder.
  pid_t number_in(const std::string& file) const {
    pid_t number = 0;
    for (int i = 0; i < 400 && number == 0; ++i) {
      std::ifstream(folder / file) >> number;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return number;
  }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("asperity-child-" + std::to_string(::getpid()));
};

/// Waits until no process of that number runs; one that another process has yet
/// to reap counts as ended.
bool is_gone(pid_t process) {
  for (int i = 0; i < 400; ++i) {
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    std::string number;
    std::string name;
    std::string state;
    if (!(stat >> number >> name >> state) || state == "Z")
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

TEST_F(ChildProcessTest, WorksInItsFolderAndBothOutputsAreKept) {
  const ChildAnswer answer = run_child(shell("pwd; echo trouble >&2"));

  EXPECT_EQ(answer.end.exit_code, 0);
  EXPECT_EQ(answer.end.failure, "");
  EXPECT_EQ(answer.output,
            std::filesystem::canonical(folder).string() + "\ntrouble\n");
}

TEST_F(ChildProcessTest, WritesIntoAFileThatIsNamed) {
  ChildCommand command = shell("echo words; cat");
  command.output = folder / "log";

  const ChildAnswer answer = run_child(command);

  std::string line;
  std::getline(std::ifstream(folder / "log"), line);
  EXPECT_EQ(line, "words");
  EXPECT_EQ(answer.output, "");
}

TEST_F(ChildProcessTest, ReportsHowItFailed) {
  const ChildEnd failed = run_child(shell("exit 3")).end;
  EXPECT_EQ(failed.failure, "exit code 3");
  EXPECT_EQ(failed.exit_code, 3);

  const ChildEnd killed = run_child(shell("kill -9 $$")).end;
  EXPECT_EQ(killed.failure, "signal 9 (Killed)");
  EXPECT_EQ(killed.exit_code, 128 + SIGKILL);
}

// A scheduler may have limited what this process may have to less than a child
// is given; that limit cannot be raised.
TEST_F(ChildProcessTest, ALowerLimitOfItsParentHolds) {
  ChildProcess limited = ChildProcess::forked([&](int output) {
    constexpr rlim_t low = 1 << 20;
    const rlimit own{low, low};
    setrlimit(RLIMIT_FSIZE, &own);
    ChildCommand command = shell("ulimit -f");
    command.limits.file_size = 8 * low;
    const std::string blocks = run_child(command).output;
    static_cast<void>(write(output, blocks.data(), blocks.size()));
  });
  char text[64] = {};

  const ssize_t length = read(limited.output_pipe(), text, sizeof text);

  limited.wait();
  EXPECT_EQ(limited.end().failure, "");
  // sh counts in blocks of 512 bytes, bash in KiB.
  const std::string blocks(
      text, static_cast<std::size_t>(std::max<ssize_t>(0, length)));
  EXPECT_TRUE(blocks == "2048\n" || blocks == "1024\n") << blocks;
}

// Where another part of the program collects the exit status, the exit is
// unknown, which must not count as success.
TEST_F(ChildProcessTest, ALostExitStatusIsAFailure) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  ChildProcess child(shell("exit 3"));
  const bool has_ended = child.has_ended(time_limit);
  std::signal(SIGCHLD, before);

  ASSERT_TRUE(has_ended);
  EXPECT_EQ(child.end().failure, "an unknown exit status: No child processes");
  EXPECT_NE(child.end().exit_code, 0);
}

TEST_F(ChildProcessTest, KeepsItsLimits) {
  ChildCommand endless = shell("while :; do :; done");
  endless.limits.cpu_time = 1.0;
  EXPECT_EQ(run_child(endless).end.failure, "more than 1 s of CPU time");

  ChildCommand sleeper = shell("sleep 1000 & echo $! > sleeper; wait");
  sleeper.limits.wall_time = 0.5;
  EXPECT_EQ(run_child(sleeper).end.failure, "longer than 0.5 s");
  EXPECT_TRUE(is_gone(number_in("sleeper")));

  const std::string hungry = "head -c 200000000 /dev/zero | tail | wc -c";
  ChildCommand large = shell(hungry);
  EXPECT_EQ(run_child(large).output, "200000000\n");
  large.limits.memory = 100'000'000;
  EXPECT_NE(run_child(large).output, "200000000\n");

  ChildCommand talker = shell("exec cat /dev/zero");
  talker.limits.file_size = 100'000;
  const ChildAnswer talk = run_child(talker);
  EXPECT_EQ(talk.end.failure, "signal 25 (File size limit exceeded)");
  EXPECT_EQ(talk.output.size(), 100'000U);
}

TEST_F(ChildProcessTest, ItsOwnChildrenEndWithIt) {
  ChildProcess child(shell("sleep 1000 & echo $! > grandchild; wait"));
  const pid_t grandchild = number_in("grandchild");
  ASSERT_GT(grandchild, 0);

  child.stop();

  EXPECT_TRUE(is_gone(grandchild));
  EXPECT_EQ(child.end().failure, "signal 15 (Terminated)");
}

// None of our code runs when the parent is killed: the kernel ends the child.
TEST_F(ChildProcessTest, EndsWhenItsParentIsKilled) {
  ChildProcess parent = ChildProcess::forked([this](int) {
    ChildProcess child(shell("echo $$ > child; exec sleep 1000"));
    child.wait();
  });
  const pid_t child = number_in("child");
  ASSERT_GT(child, 0);
  ASSERT_FALSE(parent.has_ended(0.0));

  parent.kill();

  EXPECT_TRUE(is_gone(child));
  EXPECT_EQ(parent.wait().failure, "signal 9 (Killed)");
}

// A lock or a result file that a child keeps open would stay locked.
TEST_F(ChildProcessTest, InheritsNoOpenFile) {
  constexpr int number = 100;
  const FileDescriptor file(::open(folder.c_str(), O_RDONLY));
  const FileDescriptor copy(::fcntl(file.get(), F_DUPFD, number));
  ASSERT_EQ(copy.get(), number);

  const std::string open_files = run_child({{"ls", "/proc/self/fd"}}).output;

  EXPECT_EQ(open_files.find("100"), std::string::npos) << open_files;
  EXPECT_NE(open_files.find('2'), std::string::npos) << open_files;
}

TEST_F(ChildProcessTest, AForkedChildWritesToItsPipe) {
  ChildProcess child = ChildProcess::forked([](int pipe) {
    if (::write(pipe, "words", 5) != 5)
      throw std::runtime_error("no pipe");
  });
  char text[16];
  EXPECT_EQ(::read(child.output_pipe(), text, sizeof text), 5);
  EXPECT_EQ(child.wait().failure, "");

  ChildProcess failing = ChildProcess::forked(
      [](int) { throw std::runtime_error("(an expected message)"); });
  EXPECT_EQ(failing.wait().failure, "exit code 1");
}

TEST_F(ChildProcessTest, ThatCannotStartIsAnError) {
  try {
    ChildProcess({{"/nowhere/lmp"}});
    FAIL() << "there is no such program";
  } catch (const std::system_error& error) {
    EXPECT_STREQ(error.what(),
                 "/nowhere/lmp cannot be started: No such file or directory");
  }
  EXPECT_THROW(ChildProcess({{"no-such-program"}}), std::system_error);
  EXPECT_THROW(ChildProcess({{"/bin/sh"}, folder / "nowhere"}),
               std::system_error);
}

// The memory of the parent is not counted as that of its child, in contrast to
// getrusage.
TEST_F(ChildProcessTest, DoesNotInheritPeakMemory) {
  if (std::getenv("ASPERITY_PRINT_PEAK") != nullptr) {
    std::ofstream(std::getenv("ASPERITY_PRINT_PEAK")) << peak_memory();
    return;
  }
  constexpr std::size_t large = 400'000'000;
  const std::vector<char> touched(large, 'x');
  ChildCommand self{
      {"/proc/self/exe",
       "--gtest_filter=ChildProcessTest.DoesNotInheritPeakMemory"}};
  self.environment.push_back("ASPERITY_PRINT_PEAK=" +
                             (folder / "peak").string());

  ASSERT_EQ(run_child(self).end.failure, "");

  double peak = 0.0;
  std::ifstream(folder / "peak") >> peak;
  EXPECT_GT(peak, 1e5);
  EXPECT_LT(peak, 0.5 * large);
  EXPECT_GT(peak_memory(), 1.0 * large) << touched.back();
}

TEST_F(ChildProcessTest, ProgramsAreFoundAlongPathAlone) {
  EXPECT_EQ(program_on_path("sh").filename(), "sh");
  EXPECT_TRUE(program_on_path("no-such-program").empty());
  // A file that cannot be executed is not a program.
  std::ofstream(folder / "plain") << "text";
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", folder.c_str(), 1);

  EXPECT_TRUE(program_on_path("sh").empty());
  EXPECT_TRUE(program_on_path("plain").empty());

  ::setenv("PATH", before.c_str(), 1);
}

} // namespace asperity::child_process_test
