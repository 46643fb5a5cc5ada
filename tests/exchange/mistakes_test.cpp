// Tests of suite/exchange/mistakes.hpp: each of 32 faults that are introduced
// into a correct answer is named, and a correct answer has none.
#include "input/input_error.hpp"
#include "suite/exchange/mistakes.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "problems.hpp"

namespace asperity::exchange::mistakes_test {

using Field = std::vector<double>;

constexpr std::size_t side = 64;

Field permuted(
    const Field& field,
    const std::function<std::size_t(std::size_t, std::size_t)>& from) {
  Field result(field.size());
  for (std::size_t i = 0; i < side; ++i)
    for (std::size_t j = 0; j < side; ++j)
      result[i * side + j] = field[from(i, j)];
  return result;
}

Field scaled(Field field, double factor) {
  for (double& value : field)
    value *= factor;
  return field;
}

/// A fault and a part of the sentence that names it.
struct Fault {
  const char* name;
  std::function<Field(const Problem&)> field;
  const char* sentence;
};

/// The answer at the second load of a problem that was changed.
Field answer_to(const Problem& problem,
                const std::function<void(Problem&)>& change) {
  Problem changed = problem;
  change(changed);
  return problems::solved(changed, problem.loads[1]);
}

Field right(const Problem& problem) {
  return problems::solved(problem, problem.loads[1]);
}

Fault with_factor(const char* name, double factor, const char* sentence) {
  return {name,
          [factor](const Problem& problem) {
            return scaled(right(problem), factor);
          },
          sentence};
}

Fault moved(const char* name,
            const std::function<std::size_t(std::size_t, std::size_t)>& from,
            const char* sentence) {
  return {
      name,
      [from](const Problem& problem) { return permuted(right(problem), from); },
      sentence};
}

Fault another(const char* name, const std::function<void(Problem&)>& change,
              const char* sentence) {
  return {
      name,
      [change](const Problem& problem) { return answer_to(problem, change); },
      sentence};
}

std::size_t at(std::size_t i, std::size_t j) {
  return i % side * side + j % side;
}

std::vector<Fault> faults_of_load() {
  return {
      with_factor("kPa", 1e-3, "in kPa"),
      with_factor("MPa", 1e-6, "in MPa"),
      with_factor("GPa", 1e-9, "GPa"),
      with_factor("bar", 1e-5, "in bar"),
      with_factor("atm", 1.0 / 101325.0, "in atm"),
      with_factor("dyn/cm^2", 10.0, "in dyn/cm^2"),
      with_factor("relative to the load", 1.0 / 5e6, "relative to the load"),
      with_factor("force of a node", 1e-12, "the force of each node"),
      with_factor("divided by the number", 1.0 / 4096.0,
                  "divided by the number of nodes"),
      with_factor("sign", -1.0, "compression must be positive"),
      with_factor("sign and MPa", -1e-6, "MPa, and compression must be"),
      with_factor("half the load", 0.5, "0.5 times the load"),
      with_factor("a thousandth", 1.005, "more than a thousandth"),
      {"load of another step",
       [](const Problem& problem) {
         return problems::solved(problem, problem.loads[2]);
       },
       "the answer at the load 2e+07 Pa"},
      {"all zero",
       [](const Problem& problem) { return Field(problem.grid.size(), 0.0); },
       "the mean pressure is 0"}};
}

std::vector<Fault> faults_of_place() {
  const auto reverse = [](std::size_t i) { return side - 1 - i; };
  return {
      moved(
          "transposed", [](auto i, auto j) { return at(j, i); },
          "better with transposed"),
      moved(
          "rows reversed", [=](auto i, auto j) { return at(reverse(i), j); },
          "better with its rows in reverse order"),
      moved(
          "columns reversed", [=](auto i, auto j) { return at(i, reverse(j)); },
          "better with its columns in reverse order"),
      moved(
          "turned by 180 degrees",
          [=](auto i, auto j) { return at(reverse(i), reverse(j)); },
          "its rows in reverse order, its columns in reverse order"),
      moved(
          "turned by 90 degrees",
          [=](auto i, auto j) { return at(reverse(j), i); },
          "better with transposed, its"),
      moved(
          "shifted by a row", [](auto i, auto j) { return at(i + 1, j); },
          "shifted by 1 rows and 0 columns"),
      moved(
          "shifted by columns", [](auto i, auto j) { return at(i, j + 3); },
          "shifted by 0 rows and 3 columns"),
      moved(
          "centred", [](auto i, auto j) { return at(i + 32, j + 32); },
          "shifted by 32 rows and 32 columns"),
      another(
          "valleys",
          [](Problem& problem) {
            problem.heights = scaled(problem.heights, -1.0);
          },
          "the sign of the heights reversed")};
}

std::vector<Fault> faults_of_scale() {
  return {another(
              "one body instead of two",
              [](Problem& problem) { problem.body.contact_modulus *= 2.0; },
              "one or of two bodies"),
          another(
              "two bodies instead of one",
              [](Problem& problem) { problem.body.contact_modulus *= 0.5; },
              "one or of two bodies"),
          another(
              "E instead of E*",
              [](Problem& problem) { problem.body.contact_modulus *= 0.91; },
              "E* = E/(1 - nu^2) is not E"),
          another(
              "modulus off",
              [](Problem& problem) { problem.body.contact_modulus *= 1.3; },
              "of a modulus 1.3"),
          another(
              "heights off",
              [](Problem& problem) {
                problem.heights = scaled(problem.heights, 1.5);
              },
              "or of heights 0.6667 times"),
          another(
              "free boundaries",
              [](Problem& problem) {
                problem.body.border = mechanics::Border::free;
              },
              "that of free boundaries, but those of this problem are "
              "periodic"),
          {"tension",
           [](const Problem& problem) {
             Field field = right(problem);
             *std::ranges::find(field, 0.0) = -0.01 * problem.loads[1];
             return field;
           },
           "the largest tension is 0.01"},
          {"everywhere in tension and compression",
           [](const Problem& problem) {
             Field field(problem.grid.size(), problem.loads[1]);
             field[0] -= 100.0 * problem.loads[1];
             field[1] += 100.0 * problem.loads[1];
             return field;
           },
           "the largest tension is 99"}};
}

class Mistakes : public testing::Test {
protected:
  std::vector<std::string> found(const Field& field, std::size_t load = 1) {
    SubmittedLoad submitted;
    submitted.load = load;
    submitted.file = "p.npy";
    submitted.rows = submitted.columns = side;
    submitted.pressure = field;
    return recognised_mistakes(*problems::operator_of(problem), problem,
                               submitted);
  }

