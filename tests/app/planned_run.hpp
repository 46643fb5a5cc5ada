#pragma once

// A case on a small grid and its plan.

#include "app/cache/cache.hpp"
#include "app/plan/plan.hpp"
#include "cases/reader/read_case.hpp"

#include <string>
#include <vector>

#include "tests/app/folder.hpp"
#include "tests/app/rough_case.hpp"

namespace asperity::app {

inline const std::string planned_case =
    rough_case("planned", 32, four_loads, R"([halfspace]
contact = "hard"
[fem]
contact = "hard"
)");

class PlannedRun : public FolderTest {
protected:
  static cases::Case read(const std::vector<std::string>& overrides = {}) {
    return cases::read_case_text(planned_case, "planned.toml", overrides);
  }

  Plan plan(const std::vector<std::string>& overrides = {},
            const std::vector<std::string>& methods = {}) {
    return make_plan(read(overrides),
                     {folder / "out", methods, false, 2, "", &cache}, 32);
  }

  Cache cache{folder / "cache", 100'000'000};
};

} // namespace asperity::app
