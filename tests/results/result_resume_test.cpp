// Tests of resuming with a result file: finished steps are known, and a result
// of another case is not changed.
#include "base/atomic_file.hpp"
#include "input/input_error.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "results/storage/hdf5_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/results/sample_result.hpp"

namespace asperity::results::result_resume_test {

using ResultResume = ResultFolder;

TEST_F(ResultResume, ContinuesFromTheFinishedSteps) {
  {
    ResultWriter first(folder_, sample_case());
    first.begin_method("fem", "fem", "");
    first.append_step("fem", 0, sample_point(0));
    first.append_step("fem", 2, sample_point(5));
    first.finish("interrupted");
  }
  ResultWriter second(folder_, sample_case(), ResultWriter::Mode::resume);
  EXPECT_EQ(read_result(folder_).status, "running");
  EXPECT_TRUE(second.has_step("fem", 0, 0));
  EXPECT_TRUE(second.has_step("fem", 2, 5));
  EXPECT_FALSE(second.has_step("fem", 0, 5));
  EXPECT_FALSE(second.has_step("theory", 0, 0));
  second.append_step("fem", 0, sample_point(1));

  const StepsDone done = steps_done(read_result(folder_));

  EXPECT_EQ(done, (StepsDone{{{"fem", 0}, {0, 1}}, {{"fem", 2}, {5}}}));
}

// A file of a program with fewer columns is read and continued: its rows have
// NaN there, the new ones their numbers.
TEST_F(ResultResume, ContinuesAFileOfFewerColumns) {
  {
    ResultWriter first(folder_, sample_case());
    first.begin_method("fem", "fem", "");
    first.append_steps("fem", 0, std::vector{sample_point(0), sample_point(1)});
    first.finish("interrupted");
    const std::lock_guard lock(hdf5_mutex());
    Hdf5File file(first.path(), Hdf5File::Mode::read_write);
    file.open("methods/fem/0/curve").remove("area_fraction_fit");
    file.close();
  }
  ResultWriter second(folder_, sample_case(), ResultWriter::Mode::resume);
  second.append_step("fem", 0, sample_point(2));
  second.append_step("fem", 0, sample_point(3));

  const Result result = read_result(folder_);

  const std::vector<CurvePoint>& points =
      result.methods.at(0).realizations.at(0).points;
  ASSERT_EQ(points.size(), 4U);
  EXPECT_TRUE(std::isnan(points[0].area_fraction_fit));
  EXPECT_TRUE(std::isnan(points[1].area_fraction_fit));
  expect_same(points[2], sample_point(2));
  expect_same(points[3], sample_point(3));
  EXPECT_EQ(points[0].area_fraction, sample_point(0).area_fraction);
}

// A result of another case, of other input files or of another program is not
// changed, and every difference is named.
TEST_F(ResultResume, NamesTheDifferencesAndChangesNothing) {
  CaseInfo before = sample_case();
  before.inputs = {{"surface.file", std::string(64, 'a')},
                   {"program", std::string(64, 'b')},
                   {"mesh.file", std::string(64, 'c')}};
  { const ResultWriter first(folder_, before); }
  CaseInfo now = before;
  now.hash = "beef";
  now.text = "schema = 1\r\n# o\n";
  now.inputs["surface.file"] = std::string(64, 'd');
  now.inputs["program"] = std::string(64, 'e');

  try {
    const ResultWriter second(folder_, now, ResultWriter::Mode::resume);
    FAIL() << "a result of another case was taken for this one's";
  } catch (const input::InputError& error) {
    EXPECT_EQ(
        std::string(error.what()),
        (folder_ / "result.h5").string() +
            " cannot be resumed: line 2 of the case is \"# o\", but was \"# "
            "ü\"; the program was built from different sources or tools "
            "(SHA-256 eeeeeeeeeeee, but was bbbbbbbbbbbb); the file given by "
            "surface.file has different content (SHA-256 dddddddddddd, but was "
            "aaaaaaaaaaaa); run without --resume, or choose another --out");
  }
  EXPECT_EQ(read_result(folder_).case_hash, "0af3");
  EXPECT_EQ(inputs_of(read_result(folder_)), before.inputs);

  const ResultWriter third(folder_, before, ResultWriter::Mode::resume);
}

// A result of an earlier program does not record its input files.
TEST_F(ResultResume, RefusesUnknownInputs) {
  { const ResultWriter first(folder_, sample_case()); }
  CaseInfo now = sample_case();
  now.inputs = {{"surface.file", std::string(64, 'd')}};

  EXPECT_THROW(ResultWriter(folder_, now, ResultWriter::Mode::resume),
               input::InputError);
}

// The published values do not affect the computation: an old result is compared
// with the present ones.
TEST_F(ResultResume, TakesTheReferenceOfTheResumedRun) {
  { const ResultWriter first(folder_, sample_case()); }
  CaseInfo corrected = sample_case();
  corrected.reference += "kappa,2.2,1,0.1,a paper\n";

  const ResultWriter second(folder_, corrected, ResultWriter::Mode::resume);

  EXPECT_EQ(read_result(folder_).reference, corrected.reference);
}

// A temporary file that a killed run left is overwritten and never read.
TEST_F(ResultResume, IgnoresThePartOfAKilledRun) {
  { const ResultWriter first(folder_, sample_case()); }
  write_file_atomically(folder_ / ".result.h5.part", "half a file");

  ResultWriter second(folder_, sample_case(), ResultWriter::Mode::resume);
  second.finish("complete");

  EXPECT_EQ(read_result(folder_).status, "complete");
  EXPECT_FALSE(std::filesystem::exists(folder_ / ".result.h5.part"));
}

} // namespace asperity::results::result_resume_test
