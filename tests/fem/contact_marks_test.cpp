// Tests of fem/adaptive/contact_marks.hpp: the places of the contact surface
// that need the finest cells.
#include "fem/adaptive/contact_marks.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace asperity::fem::contact_marks_test {

/// Eight by eight cells of second order, apart by one length everywhere.
class Marks : public ::testing::Test {
protected:
  std::size_t node(int ix, int iy) const { return grid_.index(ix, iy); }

  void press(int ix, int iy) {
    pressure_[node(ix, iy)] = 1.0;
    gap_[node(ix, iy)] = 0.0;
  }

  /// The marks after an examination of one face.
  ContactMarks examined(const CellRange& face) const {
    ContactMarks marks({grid_, 2, pressure_, gap_, 100.0, 1.0, gap_tolerance_});
    marks.examine(face);
    return marks;
  }

  const Grid grid_{16, 16, 8.0, 8.0}; // a finest cell has an edge of 1
  std::vector<double> pressure_ = std::vector<double>(grid_.size(), 0.0);
  std::vector<double> gap_ = std::vector<double>(grid_.size(), 1.0);
  const CellRange coarse_{0, 4, 0, 4};
  double gap_tolerance_ = 1.0;
};

TEST_F(Marks, AreAbsentWithoutContact) {
  EXPECT_FALSE(examined(coarse_).is_marked_near(coarse_));
  EXPECT_FALSE(examined(coarse_).is_touched(coarse_));
}

// A node between those of a coarse cell penetrates; its own cell is
// marked, and near it are the neighbours, but no cell further away.
TEST_F(Marks, AreWhereANodeWithoutPressurePenetrates) {
  gap_[node(5, 5)] = -1e-9;
  const ContactMarks marks = examined(coarse_);

  EXPECT_TRUE(marks.is_marked_near({2, 3, 2, 3}));
  EXPECT_TRUE(marks.is_marked_near({1, 2, 3, 4}));
  EXPECT_FALSE(marks.is_marked_near({0, 1, 2, 3}));
  EXPECT_FALSE(marks.is_marked_near({2, 3, 4, 5}));
  EXPECT_TRUE(marks.is_touched({2, 3, 2, 3}));
}

// The boundary of a contact is marked, its inside is not.
TEST_F(Marks, FollowTheBoundaryOfTheContact) {
  for (int iy = 0; iy <= 8; ++iy)
    for (int ix = 0; ix <= 5; ++ix)
      press(ix, iy);
  const ContactMarks marks = examined(coarse_);

  EXPECT_TRUE(marks.is_marked_near({2, 3, 1, 2})); // nodes 4, 5 of 4 to 6
  EXPECT_FALSE(marks.is_marked_near({0, 1, 1, 2}));
  EXPECT_TRUE(marks.is_touched({0, 1, 1, 2}));
}

// A smaller gap is marked if the gap has a tolerance of its own.
TEST_F(Marks, FollowGapsAboveTheirTolerance) {
  for (int iy = 0; iy <= 8; ++iy)
    for (int ix = 0; ix <= 8; ++ix)
      press(ix, iy);
  gap_[node(3, 3)] = 0.03;
  EXPECT_FALSE(examined(coarse_).is_marked_near(coarse_));

  gap_tolerance_ = 0.02;
  EXPECT_TRUE(examined(coarse_).is_marked_near({1, 2, 1, 2}));
}

// Inside of a contact, a gap in either direction is marked if it exceeds
// pressure_tolerance H / modulus, which is 0.04 at H = 4 and 0.02 at H = 2.
TEST_F(Marks, FollowHeightsThatACellInContactCannot) {
  for (int iy = 0; iy <= 8; ++iy)
    for (int ix = 0; ix <= 8; ++ix)
      press(ix, iy);
  for (const double direction : {1.0, -1.0}) {
    gap_[node(1, 1)] = 0.03 * direction;
    EXPECT_FALSE(examined(coarse_).is_marked_near(coarse_));
    EXPECT_TRUE(examined({0, 2, 0, 2}).is_marked_near(coarse_));
    gap_[node(1, 1)] = 0.05 * direction;
    EXPECT_TRUE(examined(coarse_).is_marked_near(coarse_));
  }
}

// Cells at opposite sides are neighbours.
TEST_F(Marks, ArePeriodic) {
  gap_[node(1, 1)] = -1.0;
  const ContactMarks marks = examined({0, 1, 0, 1});

  EXPECT_TRUE(marks.is_marked_near({7, 8, 7, 8}));
  EXPECT_FALSE(marks.is_marked_near({6, 7, 7, 8}));
}

} // namespace asperity::fem::contact_marks_test
