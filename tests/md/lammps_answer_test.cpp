// Tests of md/lammps/lammps_answer.hpp: the output of LAMMPS is read completely
// or refused, and a log that is still being written is read correctly.
#include "md/lammps/lammps_answer.hpp"
#include "md/lammps/lammps_input.hpp"
#include "md/lammps/lammps_units.hpp"
#include "tests/md/lammps_requests.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

namespace asperity::md::lammps_answer_test {

const std::string log_of_two = "LAMMPS (29 Sep 2021 - Update 2)\n"
                               "Step PotEng E_bond E_vdwl Fnorm c_push[3] \n"
                               "       0   10.5   1.5   9   0.25   2\n"
                               "      20   10.25   1.75   8.5   0.125   4\n"
                               "Loop time of 3 on 1 procs for 20 steps\n"
                               "  Iterations, force evaluations = 20 39\n"
                               "      40   10   1.8   8.2   0.0625   8\n"
                               "  Iterations, force evaluations = 20 41\n";

TEST(LammpsLog, LastWholeLineOfNumbersIsTheProgress) {
  const auto progress =
      progress_in(log_of_two + "      60   9   1   8   0.03   1");

  ASSERT_TRUE(progress);
  EXPECT_EQ(progress->iterations, 40);
  EXPECT_DOUBLE_EQ(progress->energy, 10.0 * metal::energy);
  EXPECT_DOUBLE_EQ(progress->force_norm, 0.0625 * metal::force);
  EXPECT_DOUBLE_EQ(progress->push, 8.0 * metal::force);
  EXPECT_FALSE(progress_in("LAMMPS (29 Sep 2021)\nunits metal\n"));
}

TEST(LammpsLog, EvaluationsOfAllMinimisationsAddUp) {
  EXPECT_EQ(evaluations_in(log_of_two), 39 + 41);
  EXPECT_EQ(evaluations_in(""), 0);
}

TEST(LammpsLog, ErrorIsLammpsOwnLine) {
  EXPECT_EQ(error_in("run 0\nERROR: Atoms lost (src/a.cpp:3)\nLast command\n"),
            "ERROR: Atoms lost (src/a.cpp:3)");
  EXPECT_EQ(error_in(log_of_two), "");
}

class LammpsAnswerFiles : public testing::Test {
protected:
  LammpsAnswerFiles() { std::filesystem::create_directories(folder); }

  ~LammpsAnswerFiles() override { std::filesystem::remove_all(folder); }

  void write(const char* name, const std::string& text) const {
    std::ofstream(folder / name) << text;
  }

  /// A dump whose atom i has the numbers i + 0.1, i + 0.2, ...
  static std::string dump(std::size_t atoms, int columns) {
    std::string text = "ITEM: TIMESTEP\n7\nITEM: ATOMS id ...\n";
    for (std::size_t i = 1; i <= atoms; ++i) {
      text += std::to_string(i);
      for (int column = 1; column <= columns; ++column)
        text += " " + std::to_string(i) + "." + std::to_string(column);
      text += "\n";
    }
    return text;
  }

  LammpsBlock block = lammps_block(problems::small_request(8, 1, 0.05));
  std::filesystem::path folder = problems::small_request(8, 1, 0.05).scratch;
};

TEST_F(LammpsAnswerFiles, AreReadInSi) {
  write(lammps_file::answer, dump(128, 6));
  write(lammps_file::contact, dump(64, 3));
  write(lammps_file::energies, "1.5 0.25\n");

  const LammpsAnswer answer = read_answer(block, folder);

  ASSERT_EQ(answer.positions.size(), 128U);
  ASSERT_EQ(answer.contact.size(), 64U);
  EXPECT_DOUBLE_EQ(answer.positions[127][2], 128.3 * metal::length);
  EXPECT_DOUBLE_EQ(answer.forces[0][0], 1.4 * metal::force);
  EXPECT_DOUBLE_EQ(answer.contact[63][2], 64.3 * metal::force);
  EXPECT_DOUBLE_EQ(answer.bond_energy, 1.5 * metal::energy);
  EXPECT_DOUBLE_EQ(answer.pair_energy, 0.25 * metal::energy);
}

TEST_F(LammpsAnswerFiles, MissingOrTruncatedAreRefusedByName) {
  const auto refusal = [&] {
    try {
      read_answer(block, folder);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  const auto expect_named = [&](const char* name) {
    EXPECT_NE(refusal().find(name), std::string::npos) << refusal();
  };

  expect_named(lammps_file::answer);
  const std::string whole = dump(128, 6);
  write(lammps_file::answer, whole.substr(0, whole.size() - 8));
  expect_named(lammps_file::answer);
  write(lammps_file::answer, whole);
  expect_named(lammps_file::contact);
  // not in the numbering of the block
  std::string shifted = dump(65, 3);
  shifted.erase(shifted.find("\n1 "),
                shifted.find("\n2 ") - shifted.find("\n1 "));
  write(lammps_file::contact, shifted);
  expect_named(lammps_file::contact);
  write(lammps_file::contact, dump(64, 3));
  expect_named(lammps_file::energies);
}

} // namespace asperity::md::lammps_answer_test
