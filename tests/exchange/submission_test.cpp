// Tests of suite/exchange/submission.hpp and suite/exchange/pressure_file.hpp:
// each key is read, and each mistake is named with its line.
#include "input/input_error.hpp"
#include "suite/exchange/submission.hpp"
#include "surfaces/formats/npy.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "problems.hpp"

namespace asperity::exchange::submission_test {

namespace fs = std::filesystem;

const std::string head = R"(problem = "rough"
code = "mycode"
version = "1.0"
method = "guessing"
accuracy = "best"
authors = ["A. Name", "B. Name"]
licence = "CC0-1.0"
)";

class SubmissionFolder : public testing::Test {
protected:
  SubmissionFolder() {
    fs::remove_all(folder);
    fs::create_directories(folder);
    write("p.npy", surfaces::npy_bytes(problem.heights, 64, 64));
  }

  ~SubmissionFolder() override { fs::remove_all(folder); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
  }

  Submission read(const std::string& text) {
    write("submission.toml", text);
    return read_submission(folder, problem);
  }

  std::string message_of(const std::string& text) {
    return tests::message_of<input::InputError>([&] { read(text); });
  }

  void expect(const std::string& text, const std::string& sentence) {
    const std::string message = message_of(text);
    EXPECT_NE(message.find(sentence), std::string::npos) << message;
  }

  fs::path folder = fs::path(testing::TempDir()) / "asperity-submission";
  Problem problem = problems::rough_problem();
};

TEST_F(SubmissionFolder, IsReadWithAllItsKeys) {
  const Submission read_all = read(head + R"(machine = "a laptop"
element = "Q2"
claimed_error = 1e-6
[[load]]
nominal_pressure = 2e7
pressure = "p.npy"
mean_gap = 1e-7
contact_area_fraction = 0.5
elastic_energy = 3
cpu_time = 1.5
iterations = 7
[[load]]
nominal_pressure = 2000000.0000001
pressure = "p.npy"
)");
  EXPECT_EQ(read_all.problem, "rough");
  EXPECT_EQ(read_all.code, "mycode");
  EXPECT_EQ(read_all.version, "1.0");
  EXPECT_EQ(read_all.method, "guessing");
  EXPECT_EQ(read_all.accuracy, "best");
  EXPECT_EQ(read_all.element, "Q2");
  EXPECT_EQ(read_all.authors, (std::vector<std::string>{"A. Name", "B. Name"}));
  EXPECT_EQ(read_all.licence, "CC0-1.0");
  EXPECT_EQ(read_all.machine, "a laptop");
  EXPECT_EQ(read_all.claimed_error, 1e-6);
  ASSERT_EQ(read_all.loads.size(), 2U);
  const SubmittedLoad& load = read_all.loads[0];
  EXPECT_EQ(load.load, 2U);
  EXPECT_EQ(load.mean_gap, 1e-7);
  EXPECT_EQ(load.area_fraction, 0.5);
  EXPECT_EQ(load.elastic_energy, 3.0);
  EXPECT_EQ(load.cpu_time, 1.5);
  EXPECT_EQ(load.iterations, 7);
  EXPECT_EQ(load.rows, 64U);
  EXPECT_EQ(load.pressure, problem.heights);
  EXPECT_EQ(read_all.loads[1].load, 0U);
  EXPECT_TRUE(std::isnan(read_all.loads[1].mean_gap));
}

TEST_F(SubmissionFolder, TurnsForcesOfNodesIntoPressures) {
  const std::string load =
      "[[load]]\nnominal_pressure = 2e6\nnodal_force = \"p.npy\"\n";
  const Submission found = read(head + load);
  for (std::size_t i = 0; i < problem.heights.size(); ++i)
    ASSERT_DOUBLE_EQ(found.loads[0].pressure[i],
                     problem.heights[i] / (1e-6 * 1e-6));
  expect(head + load + "pressure = \"p.npy\"\n",
         "has a pressure and a nodal_force, but must have one of them");
}

TEST_F(SubmissionFolder, SaysHowTimesWereMeasured) {
  problem.heights_hash = "abc";
  const std::string load =
      "[[load]]\nnominal_pressure = 2e6\npressure = \"p.npy\"\n";
  const std::string timing =
      "[timing]\nrun = \"a run\"\npairs = 3\nthreads = 1\n";
  const Submission found =
      read(head + timing + "heights = \"abc\"\n" + load +
           "cpu_time = 2\ncpu_time_low = 1\ncpu_time_high = 3\n"
           "peak_memory = 5e6\n");
  ASSERT_TRUE(found.timing);
  EXPECT_EQ(found.timing->run, "a run");
  EXPECT_EQ(found.timing->pairs, 3);
  EXPECT_EQ(found.timing->threads, 1);
  EXPECT_EQ(found.loads[0].cpu_time_low, 1.0);
  EXPECT_EQ(found.loads[0].cpu_time_high, 3.0);
  EXPECT_EQ(found.loads[0].peak_memory, 5e6);
  expect(head + timing + load, "timing.heights is missing");
  expect(head + timing + "heights = \"ab\"\n" + load,
         "the times are of another surface");
  expect(head + "[timing]\npairs = 1\n" + load,
         "timing.pairs = 1, but must be a number from 2");
  expect(head + load + "cpu_time = 4\ncpu_time_low = 1\ncpu_time_high = 3\n",
         "cpu_time must be between it and cpu_time_high");
}

