#pragma once

// A case on a small grid and its plan.

#include "input/reader/read_case.hpp"
#include "run/methods/cache/cache.hpp"
#include "run/plan/plan.hpp"
#include "tests/folder.hpp"
#include "tests/rough_case.hpp"

#include <string>
#include <vector>

namespace asperity::run {

inline const std::string planned_case =
    tests::rough_case("planned", 32, tests::four_loads, R"([halfspace]
contact = "hard"
[fem]
contact = "hard"
)");

class PlannedRun : public tests::FolderTest {
protected:
  static cases::Case read(const std::vector<std::string>& overrides = {}) {
    return cases::read_case_text(planned_case, "planned.toml", overrides);
  }

  Plan plan(const std::vector<std::string>& overrides = {},
            const std::vector<std::string>& methods = {}) {
    return make_plan(read(overrides),
                     {folder / "out", {methods}, false, 2, "", &cache});
  }

  methods::Cache cache{folder / "cache", 100'000'000};
};

} // namespace asperity::run
