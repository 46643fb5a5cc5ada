// Tests of the journal of a result: it is read as the file would be, the cost
// of a step is that of its own size, finished steps are known when a run
// resumes, and no damage, full disk or kill at any moment loses them.
#include "base/atomic_file.hpp"
#include "base/child_process.hpp"
#include "input/input_error.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "results/storage/hdf5_file.hpp"
#include "results/storage/journal.hpp"
#include "results/types/method_columns.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <poll.h>
#include <random>
#include <string>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

namespace asperity::results::journal_test {

namespace fs = std::filesystem;

const Grid grid{16, 8, 1e-6, 5e-7};

Fields maps_of(int step) {
  Fields fields;
  fields.step = step;
  fields.nominal_pressure = sample_point(step).nominal_pressure;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    fields.pressure.push_back(1e6 / (1.0 + static_cast<double>(i) + step));
    fields.gap.push_back(1e-9 * static_cast<double>(i) - 1e-9 * step);
  }
  return fields;
}

SurfaceRecord surface_of(double height, const Grid& on = grid) {
  SurfaceRecord surface;
  surface.grid = on;
  surface.heights.assign(on.size(), -height);
  for (std::size_t i = 0; i < on.size(); i += 2)
    surface.heights[i] = height;
  fill_numbers(surface);
  surface.spectrum = {{1e6, 2e-20}, {2e6, 1e-21}};
  return surface;
}

class ResultJournal : public ResultFolder {
protected:
  fs::path journal() const { return folder_ / "result.journal"; }

  fs::path file() const { return folder_ / "result.h5"; }

  /// Every kind of change, some of them twice.
  static void write_everything(ResultWriter& writer) {
    writer.record_provenance({{"commit", "one"}, {"wall time", "1 s"}});
    writer.record_surface(1, surface_of(1e-9));
    writer.record_surface(0, surface_of(2e-9));
    writer.record_surface(1, surface_of(3e-9));
    writer.begin_method("fem.hard", "fem", "Q1");
    writer.begin_method("theory", "theory", "");
    writer.begin_method("fem.hard", "fem", "Q1; found");
    writer.record_own_surface("theory", 0, surface_of(4e-9));
    writer.record_setup_time("fem.hard", 1, 0.75);
    writer.append_steps("fem.hard", 1,
                        std::vector{sample_point(2), sample_point(0)});
    writer.append_fields("fem.hard", 1, grid, maps_of(5));
    writer.append_step_with_fields("fem.hard", 1, sample_point(1), grid,
                                   maps_of(1));
    writer.append_fields("fem.hard", 1, grid, maps_of(5));
    writer.append_step("theory", 0, sample_point(0));
    writer.record_table({"leak", "A title", {{"gap", "m", {1.0, 2.0}}}});
    writer.record_table({"leak", "Another", {{"gap", "m", {3.0}}}});
    writer.record_skipped(std::vector<Skipped>{{"md", "too dear"}});
    writer.record_provenance({{"wall time", "2 s"}});
  }

  /// Bytes that this process has passed to write().
  static double bytes_written() {
    std::ifstream counters("/proc/self/io");
    for (std::string word; counters >> word;)
      if (double bytes = 0.0; word == "wchar:" && counters >> bytes)
        return bytes;
    return 0.0;
  }

  std::size_t rows() const {
    return read_result(folder_).methods.at(0).realizations.at(0).points.size();
  }

  /// The state after a run was killed: rows 0 to n - 1 in the journal alone.
  void leave_rows(int n) const {
    ResultWriter writer(folder_, sample_case());
    writer.begin_method("fem", "fem", "");
    for (int step = 0; step < n; ++step)
      writer.append_step("fem", 0, sample_point(step));
  }

