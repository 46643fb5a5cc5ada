// Tests of the list of skipped items: what is written is read back, and a list
// is replaced as a unit.
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace asperity::results::skipped_test {

using SkippedList = ResultFolder;

TEST_F(SkippedList, IsReadBackUnchanged) {
  const std::vector<Skipped> list{{"fem: 16 steps", "in the cache"},
                                  {"maps, \u00fc", ""}};
  ResultWriter(folder_, sample_case()).record_skipped(list);

  const std::vector<Skipped> read = read_result(folder_).skipped;

  ASSERT_EQ(read.size(), list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(read[i].what, list[i].what);
    EXPECT_EQ(read[i].why, list[i].why);
  }
}

TEST_F(SkippedList, IsReplacedAsAUnitAndMayBeEmpty) {
  ResultWriter writer(folder_, sample_case());
  EXPECT_TRUE(read_result(folder_).skipped.empty());
  writer.record_skipped(std::vector<Skipped>(3));
  writer.record_skipped(std::vector<Skipped>(1));
  EXPECT_EQ(read_result(folder_).skipped.size(), 1u);

  writer.record_skipped({});

  EXPECT_TRUE(read_result(folder_).skipped.empty());
}

} // namespace asperity::results::skipped_test
