// The main function of every test program: that of GoogleTest, with a folder of
// its own for temporary files. Test programs can therefore run at the same
// time, of several checkouts and users, and leave no file behind.
#include "base/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const asperity::TemporaryFolder folder("asperity-test");
  // Some tests run programs as another user.
  std::filesystem::permissions(folder.path(),
                               std::filesystem::perms::others_read |
                                   std::filesystem::perms::others_exec,
                               std::filesystem::perm_options::add);
  setenv("TMPDIR", folder.path().c_str(), 1);
  // What testing::TempDir() returns, which callers expect to end in a slash.
  setenv("TEST_TMPDIR", (folder.path() / "").c_str(), 1);
  return RUN_ALL_TESTS();
}