  std::string journal_text() const {
    std::ifstream stream(journal(), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  void write_journal(const std::string& text) const {
    std::ofstream(journal(), std::ios::binary) << text;
  }
};

void expect_same_surface(const SurfaceRecord& a, const SurfaceRecord& b) {
  EXPECT_EQ(a.grid.points_x, b.grid.points_x);
  EXPECT_EQ(a.grid.length_y, b.grid.length_y);
  EXPECT_EQ(a.heights, b.heights);
  EXPECT_EQ(a.rms_height, b.rms_height);
  EXPECT_EQ(a.kurtosis, b.kurtosis);
  ASSERT_EQ(a.spectrum.size(), b.spectrum.size());
  for (std::size_t i = 0; i < a.spectrum.size(); ++i)
    EXPECT_EQ(a.spectrum[i].spectrum, b.spectrum[i].spectrum);
}

void expect_same_curve(const Curve& a, const Curve& b) {
  EXPECT_EQ(a.setup_cpu_time, b.setup_cpu_time);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i)
    expect_same(a.points[i], b.points[i]);
  ASSERT_EQ(a.fields.size(), b.fields.size());
  for (std::size_t i = 0; i < a.fields.size(); ++i) {
    EXPECT_EQ(a.fields[i].step, b.fields[i].step);
    EXPECT_EQ(a.fields[i].nominal_pressure, b.fields[i].nominal_pressure);
    EXPECT_EQ(a.fields[i].pressure, b.fields[i].pressure);
    EXPECT_EQ(a.fields[i].gap, b.fields[i].gap);
    EXPECT_EQ(a.fields[i].grid.points_x, b.fields[i].grid.points_x);
    EXPECT_EQ(a.fields[i].grid.length_y, b.fields[i].grid.length_y);
  }
  ASSERT_EQ(a.own_surface.has_value(), b.own_surface.has_value());
  if (a.own_surface)
    expect_same_surface(*a.own_surface, *b.own_surface);
}

TEST_F(ResultJournal, ReadsAsTheFileThatItBecomes) {
  ResultWriter writer(folder_, sample_case());
  write_everything(writer);
  ASSERT_TRUE(fs::exists(journal()));
  const Result before = read_result(folder_);

  writer.finish("interrupted");

  EXPECT_FALSE(fs::exists(journal()));
  const Result after = read_result(folder_);
  EXPECT_EQ(before.status, "running");
  EXPECT_EQ(after.status, "interrupted");
  EXPECT_EQ(before.provenance, after.provenance);
  ASSERT_EQ(before.surfaces.size(), 2U);
  ASSERT_EQ(after.surfaces.size(), 2U);
  for (std::size_t r = 0; r < 2; ++r)
    expect_same_surface(before.surfaces[r], after.surfaces[r]);
  ASSERT_EQ(before.methods.size(), 2U);
  ASSERT_EQ(after.methods.size(), 2U);
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_EQ(before.methods[m].name, after.methods[m].name);
    EXPECT_EQ(before.methods[m].kind, after.methods[m].kind);
    EXPECT_EQ(before.methods[m].description, after.methods[m].description);
    ASSERT_EQ(before.methods[m].realizations.size(),
              after.methods[m].realizations.size());
    for (std::size_t r = 0; r < before.methods[m].realizations.size(); ++r)
      expect_same_curve(before.methods[m].realizations[r],
                        after.methods[m].realizations[r]);
  }
  ASSERT_EQ(before.tables.size(), 1U);
  EXPECT_EQ(before.tables[0].title, after.tables.at(0).title);
  EXPECT_EQ(before.tables[0].columns[0].values,
            after.tables[0].columns.at(0).values);
  ASSERT_EQ(before.skipped.size(), 1U);
  EXPECT_EQ(before.skipped[0].why, after.skipped.at(0).why);
}

// The bytes that a step writes do not grow with the file: here it contains half
// a MB of heights and a hundred rows, and a row has some 1 500 bytes with the
// names of all columns. Copying the file would be half a MB per step.
TEST_F(ResultJournal, AStepCostsItsOwnSizeAlone) {
  const Grid large{256, 256, 1e-6, 1e-6};
  ResultWriter writer(folder_, sample_case());
  writer.record_surface(0, surface_of(1e-9, large));
  writer.begin_method("fem", "fem", "");
  constexpr int steps = 100;
  double most = 0.0;
  for (int step = 0; step < steps; ++step) {
    const double before = bytes_written();
    writer.append_step("fem", 0, sample_point(step));
    most = std::max(most, bytes_written() - before);
  }

  EXPECT_GT(most, 200.0);
  EXPECT_LT(most, 2000.0);
}

