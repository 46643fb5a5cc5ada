// Tests of base/folder_lock.hpp: one process at a time owns a folder, the
// others receive its name, and the death of the owner releases the folder.
#include "base/child_process.hpp"
#include "base/folder_lock.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <string>
#include <system_error>
#include <unistd.h>

namespace asperity::folder_lock_test {

class FolderLockTest : public testing::Test {
protected:
  ~FolderLockTest() override { std::filesystem::remove_all(folder); }

  /// The message to a second process; empty if it gets the folder.
  std::string refusal() const {
    try {
      const FolderLock second(folder, "run second");
      return "";
    } catch (const UnusableFolder& error) {
      return error.what();
    }
  }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("asperity-lock-" + std::to_string(::getpid())) / "new";
};

TEST_F(FolderLockTest, TheSecondReceivesTheNameOfTheFirst) {
  std::optional<FolderLock> first(std::in_place, folder, "run first");

  const std::string refused = refusal();

  EXPECT_TRUE(refused.starts_with(folder.string() +
                                  " is in use by run first (process " +
                                  std::to_string(::getpid()) + " on "))
      << refused;
  EXPECT_NE(refused.find(", since 20"), std::string::npos) << refused;

  first.reset();
  EXPECT_EQ(refusal(), "");
}

TEST_F(FolderLockTest, AKilledOwnerReleasesTheFolder) {
  ChildProcess holder = ChildProcess::forked([this](int pipe) {
    const FolderLock lock(folder, "run killed");
    if (::write(pipe, "x", 1) == 1)
      ::pause();
  });
  char locked = ' ';
  ASSERT_EQ(::read(holder.output_pipe(), &locked, 1), 1);
  EXPECT_NE(refusal().find("run killed"), std::string::npos);

  holder.kill();
  holder.wait();

  EXPECT_EQ(refusal(), "");
}

TEST_F(FolderLockTest, AFolderThatCannotBeMadeIsAnError) {
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / "file";
  std::ofstream(file) << "text";

  for (const auto& asked : {file, file / "new"})
    try {
      const FolderLock lock(asked, "run");
      ADD_FAILURE() << asked;
    } catch (const UnusableFolder& error) {
      EXPECT_EQ(error.what(),
                file.string() + " is a file, not a folder; name another --out");
    }
  EXPECT_THROW(FolderLock("/proc/new", "run"), std::system_error);
}

} // namespace asperity::folder_lock_test
