// Tests of run/methods/step_solver.hpp: whatever a method reports, a row that
// misses what was prescribed is not converged. And of all methods and laws on
// small random problems: what was asked for is reached.
#include "base/temporary_folder.hpp"
#include "input/reader/read_case.hpp"
#include "run/methods/cache/cache.hpp"
#include "run/methods/cache/case_keys.hpp"
#include "run/methods/methods.hpp"
#include "run/methods/theory_method.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace asperity::methods::reached_test {
namespace {

using mechanics::Control;
using results::StepStatus;

/// A method that calls everything converged.
class FakeSolver final : public StepSolver {
public:
  explicit FakeSolver(const Reached& reached) : reached_(reached) {}

private:
  StepAnswer find(const StepTarget&) override {
    StepAnswer answer;
    answer.row.nominal_pressure = 1.0;
    answer.row.mean_gap = 1.0;
    answer.reached = reached_;
    return answer;
  }

  Reached reached_;
};

results::CurvePoint row_of(const mechanics::LoadTarget& asked,
                           const Reached& reached) {
  return FakeSolver(reached).solve({asked}).row;
}

constexpr Reached good{.nominal_pressure = -98.1700001,
                       .mean_gap = 2e-9,
                       .imbalance = 1e-7,
                       .pressure_tolerance = 1e-6,
                       .gap_tolerance = 1e-15};

void expect_caught(const mechanics::LoadTarget& asked, const Reached& reached,
                   const std::string& words) {
  const results::CurvePoint row = row_of(asked, reached);
  EXPECT_EQ(row.status, StepStatus::not_converged) << words;
  EXPECT_NE(row.note.find(words), std::string::npos) << row.note;
}

} // namespace

TEST(Reached, WhatMissesIsNotConverged) {
  const mechanics::LoadTarget load{Control::nominal_pressure, -98.17};
  const mechanics::LoadTarget gap{Control::mean_gap, 2e-9};
  const mechanics::LoadTarget spring{Control::mean_gap, 2e-9 + 98.1700001e-12,
                                     1e12};
  for (const auto& asked : {load, gap, spring}) {
    const results::CurvePoint row = row_of(asked, good);
    EXPECT_EQ(row.status, StepStatus::converged) << row.note;
    EXPECT_EQ(row.note, "");
  }

  Reached missed = good;
  missed.nominal_pressure = -83.9;
  expect_caught(load, missed,
                "asked for a nominal pressure of -98.17 Pa, reached -83.9 Pa");
  expect_caught(spring, missed, "asked for a far end of the spring of");
  missed = good;
  missed.mean_gap = 2.1e-9;
  expect_caught(gap, missed,
                "asked for a mean gap of 2e-09 m, reached 2.1e-09");
  missed = good;
  missed.imbalance = -1e-5;
  expect_caught(load, missed, "the contact law carries -1e-05 Pa less");
  expect_caught(load, {}, "reached nan Pa");
  missed.is_detached = true; // and the note of the method says so
  EXPECT_EQ(row_of(load, missed).status, StepStatus::converged);
}

namespace {

/// Loads of a problem and its method.
struct Problem {
  std::string name, load, method;
  bool is_atomic = false; ///< as large as a few atoms
};

void PrintTo(const Problem& problem, std::ostream* out) {
  *out << problem.name;
}

std::string text_of(const Problem& problem) {
  return fmt::format(R"(schema = 1
title = "reached"
[surface]
kind = "self-affine"
length = "{}"
points = 16
seed = 5
rms_slope = 0.1
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.5 length"
wavelength_short = "4 h"
[material]
youngs_modulus = "{}"
poisson_ratio = 0.3
[load]
{}
{}
)",
                     problem.is_atomic ? "4.16 nm" : "1 um",
                     problem.is_atomic ? "77.2 GPa" : "2 GPa", problem.load,
                     problem.method);
}

class AllMethods : public testing::TestWithParam<Problem> {};

const std::string pressures =
    "nominal_pressure = [\"1e-3 E*\", \"1e-2 E*\", \"5e-2 E*\"]";
const std::string tensions =
    "nominal_pressure = [\"1e-3 E*\", 0.0, \"-1e-5 E*\"]";
const std::string gaps = "mean_gap = [\"1 h_rms\", \"0.3 h_rms\"]";

std::string halfspace(const std::string& keys) {
  return "[halfspace]\n" + keys;
}

std::string sticky(const std::string& law, const std::string& keys = "") {
  return halfspace("contact = \"" + law +
                   "\"\nwork_of_adhesion = \"10 mJ/m^2\"\n" + keys);
}

