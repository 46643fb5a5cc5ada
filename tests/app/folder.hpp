#pragma once

// A folder of its own for each test.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace asperity::app {

/// A test with an empty folder to work in, removed at its end.
class FolderTest : public ::testing::Test {
protected:
  FolderTest() {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "asperity-XXXXXX").string();
    folder = mkdtemp(pattern.data());
  }

  ~FolderTest() override { std::filesystem::remove_all(folder); }

  std::filesystem::path folder;
};

} // namespace asperity::app
