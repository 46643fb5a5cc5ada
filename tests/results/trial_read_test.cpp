// Claims about results/trial_read.hpp: a file that makes the HDF5
// library fail is an error of the file and no end of the program.
#include "input/input_error.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/trial_read.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/results/sample_result.hpp"

namespace asperity::results {
namespace {

class TrialRead : public ResultFolder {};

// Found by fuzzing: the library copies more of its heap of texts than there is
// (H5HG_read). The reader with it in one process ended with a signal.
TEST_F(TrialRead, RefusesWhatEndsTheLibrary) {
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

// Claim: a good file and one with a mistake are left to the reader.
TEST_F(TrialRead, LeavesTheRestToTheReader) {
  EXPECT_NO_THROW(require_readable("tests/fuzz/corpus/result/least.h5"));
  EXPECT_NO_THROW(require_readable("no/such/file.h5"));
}

} // namespace
} // namespace asperity::results
