// Tests of input/reader/bound_key.hpp: a row of the vocabulary says how a key
// is read, what its default is, and when it is needed.
#include "input/reader/bound_key.hpp"
#include "input/reader/read_case.hpp"
#include "input/text/toml_text.hpp"
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>

#include <string>

namespace asperity::cases::vocabulary_test {

enum class Wheel { slow, fast };

struct Mill {
  Wheel wheel = Wheel::slow;
  double share = 1e-8;
  mechanics::Quantity depth{0.25, mechanics::ReferenceUnit::length};
  double mass = 0.0;
  std::optional<int> blades;
  bool is_open = true;
  int turns = 0;
};

bool is_fast(const Mill& mill) {
  return mill.wheel == Wheel::fast;
}

Table mill_table() {
  return {.name = "mill",
          .description = "A mill.",
          .keys = {
              key<&Mill::wheel>("wheel", {"slow", "fast"}, "Its wheel."),
              key<&Mill::share>("share", between(0.0, 1.0), "Its share."),
              key<&Mill::depth>("depth", by_the_grid(), "Its depth."),
              key<&Mill::mass>("mass", Dimension::mass, "Its mass.",
                               needed("3 kg")),
              key<&Mill::blades>("blades", between(2, 9), "Its blades.",
                                 eg("4", "default: unknown")),
              key<&Mill::is_open>("open", ValueType::boolean, "It is open."),
              where<Mill>(is_fast, key<&Mill::turns>("turns", at_least(1),
                                                     "Turns an hour.",
                                                     needed("7", "if fast"))),
          }};
}

/// A mill, and the mistakes in its text.
struct MillReading {
  Mill mill;
  std::string mistakes;
};

MillReading read_mill(const std::string& text) {
  const Table table = mill_table();
  const Node file = parse_toml("[mill]\n" + text, "mill.toml");
  Mistakes mistakes;
  MillReading reading;
  TableReader reader(*file.find("mill"), table, mistakes);
  reader.read(reading.mill);
  try {
    mistakes.throw_if_any();
  } catch (const input::InputError& error) {
    reading.mistakes = error.what();
  }
  return reading;
}

TEST(BoundKey, HasTheInitialiserOfItsMemberAsDefault) {
  const Table table = mill_table();
  const auto fallback = [&](const char* name) {
    return vocabulary_key(table, name).fallback;
  };

  EXPECT_EQ(fallback("wheel"), "\"slow\"");
  EXPECT_EQ(fallback("share"), "1e-8");
  EXPECT_EQ(fallback("depth"), "\"0.25 length\"");
  EXPECT_EQ(fallback("mass"), ""); // it is needed
  EXPECT_EQ(fallback("blades"), "");
  EXPECT_EQ(fallback("open"), "true");
  EXPECT_EQ(vocabulary_key(table, "mass").example, "\"3 kg\"");
  EXPECT_EQ(vocabulary_key(table, "blades").example, "4");
  EXPECT_EQ(vocabulary_key(table, "share").example, "1e-8");
}

TEST(BoundKey, IsReadIntoItsMember) {
  const MillReading reading =
      read_mill("wheel = \"fast\"\nshare = 0.5\ndepth = \"3 h\"\nmass = 2\n"
                "blades = 3\nopen = false\nturns = 5\n");

  EXPECT_EQ(reading.mistakes, "");
  EXPECT_EQ(reading.mill.wheel, Wheel::fast);
  EXPECT_EQ(reading.mill.share, 0.5);
  EXPECT_EQ(reading.mill.depth.value, 3.0);
  EXPECT_EQ(reading.mill.depth.reference, mechanics::ReferenceUnit::spacing);
  EXPECT_EQ(reading.mill.mass, 2.0);
  EXPECT_EQ(reading.mill.blades, 3);
  EXPECT_FALSE(reading.mill.is_open);
  EXPECT_EQ(reading.mill.turns, 5);
}

TEST(BoundKey, LeavesTheMemberAsItIsWithoutAValue) {
  const MillReading reading = read_mill("mass = 2\n");

  EXPECT_EQ(reading.mistakes, "");
  EXPECT_EQ(reading.mill.depth.value, 0.25);
  EXPECT_EQ(reading.mill.blades, std::nullopt);
  EXPECT_TRUE(reading.mill.is_open);
}

TEST(BoundKey, IsMissedWhereItIsNeeded) {
  const std::string turns = "mill.turns is missing: a whole number\n";

  EXPECT_NE(read_mill("").mistakes.find("mill.mass is missing: a number [kg]"),
            std::string::npos);
  EXPECT_NE(read_mill("mass = 1\nwheel = \"fast\"\n").mistakes.find(turns),
            std::string::npos);
  // where() leaves a key alone, even one that is out of its range.
  EXPECT_EQ(read_mill("mass = 1\nturns = -3\n").mistakes, "");
}

// A reader that passes settings of another type than a row has would leave the
// key unread.
TEST(BoundKey, IsOfOneStruct) {
  const Table table = mill_table();
  const Node file = parse_toml("[mill]\nmass = 1\n", "mill.toml");
  Mistakes mistakes;
  TableReader reader(*file.find("mill"), table, mistakes);
  mechanics::WinklerSettings other;

  EXPECT_THROW(reader.read(other), std::logic_error);
  EXPECT_THROW(where<Mill>(is_fast, key<&mechanics::WinklerSettings::stiffness>(
                                        "stiffness", positive(), "Not its.")),
               std::logic_error);
}

// The texts of the defaults of [fem] say what FemSettings says: written out,
// they change nothing.
TEST(Vocabulary, HasDefaultsThatCanBeWrittenOut) {
  std::vector<std::string> written = {"fem={}", "expect="};
  for (const Key& one : vocabulary_table("fem").keys)
    if (!one.fallback.empty())
      written.push_back("fem." + one.name + "=" + one.fallback);
  const Case read = read_case_text(contact_case, "case.toml", written);
  const auto& fem =
      std::get<mechanics::FemSettings>(read.methods.at(2).settings);
  const mechanics::FemSettings plain;

  EXPECT_GE(written.size(), 15U);
  EXPECT_EQ(fem.contact.law, plain.contact.law);
  EXPECT_EQ(fem.contact.tolerance, plain.contact.tolerance);
  EXPECT_EQ(fem.contact.max_iterations, plain.contact.max_iterations);
  EXPECT_EQ(fem.block.element, plain.block.element);
  EXPECT_EQ(fem.block.surface_cell_depth, plain.block.surface_cell_depth);
  EXPECT_EQ(fem.block.growth, plain.block.growth);
  EXPECT_EQ(fem.block.depth.value, plain.block.depth.value);
  EXPECT_EQ(fem.block.depth.reference, plain.block.depth.reference);
  EXPECT_EQ(fem.block.far_boundary, plain.block.far_boundary);
  EXPECT_EQ(fem.solver, plain.solver);
  EXPECT_EQ(fem.full.sides, plain.full.sides);
  EXPECT_EQ(fem.full.linear_solver, plain.full.linear_solver);
  EXPECT_EQ(fem.full.bodies, plain.full.bodies);
}

TEST(Vocabulary, ReadsTheAgreedBlock) {
  EXPECT_EQ(read_case("tests/cases/agreed_block.toml").methods.size(), 3U);
}

} // namespace asperity::cases::vocabulary_test