// With maps in every step, all copies together write each byte a few times, for
// any number of steps.
TEST_F(ResultJournal, CopiesGrowAsTheResultDoes) {
  const Grid square{64, 64, 1e-6, 1e-6};
  Fields fields;
  for (std::size_t i = 0; i < square.size(); ++i) // does not compress well
    fields.pressure.push_back(std::fmod(1e9 * std::sin(1.0 + double(i)), 1e6));
  fields.gap = fields.pressure;
  ResultWriter writer(folder_, sample_case());
  writer.begin_method("fem", "fem", "");
  constexpr int steps = 100; // 3 MB
  const double before = bytes_written();
  for (int step = 0; step < steps; ++step) {
    fields.step = step;
    fields.nominal_pressure = sample_point(step).nominal_pressure;
    writer.append_step_with_fields("fem", 0, sample_point(step), square,
                                   fields);
  }
  writer.finish("complete");

  const double maps = 2.0 * 4.0 * steps * static_cast<double>(square.size());
  EXPECT_GT(bytes_written() - before, 1.5 * maps); // journal and file
  EXPECT_LT(bytes_written() - before, 6.0 * maps);
}

// Large maps are read from the journal when they are needed, also after it has
// been moved into the file.
TEST_F(ResultJournal, LeavesLargeMapsInItsFile) {
  const Grid square{1024, 1024, 1e-6, 1e-6};
  ASSERT_EQ(square.size(), large_map);
  Fields fields;
  for (std::size_t i = 0; i < square.size(); ++i)
    fields.pressure.push_back(static_cast<double>(i % 997));
  fields.gap.assign(square.size(), 0.5);
  fields.nominal_pressure = sample_point(0).nominal_pressure;
  ResultWriter writer(folder_, sample_case());
  writer.record_surface(0, surface_of(1e-9, {1100, 1024, 1e-6, 1e-6}));
  writer.begin_method("fem", "fem", "");
  writer.append_step_with_fields("fem", 0, sample_point(0), square, fields);
  ASSERT_GT(fs::file_size(journal()), 8 * square.size());

  const Result read = read_result(folder_, MapsInFile::large);
  writer.finish("complete");

  ASSERT_FALSE(fs::exists(journal()));
  const Fields& found = read.methods.at(0).realizations.at(0).fields.at(0);
  EXPECT_TRUE(found.pressure.empty() && found.gap.empty());
  EXPECT_TRUE(found.pressure_map().whole() == fields.pressure);
  EXPECT_TRUE(found.gap_map().whole() == fields.gap);
}

// An incomplete record is ignored, and those before it remain.
TEST_F(ResultJournal, LosesAtMostTheRecordThatIsBeingWritten) {
  leave_rows(2);
  const std::string two = journal_text();
  leave_rows(3);
  const std::string three = journal_text();
  const std::size_t record = three.size() - two.size();
  ASSERT_EQ(rows(), 3U);

  for (std::size_t missing = 1; missing <= record; missing += 7) {
    write_journal(three.substr(0, three.size() - missing));
    EXPECT_EQ(rows(), 2U) << missing;
  }
  for (std::size_t place = three.size() - record; place < three.size();
       place += 11) {
    std::string damaged = three;
    damaged[place] = static_cast<char>(damaged[place] ^ 1);
    write_journal(damaged);
    EXPECT_EQ(rows(), 2U) << place;
  }

  ResultWriter next(folder_, sample_case(), ResultWriter::Mode::resume);
  EXPECT_TRUE(next.has_step("fem", 0, 1));
  EXPECT_FALSE(next.has_step("fem", 0, 2));
  next.append_step("fem", 0, sample_point(2));
  EXPECT_EQ(rows(), 3U);
}

