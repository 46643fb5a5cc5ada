// The main function of every test program: that of GoogleTest, with a folder of
// its own for temporary files. Test programs can therefore run at the same
// time, of several checkouts and users, and leave no file behind.
//   test_theory --source persson punches    the tests of persson_test.cpp and
//                                           punches_test.cpp in tests/theory
#include "base/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

/// The filter of the tests of one source; empty if there is none.
std::string filter_of_source(const std::string& name) {
  const std::string file = "/" + name + "_test.cpp";
  const auto& program = *testing::UnitTest::GetInstance();
  std::string filter;
  for (int i = 0; i < program.total_test_suite_count(); ++i) {
    const auto& suite = *program.GetTestSuite(i);
    std::string tests;
    bool is_whole = true;
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const auto& test = *suite.GetTestInfo(j);
      if (std::string(test.file()).ends_with(file))
        tests += std::string(suite.name()) + "." + test.name() + ":";
      else
        is_whole = false;
    }
    filter += is_whole ? std::string(suite.name()) + ".*:" : tests;
  }
  return filter;
}

} // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc > 2 && std::string(argv[1]) == "--source") {
    testing::GTEST_FLAG(filter) = "";
    for (int i = 2; i < argc; ++i) {
      const std::string filter = filter_of_source(argv[i]);
      if (filter.empty()) {
        std::fprintf(stderr, "%s: no test of %s_test.cpp\n", argv[0], argv[i]);
        return 1;
      }
      testing::GTEST_FLAG(filter) += filter;
    }
  }
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
