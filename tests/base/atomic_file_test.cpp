// Tests of base/atomic_file.hpp: a file is written completely or not at all,
// and no temporary file is left.
#include "base/atomic_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

namespace asperity::atomic_file_test {

namespace fs = std::filesystem;

class AtomicFile : public ::testing::Test {
protected:
  void SetUp() override { fs::create_directories(folder_); }

  void TearDown() override { fs::remove_all(folder_); }

  static std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::ptrdiff_t n_files() const {
    return std::distance(fs::directory_iterator(folder_), {});
  }

  fs::path folder_ = fs::path(::testing::TempDir()) /
                     temporary_beside("atomic_file_test").filename();
};

TEST_F(AtomicFile, HoldsExactlyTheTextAndNothingElseIsLeft) {
  const std::string text("line\nzero \0 byte\r\n", 18);

  write_file_atomically(folder_ / "out.txt", "longer than what follows it");
  write_file_atomically(folder_ / "out.txt", text);

  EXPECT_EQ(content(folder_ / "out.txt"), text);
  EXPECT_EQ(n_files(), 1);
}

TEST_F(AtomicFile, MayHoldOneByteOrNone) {
  for (const std::string text : {"", "x"}) {
    write_file_atomically(folder_ / "out.txt", text);

    EXPECT_EQ(content(folder_ / "out.txt"), text);
  }
}

TEST_F(AtomicFile, ReplacesTheFileThatALinkNames) {
  write_file_atomically(folder_ / "out.txt", "old");
  fs::create_symlink("out.txt", folder_ / "link.txt");

  write_file_atomically(folder_ / "link.txt", "new");

  EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
  EXPECT_EQ(content(folder_ / "out.txt"), "new");
}

TEST_F(AtomicFile, WritesToAPipeAndLeavesIt) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);

  write_file_atomically(pipe, "text");

  std::string read(10, ' ');
  read.resize(static_cast<std::size_t>(
      std::max<ssize_t>(0, ::read(reader, read.data(), read.size()))));
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(read, "text");
}

// A process without standard input can write, although the system opens the
// file as number 0 for it.
TEST_F(AtomicFile, WorksWithoutStandardInput) {
  const int input = ::dup(0);
  ::close(0);

  EXPECT_NO_THROW(write_file_atomically(folder_ / "out.txt", "text"));

  EXPECT_EQ(::dup2(input, 0), 0);
  ::close(input);
  EXPECT_EQ(content(folder_ / "out.txt"), "text");
}

// A folder in place of the file makes the rename fail after the text is
// written.
TEST_F(AtomicFile, NamesThePathAndLeavesNoTemporaryWhenItFails) {
  const fs::path taken = folder_ / "taken";
  fs::create_directories(taken / "inner");

  try {
    write_file_atomically(taken, "text");
    FAIL() << "a folder was replaced by a file";
  } catch (const std::system_error& error) {
    EXPECT_NE(std::string(error.what()).find(taken.string()),
              std::string::npos);
  }
  EXPECT_EQ(n_files(), 1);
  EXPECT_THROW(write_file_atomically(folder_ / "missing" / "out.txt", "text"),
               std::system_error);
}

// Each reader must see the complete text of one writer: equal letters and the
// full length.
TEST_F(AtomicFile, IsAlwaysCompleteForReadersWhileWritersRace) {
  const fs::path path = folder_ / "out.txt";
  const std::size_t length = 20000;
  write_file_atomically(path, std::string(length, 'a'));

  std::vector<std::thread> writers;
  for (const char letter : {'b', 'c'})
    writers.emplace_back([&path, letter] {
      for (int i = 0; i < 30; ++i)
        write_file_atomically(path, std::string(length, letter));
    });
  bool is_whole = true;
  for (int i = 0; i < 200; ++i) {
    const std::string text = content(path);
    is_whole = is_whole && text.size() == length &&
               text == std::string(length, text.front());
  }
  for (std::thread& writer : writers)
    writer.join();

  EXPECT_TRUE(is_whole);
  EXPECT_EQ(n_files(), 1);
}

} // namespace asperity::atomic_file_test
