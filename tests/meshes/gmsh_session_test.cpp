// Tests of meshes/gmsh_session.hpp.
#include "meshes/gmsh_session.hpp"
#include "tests/message_of.hpp"

#include <gmsh.h>
#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>
#include <string>

namespace asperity::meshes::gmsh_session_test {

std::string refusal(const std::function<void()>& work) {
  return tests::message_of<std::domain_error>([&] { in_gmsh(work); });
}

// Verifies that gmsh's message reaches the caller and that the next session
// starts empty (an incomplete model would still have its point).
TEST(InGmsh, ReportsGmshsMessageAndRecovers) {
  EXPECT_EQ(refusal([] {
              gmsh::model::geo::addPoint(0, 0, 0, 0, 7);
              gmsh::model::mesh::setTransfiniteCurve(99, 3);
            }),
            "gmsh: Curve 99 does not exist");

  gmsh::vectorpair entities;
  EXPECT_EQ(refusal([&] {
              gmsh::model::geo::synchronize();
              gmsh::model::getEntities(entities);
            }),
            "accepted");
  EXPECT_TRUE(entities.empty());
}

TEST(InGmsh, PassesOurOwnRefusalsOn) {
  EXPECT_EQ(refusal([] { throw std::domain_error("ours"); }), "ours");
}

TEST(InGmsh, LeavesSignalsAlone) {
  struct sigaction before {};

  struct sigaction within {};

  sigaction(SIGINT, nullptr, &before);

  in_gmsh([&] { sigaction(SIGINT, nullptr, &within); });

  EXPECT_EQ(before.sa_handler, within.sa_handler);
}

TEST(InGmsh, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();

  in_gmsh([] {
    gmsh::model::occ::addBox(0, 0, 0, 1, 1, 1);
    gmsh::model::occ::synchronize();
    gmsh::model::mesh::generate(3);
  });

  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace asperity::meshes::gmsh_session_test
