// Tests of results/trial_read.hpp: a file that makes the HDF5 library crash is
// an error of the file and does not end the program.
#include "input/input_error.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/trial_read.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

namespace asperity::results::trial_read_test {

class TrialRead : public ResultFolder {};

// Found by fuzzing: the library copies beyond the end of its heap of strings
// (H5HG_read). Without the separate process the reader ended with a signal.
TEST_F(TrialRead, RefusesWhatCrashesTheLibrary) {
  try {
    require_readable("tests/results/data/damaged-heap.h5");
    FAIL() << "a damaged file was accepted";
  } catch (const input::InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("damaged-heap.h5: is damaged or malicious"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(TrialRead, MayTakeLongerForALargerFile) {
  EXPECT_EQ(read_time_limit("no/such/file.h5"), 20.0);
  std::filesystem::create_directories(folder_);
  const std::filesystem::path file = folder_ / "result.h5";
  const std::vector<std::pair<std::uintmax_t, double>> limits = {
      {0, 20.0}, {46'000'000, 46.0}, {1'000'000'000'000, 600.0}};
  for (const auto& [bytes, seconds] : limits) {
    std::ofstream(file).close();
    std::filesystem::resize_file(file, bytes); // without blocks on the disk
    EXPECT_DOUBLE_EQ(read_time_limit(file), seconds);
    EXPECT_DOUBLE_EQ(read_time_limit(folder_), seconds); // of its result.h5
  }
}

// A good file and one with a mistake are left to the reader.
TEST_F(TrialRead, LeavesTheRestToTheReader) {
  EXPECT_NO_THROW(require_readable("tests/fuzz/corpus/result/least.h5"));
  EXPECT_NO_THROW(require_readable("no/such/file.h5"));
}

} // namespace asperity::results::trial_read_test
