#pragma once

// A temporary folder for each test.

#include "base/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace asperity::tests {

/// A test with an empty working folder, removed at its end.
class FolderTest : public ::testing::Test {
private:
  TemporaryFolder temporary_{"asperity"};

protected:
  const std::filesystem::path folder = temporary_.path();
};

} // namespace asperity::tests
