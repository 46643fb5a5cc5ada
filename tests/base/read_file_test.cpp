// Tests of base/read_file.hpp: regular files up to a size are read byte for
// byte; anything that could block the program or fill its memory is refused.
#include "base/atomic_file.hpp"
#include "base/read_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace asperity::read_file_test {

namespace fs = std::filesystem;

class ReadFile : public ::testing::Test {
protected:
  void SetUp() override { fs::create_directories(folder_); }

  void TearDown() override { fs::remove_all(folder_); }

  /// The message of the reader without the path.
  static std::string complaint(const fs::path& path,
                               std::uintmax_t largest = 100) {
    try {
      read_file(path, largest);
    } catch (const FileError& error) {
      const std::string text = error.what();
      EXPECT_TRUE(text.starts_with(path.string() + ": ")) << text;
      return text.substr(path.string().size() + 2);
    }
    return "accepted";
  }

  fs::path folder_ = fs::path(::testing::TempDir()) /
                     temporary_beside("read_file_test").filename();
};

TEST_F(ReadFile, GivesEveryByteUpToTheLimitAndRefusesOneMore) {
  const std::string text("line\r\nzero \0 byte", 17);
  write_file_atomically(folder_ / "a", text);
  write_file_atomically(folder_ / "empty", "");

  EXPECT_EQ(read_file(folder_ / "a", text.size()), text);
  EXPECT_EQ(read_file(folder_ / "empty", 0), "");
  EXPECT_EQ(complaint(folder_ / "a", 16),
            "has 17 bytes, but must have at most 16 (16 bytes)");
}

// A symbolic link is read as the file to which it leads.
TEST_F(ReadFile, FollowsLinks) {
  write_file_atomically(folder_ / "a", "text");
  fs::create_symlink("a", folder_ / "link");

  EXPECT_EQ(read_file(folder_ / "link", 4), "text");
}

// A file that would block or never end is refused at once; so is a link to it.
// A file of /proc states the size 0 and has more: it is cut off at the limit.
TEST_F(ReadFile, RefusesWhatIsNoRegularFile) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", folder_ / "zero");
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{AF_UNIX, {}};
  (folder_ / "s").string().copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(
      ::bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);

  EXPECT_EQ(complaint(folder_), "is a folder, but must be a regular file");
  EXPECT_EQ(complaint(folder_ / "pipe"),
            "is a pipe, but must be a regular file");
  EXPECT_EQ(complaint(folder_ / "zero"),
            "is a device, but must be a regular file");
  EXPECT_EQ(complaint("/dev/urandom"),
            "is a device, but must be a regular file");
  EXPECT_EQ(complaint(folder_ / "s"),
            "is a socket, but must be a regular file");
  EXPECT_EQ(complaint(folder_ / "none"), "there is no such file");
  EXPECT_EQ(complaint("/proc/self/environ", 10),
            "has more than 10 bytes, but must have at most as many (10 bytes)");
  ::close(socket);
}

TEST_F(ReadFile, StatesWhyTheSystemRefuses) {
  fs::create_symlink("circle", folder_ / "circle");

  EXPECT_EQ(complaint(folder_ / "circle"),
            "cannot be read (Too many levels of symbolic links)");
}

TEST(BytesText, CountsInPowersOf1024) {
  EXPECT_EQ(bytes_text(100), "100 bytes");
  EXPECT_EQ(bytes_text(1536), "1.5 KiB");
  EXPECT_EQ(bytes_text(64.0 * 1024 * 1024), "64 MiB");
}

} // namespace asperity::read_file_test
