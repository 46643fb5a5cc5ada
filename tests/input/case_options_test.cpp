// Tests of input/case_options.hpp: how a message names what sets a key.
#include "input/case_options.hpp"

#include <gtest/gtest.h>

namespace asperity::input::case_options_test {

TEST(CaseOptions, AreNamedWhereAKeyHasOne) {
  EXPECT_EQ(setting("surface.remove_spikes", "8"), "--remove-spikes 8");
  EXPECT_EQ(setting("load.nominal_pressure", "1 MPa"), "--pressure \"1 MPa\"");
  EXPECT_EQ(setting("surface.align_lines", "median"),
            "--set surface.align_lines=median");
  EXPECT_EQ(setting("surface.crop_x", "1 um"), "--set \"surface.crop_x=1 um\"");
}

} // namespace asperity::input::case_options_test