// A journal that was merged into the file but not yet removed when the run was
// killed is not merged again.
TEST_F(ResultJournal, IsNotMergedTwice) {
  leave_rows(3);
  const std::string text = journal_text();
  settle_result(folder_);
  ASSERT_FALSE(fs::exists(journal()));
  write_journal(text);

  EXPECT_EQ(rows(), 3U);

  ResultWriter next(folder_, sample_case(), ResultWriter::Mode::resume);
  next.append_step("fem", 0, sample_point(3));
  EXPECT_EQ(rows(), 4U);
}

TEST_F(ResultJournal, OfAnotherResultIsNotRead) {
  leave_rows(3);
  const std::string text = journal_text();
  { const ResultWriter other(folder_, sample_case()); }
  EXPECT_TRUE(read_result(folder_).methods.empty());
  write_journal(text);

  EXPECT_TRUE(read_result(folder_).methods.empty());
}

BytePieces text_of(const std::string& text) {
  return [text](const TakeBytes& take) { take(text); };
}

// A journal of another result is replaced from its first byte.
TEST_F(ResultJournal, ReplacesThatOfAnotherResult) {
  fs::create_directories(folder_);
  Journal(journal(), "another").append(1, text_of("theirs"));

  Journal own(journal(), "own");
  EXPECT_EQ(own.size(), 0U);
  own.append(1, text_of("ours"));

  std::vector<std::string> records;
  const auto take = [&](std::uint64_t, const FileBytes& record) {
    record.read(0, records.emplace_back(record.size(), ' '));
  };
  EXPECT_EQ(read_journal(journal(), "own", take), own.size());
  EXPECT_EQ(records, std::vector<std::string>{"ours"});
}

// Damage in the middle stops the writer before it removes anything.
TEST_F(ResultJournal, ThatIsDamagedIsKeptAndReported) {
  ResultWriter writer(folder_, sample_case());
  writer.begin_method("fem", "fem", "");
  for (int step = 0; step < 3; ++step)
    writer.append_step("fem", 0, sample_point(step));
  std::string damaged = journal_text();
  damaged[damaged.size() / 2] =
      static_cast<char>(damaged[damaged.size() / 2] ^ 1);
  write_journal(damaged);

  try {
    writer.finish("complete");
    FAIL() << "a damaged journal was taken for a whole one";
  } catch (const Hdf5Error& error) {
    EXPECT_NE(std::string(error.what()).find("result.journal: change "),
              std::string::npos)
        << error.what();
  }
  EXPECT_EQ(journal_text(), damaged);
  EXPECT_FALSE(fs::exists(folder_ / ".result.h5.part"));
  EXPECT_EQ(read_result(folder_).status, "running");
}

