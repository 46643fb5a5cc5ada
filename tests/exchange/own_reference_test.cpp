// Tests of suite/exchange/answers/own_reference.hpp: a problem is handed out
// only if its reference is certified through the files that state it.
#include "input/reader/read_case.hpp"
#include "suite/exchange/answers/own_reference.hpp"
#include "suite/exchange/problem_folder.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace asperity::exchange::own_reference_test {

namespace fs = std::filesystem;

/// A rough surface on a block with a stiff layer.
const std::string layered = R"(schema = 1
title = "A coating"
[surface]
kind = "self-affine"
length = "1 um"
points = 32
seed = 1
rms_height = "3 nm"
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.5 length"
wavelength_short = "8 h"
[material]
contact_modulus = "2 GPa"
poisson_ratio = 0.3
[[material.layers]]
thickness = "0.05 length"
youngs_modulus = "10 GPa"
poisson_ratio = 0.25
[load]
nominal_pressure = ["0.002 E*", "0.02 E*"]
[halfspace]
)";

class OwnReference : public testing::Test {
protected:
  OwnReference() {
    fs::remove_all(folder);
    stated.problem.body.layers.clear();
  }

  ~OwnReference() override { fs::remove_all(folder); }

  static void write(const AnsweredProblem& problem, const fs::path& folder) {
    write_problem(problem.problem, problem.answers, problem.continuum, "",
                  folder);
  }

  fs::path folder = fs::path(testing::TempDir()) / "asperity-own-reference";
  AnsweredProblem answered =
      answered_problem(cases::read_case_text(layered, "case.toml"), "");
  /// The same answers to what states the plain half-space.
  AnsweredProblem stated = answered;
};

TEST_F(OwnReference, IsTheAnswerToWhatIsStated) {
  write_certified_problem(answered, "", folder);

  EXPECT_EQ(broken_reference(answered, folder), "");
  EXPECT_EQ(read_problem(folder).body.layers.size(), 1U);
}

TEST_F(OwnReference, IsNoAnswerToAnotherProblemJson) {
  write(stated, folder);

  const std::string broken = broken_reference(answered, folder);

  EXPECT_NE(broken.find("as problem.json states it, p_0 = 4e+06 Pa"),
            std::string::npos)
      << broken;
  EXPECT_NE(broken.find("does not hold: the mean gap"), std::string::npos)
      << broken;
}

TEST_F(OwnReference, IsNoAnswerToAnotherReadme) {
  write(answered, folder);

  const std::string broken = broken_reference(stated, folder);

  EXPECT_EQ(broken.find("problem.json"), std::string::npos) << broken;
  EXPECT_NE(broken.find("as README.md states it"), std::string::npos) << broken;
}

// Also numbers that are stated beside the pressure follow from it.
TEST_F(OwnReference, HasTheGapAndTheEnergyOfItsPressure) {
  write(answered, folder);
  for (double ProblemAnswer::*number :
       {&ProblemAnswer::mean_gap, &ProblemAnswer::elastic_energy}) {
    AnsweredProblem wrong = answered;
    wrong.answers[1].*number *= 1.01;

    EXPECT_NE(broken_reference(wrong, folder).find("does not hold"),
              std::string::npos);
  }
}

// A path with adhesion: the same pressures are no minima of a stronger
// attraction.
TEST_F(OwnReference, IsAPathOfMinimaWithAdhesion) {
  std::string text = layered;
  text.replace(text.find("nominal_pressure"), std::string::npos,
               "mean_gap = [\"3 h_rms\", \"2 h_rms\"]\n[halfspace]\n"
               "contact = \"exponential\"\n"
               "work_of_adhesion = \"100 mJ/m^2\"\nrange = \"3 nm\"\n");
  answered = answered_problem(cases::read_case_text(text, "case.toml"), "");
  stated = answered;
  stated.problem.adhesion->work_of_adhesion *= 1.01;

  write_certified_problem(answered, "", folder);
  EXPECT_EQ(broken_reference(answered, folder), "");
  fs::remove_all(folder);
  write(stated, folder);
  const std::string broken = broken_reference(answered, folder);

  EXPECT_NE(broken.find("does not hold: the energy is"), std::string::npos)
      << broken;
}

TEST_F(OwnReference, IsNotHandedOutIfItIsNone) {
  const std::string message = tests::message_of<std::logic_error>(
      [&] { write_certified_problem(stated, "", folder); });

  EXPECT_NE(message.find("another problem than the files would state"),
            std::string::npos)
      << message;
  EXPECT_FALSE(fs::exists(folder));
}

} // namespace asperity::exchange::own_reference_test
