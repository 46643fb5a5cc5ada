// Tests of how members are divided among parts: every member exactly once, and
// the same on every machine.
#include "input/input_error.hpp"
#include "run/sweeps/parts.hpp"
#include "tests/run/planned_run.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace asperity::run::parts_test {

using Members = std::vector<std::size_t>;

TEST(MembersOfParts, AreDealtInTurn) {
  NamedCases named;
  named.cases.push_back({});
  named.cases.front().contact_case = cases::read_case_text(
      planned_case, "planned.toml", {"surface.realizations=5"});

  EXPECT_EQ(n_members(named), 5U);
  EXPECT_EQ(members_of(named, {1, 2}), (Members{0, 2, 4}));
  EXPECT_EQ(members_of(named, {2, 2}), (Members{1, 3}));
  EXPECT_EQ(members_of(named, {5, 5}), (Members{4}));
  EXPECT_THROW(members_of(named, {1, 6}), input::InputError);
}

TEST(PartText, IsReadAndWritten) {
  EXPECT_EQ(read_part("3/8"), (Part{3, 8}));
  EXPECT_EQ(read_part("1/1"), (Part{1, 1}));
  EXPECT_EQ(part_text({3, 8}), "3/8");
  for (const char* wrong : {"", "3", "3/", "/8", "0/8", "9/8", "-1/8", "3/-8",
                            "3 / 8", "3/8/9", "a/b", "1.5/3", "99999999999/1"})
    EXPECT_THROW(read_part(wrong), input::InputError) << wrong;
}

} // namespace asperity::run::parts_test