  Problem problem = problems::rough_problem();
};

TEST_F(Mistakes, AreNamed) {
  std::size_t planted = 0;
  for (const auto& faults :
       {faults_of_load(), faults_of_place(), faults_of_scale()})
    for (const Fault& fault : faults) {
      ++planted;
      std::string all;
      for (const std::string& sentence : found(fault.field(problem)))
        all += sentence + "\n";
      EXPECT_NE(all.find(fault.sentence), std::string::npos)
          << fault.name << ": " << all;
    }
  EXPECT_EQ(planted, 32U);
}

// Answers with the errors of a solver have no mistake: tolerances from 1e-3 to
// 1e-9 at each load, and noise of 1 % on the pressure.
TEST_F(Mistakes, AreNoneInAnAnswer) {
  for (std::size_t load = 0; load < problem.loads.size(); ++load)
    for (const double tolerance : {1e-3, 1e-5, 1e-9})
      EXPECT_EQ(found(problems::solved(problem, problem.loads[load], tolerance),
                      load),
                std::vector<std::string>{});
  Field noisy = right(problem);
  double sum = 0.0;
  for (std::size_t i = 0; i < noisy.size(); ++i)
    sum += noisy[i] *= 1.0 + 0.01 * std::sin(1e3 * static_cast<double>(i));
  noisy = scaled(noisy, problem.loads[1] * 4096.0 / sum);
  EXPECT_EQ(found(noisy), std::vector<std::string>{});
}

// With free boundaries, the answer on a periodic cell is one.
TEST_F(Mistakes, AreThoseOfTheBoundariesOfTheProblem) {
  const Field periodic = right(problem);
  problem.body.border = mechanics::Border::free;
  EXPECT_EQ(found(right(problem)), std::vector<std::string>{});
  EXPECT_EQ(found(periodic),
            std::vector<std::string>{
                "the field is that of periodic boundaries, but those of this "
                "problem are free"});
}

// Symmetric problems have no orientation, and none is reported as missing.
TEST_F(Mistakes, AreNoneInASymmetricAnswer) {
  for (std::size_t i = 0; i < side; ++i)
    for (std::size_t j = 0; j < side; ++j)
      problem.heights[i * side + j] =
          1e-6 * std::cos(2.0 * M_PI * static_cast<double>(i) / 64.0) *
          std::cos(2.0 * M_PI * static_cast<double>(j) / 64.0);
  problem.rms_height = rms_height(problem.heights);
  for (const double tolerance : {1e-3, 1e-6, 1e-10})
    EXPECT_EQ(found(problems::solved(problem, problem.loads[1], tolerance)),
              std::vector<std::string>{});
}

std::string grid_message(std::size_t rows, std::size_t columns) {
  Problem problem = problems::rough_problem();
  problem.grid.points_y = 32;
  SubmittedLoad load;
  load.file = "p.npy";
  load.rows = rows;
  load.columns = columns;
  return tests::message_of<input::InputError>(
      [&] { require_grid(problem, load); });
}

TEST(RequireGrid, NamesWhatIsWrong) {
  EXPECT_EQ(grid_message(32, 64), "accepted");
  EXPECT_NE(grid_message(64, 32).find("it is transposed"), std::string::npos);
  EXPECT_NE(grid_message(33, 65).find("periodic end points"),
            std::string::npos);
  EXPECT_NE(grid_message(1, 2048).find("flattened"), std::string::npos);
  EXPECT_EQ(grid_message(16, 32), "p.npy: has 16 rows and 32 columns, but the "
                                  "problem has 32 and 64");
}

} // namespace asperity::exchange::mistakes_test
