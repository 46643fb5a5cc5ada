// Which nodes are in contact, which are open, and that no node is both.
#include "mechanics/contact_nodes.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace asperity::mechanics::contact_nodes_test {
namespace {

using Set = std::vector<std::uint8_t>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Without tension: in contact under pressure, whatever the gap. A node without
// pressure is open beyond the tolerance and neither within it.
TEST(ContactNodes, AreThoseUnderPressure) {
  const std::vector<double> pressure{0.0, 1.0, 1e-300, 0.0, 0.0, none},
      gap{2.0, 2.0, -1.0, 1e-9, -1.0, 2.0};
  const ContactNodes nodes({ContactField::pressure, 1e-8}, pressure, gap);
  EXPECT_EQ(nodes.contact_set(), (Set{0, 1, 1, 0, 0, 0}));
  EXPECT_EQ(nodes.open_set(), (Set{1, 0, 0, 0, 0, 1}));
  EXPECT_EQ(nodes.open_gaps(), (std::vector<double>{2.0, 0, 0, 0, 0, 2.0}));
}

// With adhesion the roundoff of an open node's pressure, of either sign, and
// the tension of a closed one say nothing.
TEST(ContactNodes, AreThoseOfClosedGaps) {
  const std::vector<double> pressure{1e-12, -1e-12, -5.0, 5.0, 3.0},
      gap{2.0, 1e-9, 0.0, 0.0, -1e-12};
  const ContactNodes nodes({ContactField::gap, 1e-8}, pressure, gap);
  EXPECT_EQ(nodes.contact_set(), (Set{0, 0, 1, 1, 1}));
  EXPECT_EQ(nodes.open_set(), (Set{1, 0, 0, 0, 0}));
}

} // namespace
} // namespace asperity::mechanics::contact_nodes_test