TEST_F(SubmissionFolder, NamesEveryMistake) {
  const std::string load =
      "[[load]]\nnominal_pressure = 2e6\npressure = \"p.npy\"\n";
  expect(head, "has neither [[load]] with a pressure field nor [curve]");
  expect(load, "problem is missing");
  expect("version = 1\n" + load, "submission.toml:1: version = 1, but must be");
  expect("problem = \"smooth\"\n" + load,
         "problem = \"smooth\", but problem.json is \"rough\"");
  expect(head + "licens = \"MIT\"\n" + load,
         "submission.toml:8: licens is unknown; nearest: licence");
  expect("accuracy = \"good\"\n" + load, "must be \"default\" or \"best\"");
  expect("authors = \"A\"\n" + load, "must be a list of 1 to 100 texts");
  expect("authors = []\n" + load, "must be a list of 1 to 100 texts");
  expect(head + "claimed_error = 2\n" + load,
         "claimed_error = 2, but must be a number from 0 to 1");
  expect(head + "[[load]]\nnominal_pressure = 3e6\npressure = \"p.npy\"\n",
         "must be a load of the problem [Pa]: 2000000, 5000000, 20000000");
  expect(head + "[[load]]\nnominal_pressure = nan\npressure = \"p.npy\"\n",
         "must be a finite number >= 0");
  expect(head + "[[load]]\npressure = \"p.npy\"\n",
         "nominal_pressure is missing");
  expect(head + load + load, "is the second one at the load");
  expect(head + load + "contact_area_fraction = 40\n",
         "must be a number from 0 to 1");
  expect(head + load + "iterations = 1.5\n", "must be a whole number");
  expect(head + load + "cpu_time = -1\n", "must be a finite number >= 0");
  expect(head + load + "gap = 1\n", "unknown; nearest: mean_gap");
  expect(head + "[[load]]\nnominal_pressure = 2e6\npressure = \"../p.npy\"\n",
         "must be a file of this folder");
  expect(head + "[[load]]\nnominal_pressure = 2e6\npressure = \"/p.npy\"\n",
         "must be a file of this folder");
  expect(head + "[[load]]\nnominal_pressure = 2e6\npressure = \"q.npy\"\n",
         "q.npy");
  expect(head + "load = 3\n", "neither [[load]]");
  expect("code = [\n", "1 mistake(s) in submission.toml\n");
  expect("code = [\n", "is not TOML");
}

// Each kind of file is read, and others are refused.
TEST_F(SubmissionFolder, ReadsTextAndRefusesInvalidFields) {
  const auto with_file = [&](const std::string& name) {
    return head + "[[load]]\nnominal_pressure = 2e6\npressure = \"" + name +
           "\"\n";
  };
  write("p.csv", "1,2,3\n4,5,6\n");
  const Submission csv = read(with_file("p.csv"));
  EXPECT_EQ(csv.loads[0].rows, 2U);
  EXPECT_EQ(csv.loads[0].columns, 3U);
  EXPECT_EQ(csv.loads[0].pressure,
            (std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0, 6.0}));
  write("p.png", "x");
  expect(with_file("p.png"), "has the ending \".png\"; allowed are .npy");
  write("p.h5", "this is not HDF5");
  EXPECT_NE(message_of(with_file("p.h5")), "accepted");
  std::vector<double> broken = problem.heights;
  broken[5] = not_a_number;
  write("n.npy", surfaces::npy_bytes(broken, 64, 64));
  expect(with_file("n.npy"), "has a number that is not finite");
  broken[5] = -2e30;
  write("n.npy", surfaces::npy_bytes(broken, 64, 64));
  expect(with_file("n.npy"), "has a pressure of magnitude 2e+30 Pa, but at "
                             "most 1e+30 Pa may be");
}

TEST_F(SubmissionFolder, NamesStepsOfAPathWithAdhesion) {
  problem = problems::sticky_problem();
  const std::string rest = "pressure = \"p.npy\"\n";
  const Submission found =
      read(head + "[[load]]\nstep = 1\nenergy = -1e-3\n" + rest);
  ASSERT_EQ(found.loads.size(), 1U);
  EXPECT_EQ(found.loads[0].load, 1U);
  EXPECT_EQ(found.loads[0].energy, -1e-3);
  expect(head + "[[load]]\n" + rest, "step is missing");
  expect(head + "[[load]]\nstep = 2\n" + rest,
         "step = 2, but the steps of the path are 0 to 1");
  expect(head + "[[load]]\nstep = -1\n" + rest, "must be a number from 0");
  expect(head + "[[load]]\nstep = 0.5\n" + rest, "must be a whole number");
  expect(head + "[[load]]\nstep = 0\n" + rest + "[[load]]\nstep = 0\n" + rest,
         "is the second one at the load");
  expect(head + "[[load]]\nstep = 0\nmean_gap = 1e-7\n" + rest,
         "load.mean_gap is unknown");
}

TEST_F(SubmissionFolder, ReadsACurve) {
  const std::string header =
      "nominal_pressure [Pa],mean_gap [m],area_fraction [1]\n";
  const std::string with_curve = head + "[curve]\nfile = \"c.csv\"\n";
  write("c.csv", header + "1e6,2e-7,0.1\n2e6,1e-7,0.2\n");
  const Submission curve = read(with_curve);
  ASSERT_EQ(curve.curve.size(), 2U);
  EXPECT_EQ(curve.curve[1].nominal_pressure, 2e6);
  EXPECT_EQ(curve.curve[1].mean_gap, 1e-7);
  EXPECT_EQ(curve.curve[1].area_fraction, 0.2);
  write("c.csv", header + "1e6,2e-7,0.1\n2e6,1e-7,1.2\n");
  expect(with_curve, "c.csv:3: must have three numbers");
  write("c.csv", "p,u,A\n1,2,3\n");
  expect(with_curve, "c.csv:1: begins with \"p,u,A\", but must begin with");
}

} // namespace asperity::exchange::submission_test