std::vector<Problem> problems() {
  const std::string free = "\nboundaries = \"free\"";
  const std::string hard = "contact = \"hard\"";
  const std::string penalty = "contact = \"penalty\"\npenalty = \"1 E*/h\"";
  const std::string block = "[fem]\nelement = \"Q1\"\n";
  const std::string full = block + "solver = \"full\"\n";
  const std::string atoms =
      "[md]\natoms = 16\ninteraction_energy = \"74.4 meV\"\n"
      "interaction_distance = \"3.28 angstrom\"\ncutoff = \"10 angstrom\"\n"
      "contact_distance = \"4.3615 angstrom\"";
  std::vector<Problem> all{
      {"hard", pressures, halfspace(hard)},
      {"hard_by_gap", gaps, halfspace(hard)},
      {"hard_free", pressures, halfspace(hard + free)},
      {"penalty", pressures, halfspace(penalty)},
      {"penalty_by_gap", gaps, halfspace(penalty)},
      {"penalty_free", pressures, halfspace(penalty + free)},
      {"augmented", pressures,
       halfspace("contact = \"augmented\"\npenalty = \"1 E*/h\"")},
      {"hardness", pressures, halfspace(hard + "\nhardness = \"0.2 E*\"")},
      {"hardness_by_gap", gaps, halfspace(hard + "\nhardness = \"0.2 E*\"")},
      {"slab", pressures, halfspace(hard + "\nthickness = \"0.2 length\"")},
      {"winkler", pressures, "[winkler]\nstiffness = \"1 E*/h\""},
      {"winkler_by_gap", gaps, "[winkler]\nstiffness = \"1 E*/h\""},
      {"condensed", pressures, block + hard},
      {"condensed_by_gap", gaps, block + hard},
      {"full", pressures, full + hard},
      {"full_by_gap", gaps, full + hard},
      {"full_penalty", pressures, full + penalty},
      {"atoms", pressures, atoms, true},
      {"atoms_by_gap", gaps, atoms, true},
      {"condensed_cubic", tensions,
       block + "contact = \"cubic\"\nwork_of_adhesion = \"10 mJ/m^2\""},
  };
  for (const char* const law :
       {"exponential", "dugdale", "cubic", "lennard-jones",
        "lennard-jones-10-4", "morse"}) {
    std::string name = law;
    std::erase(name, '-');
    all.push_back({name, tensions, sticky(law)});
    all.push_back({name + "_free", tensions, sticky(law, free)});
    all.push_back({name + "_by_gap", gaps, sticky(law)});
    all.push_back({name + "_by_spring",
                   "mean_gap = [\"1 h_rms\", \"-2 h_rms\"]\n"
                   "spring = \"0.05 E*/h\"",
                   sticky(law)});
    all.push_back({name + "_by_stiff_spring", gaps + "\nspring = \"1e7 E*/h\"",
                   sticky(law)});
  }
  return all;
}

} // namespace

TEST_P(AllMethods, ReachWhatIsAskedFor) {
  const cases::Case read =
      cases::read_case_text(text_of(GetParam()), "reached.toml");
  Cache cache;
  const CaseKeys keys(read, "test");
  MethodFactory factory(read, cache, keys);
  const CaseSurfaces surfaces(read, read.methods);
  const cases::MethodSpec& method = read.methods.front();
  const SurfaceOfCase& surface = surfaces.of(method, 0);
  RootWork root;
  const TemporaryFolder scratch("asperity");
  const Resources resources{.scratch = scratch.path(), .root = &root};
  const auto solver = factory.make(method, surface, 0, resources);
  for (std::size_t step = 0; step < read.load.targets.size(); ++step) {
    const mechanics::LoadTarget asked = read.load.target(step, surface.scales);
    const StepAnswer answer = solver->solve({asked, static_cast<int>(step)});

    EXPECT_EQ(answer.row.status, StepStatus::converged) << answer.row.note;
    // The stated tolerance is 1e-8 of the load and of h_rms, or of the largest
    // pressure in a full block; for atoms 1e-4, and 1e-6 d_c.
    const Reached& reached = answer.reached;
    if (!GetParam().is_atomic) {
      double largest = 0.0;
      for (const double pressure : answer.pressure)
        largest = std::max(largest, std::abs(pressure));
      EXPECT_LE(reached.pressure_tolerance, 1.0001e-8 * largest);
      EXPECT_LE(reached.gap_tolerance, 1.0001e-8 * surface.scales.rms_height);
    } else {
      EXPECT_LE(reached.pressure_tolerance,
                1.8e-4 * answer.row.nominal_pressure);
      EXPECT_LE(reached.gap_tolerance, 1e-6 * 4.4e-10);
    }
    if (asked.control == Control::nominal_pressure) {
      EXPECT_NEAR(answer.row.nominal_pressure, asked.amount,
                  reached.pressure_tolerance);
    } else if (std::isinf(asked.spring)) {
      EXPECT_NEAR(answer.row.mean_gap, asked.amount, reached.gap_tolerance);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Problems, AllMethods, testing::ValuesIn(problems()),
                         [](const auto& problem) {
                           return problem.param.name;
                         });

} // namespace asperity::methods::reached_test