// On a full disk (a limit of the file's size has the same effect) the step that
// does not fit is an error that names the file, and all steps before it are
// there.
TEST_F(ResultJournal, AFullDiskLosesNoFinishedStep) {
  ChildLimits limits;
  limits.file_size = 80'000;
  ChildProcess child = ChildProcess::forked(
      [this](int) {
        std::signal(SIGXFSZ, SIG_IGN);
        ResultWriter writer(folder_, sample_case());
        writer.begin_method("fem", "fem", "");
        int step = 0;
        try {
          for (; step < 10'000; ++step)
            writer.append_step("fem", 0, sample_point(step));
        } catch (const std::system_error& error) {
          const bool is_named =
              std::string(error.what()).find("result.journal") !=
              std::string::npos;
          ::_exit(is_named && rows() == static_cast<std::size_t>(step) ? 42
                                                                       : 43);
        }
      },
      limits);

  EXPECT_EQ(child.wait().exit_code, 42);
  const std::size_t done = rows();
  EXPECT_GT(done, 50U);
  ResultWriter next(folder_, sample_case(), ResultWriter::Mode::resume);
  next.append_step("fem", 0, sample_point(static_cast<int>(done)));
  next.finish("complete");
  EXPECT_EQ(rows(), done + 1);
}

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
  EXPECT_TRUE(std::isnan(points[0][columns::area_fraction_fit]));
  EXPECT_TRUE(std::isnan(points[1][columns::area_fraction_fit]));
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

using ResultKill = ResultFolder;

const Grid large_grid{64, 64, 1e-6, 1e-6};

Fields sample_fields(int step) {
  Fields fields;
  fields.step = step;
  fields.nominal_pressure = sample_point(step).nominal_pressure;
  fields.pressure.assign(large_grid.size(), 1e6 + step);
  fields.gap.assign(large_grid.size(), 1e-9 * step);
  return fields;
}

/// Appends steps without end and writes each to `report` when it is done; every
/// fifth has maps. Continues from the content of the file.
[[noreturn]] void run_for_ever(const std::filesystem::path& folder,
                               int report) {
  ResultWriter writer(folder, sample_case(), ResultWriter::Mode::resume);
  writer.begin_method("fem", "fem", "");
  for (int step = 0;; ++step) {
    if (writer.has_step("fem", 0, step))
      continue;
    if (step % 5 == 0)
      writer.append_step_with_fields("fem", 0, sample_point(step), large_grid,
                                     sample_fields(step));
    else
      writer.append_step("fem", 0, sample_point(step));
    if (::write(report, &step, sizeof step) != sizeof step)
      ::_exit(1);
  }
}

/// Until the run copies its file, or reports a step.
void wait_for_copy(const std::filesystem::path& folder, int report) {
  pollfd watched{report, POLLIN, 0};
  while (!std::filesystem::exists(folder / ".result.h5.part") &&
         ::poll(&watched, 1, 0) == 0) {
  }
}

/// Starts a run and kills it `delay` after its `n_steps`-th step is reported; 0
/// is the copy with which it begins, and has no delay.
///
/// @return  the last step it reported, -1 if there was none
int last_step_of_killed_run(const std::filesystem::path& folder, int n_steps,
                            std::chrono::microseconds delay) {
  int ends[2];
  if (::pipe(ends) != 0)
    throw std::runtime_error("no pipe");
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    run_for_ever(folder, ends[1]);
  }
  ::close(ends[1]);
  int last = -1;
  int step = -1;
  const auto read_report = [&] {
    return ::read(ends[0], &step, sizeof step) == sizeof step;
  };
  for (int i = 0; i < n_steps && read_report(); ++i)
    last = step;
  if (n_steps == 0)
    wait_for_copy(folder, ends[0]);
  else
    std::this_thread::sleep_for(delay);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the run ended by itself";
  while (read_report())
    last = step;
  ::close(ends[0]);
  return last;
}

// Each run resumes what the one before left, so that a file that was damaged
// would fail the next. A step may be in the file and not yet reported. A third
// of the kills are made while the journal is merged into the file.
TEST_F(ResultKill, AtAnyMomentLosesNoFinishedStep) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> delay_us(0, 3'000);
  { const ResultWriter first(folder_, sample_case()); }
  int n_before = 0;
  int n_kills_in_a_copy = 0;

  for (int run = 0; run < 21; ++run) {
    const int last = last_step_of_killed_run(
        folder_, run % 3, std::chrono::microseconds(delay_us(random)));
    n_kills_in_a_copy += std::filesystem::exists(folder_ / ".result.h5.part");

    const Result result = read_result(folder_);
    EXPECT_EQ(result.case_text, sample_case().text);
    if (result.methods.empty() || result.methods[0].realizations.empty())
      continue; // killed before the first step
    const Curve& curve = result.methods[0].realizations[0];
    const int n_points = static_cast<int>(curve.points.size());
    EXPECT_GE(n_points, std::max(n_before, last + 1));
    EXPECT_LE(n_points, std::max(n_before, last + 1) + 1);
    for (int step = 0; step < n_points; ++step)
      expect_same(curve.points[static_cast<std::size_t>(step)],
                  sample_point(step));
    EXPECT_EQ(static_cast<int>(curve.fields.size()), (n_points + 4) / 5);
    n_before = n_points;
  }

  EXPECT_GT(n_before, 15) << "the kills came before the steps";
  EXPECT_GT(n_kills_in_a_copy, 0) << "no kill hit a copy of the file";
}

} // namespace asperity::results::journal_test
