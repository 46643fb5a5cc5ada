// Tests of what a plan warns of and refuses before anything is computed.
#include "input/input_error.hpp"
#include "input/reader/read_case.hpp"
#include "run/methods/methods.hpp"
#include "run/plan/plan.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace asperity::run::plan_warnings_test {

const std::string small_case = R"(schema = 1
title = "planned"
[surface]
kind = "wave-1d"
length = "1 um"
amplitude = "1 nm"
wavelength = "1 length"
points = 16
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = [ "1e-3 E*" ]
[halfspace]
contact = "hard"
[fem]
contact = "hard"
)";

class PlanWarnings : public tests::FolderTest {
protected:
  static cases::Case read(const std::vector<std::string>& overrides) {
    return cases::read_case_text(small_case, "planned.toml", overrides);
  }

  Plan plan(const std::vector<std::string>& overrides,
            const std::vector<std::string>& methods = {}) {
    return make_plan(read(overrides),
                     {folder / "out", {methods}, false, 2, "", nullptr});
  }
};

// The description of a method states graded layers only where there are some.
TEST_F(PlanWarnings, DescriptionsStateTheMesh) {
  const auto text = [this](const std::vector<std::string>& overrides) {
    const cases::Case contact_case = read(overrides);
    return methods::describe(contact_case.methods.back(), contact_case.material)
        .text;
  };
  EXPECT_NE(text({"fem.solver=full"}).find("layers from 1 h"),
            std::string::npos);
  EXPECT_NE(text({"fem.solver=full", "mesh.kind=hanging"})
                .find("block, on the mesh of the case, "),
            std::string::npos);
}

// A plan, and the description of the method in a result, warn of elements that
// lock and of no others.
TEST_F(PlanWarnings, AreOfElementsThatLock) {
  const std::vector<std::string> locking{"material.poisson_ratio=0.4999",
                                         "fem.element=Q1"};
  const cases::Case locked = read(locking);

  const Plan planned = plan(locking);

  ASSERT_EQ(planned.warnings.size(), 1U);
  EXPECT_NE(plan_text(planned, locked)
                .find("warning: fem: Q1 elements lock at a Poisson's ratio of "
                      "0.4999"),
            std::string::npos);
  EXPECT_NE(methods::describe(locked.methods.back(), locked.material)
                .text.find("warning: fem: Q1 elements lock"),
            std::string::npos);
  EXPECT_TRUE(plan({}).warnings.empty());
  EXPECT_TRUE(plan(locking, {"halfspace"}).warnings.empty());
}

// An invalid table of factors is refused before anything is planned.
TEST_F(PlanWarnings, ARefusedTableOfFactorsIsNamed) {
  const std::string file = (folder / "factors.txt").string();
  std::ofstream(file) << "# boxes 2 2 2\n1 2\n";

  try {
    plan({"material.variation.kind=table", "material.variation.file=" + file,
          "fem.solver=full", "halfspace.contact=hard"},
         {"fem"});
    FAIL() << "planned";
  } catch (const input::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("factors.txt:2: expected a line"),
              std::string::npos)
        << error.what();
  }
}

} // namespace asperity::run::plan_warnings_test
