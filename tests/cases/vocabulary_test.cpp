// Tests of cases/reader/vocabulary.hpp: the keys of a case are known here, too.
#include "cases/reader/read_case.hpp"
#include "cases/reader/vocabulary.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace asperity::cases::vocabulary_test {

// The block of keys that was agreed on is read as it stands, and the list below
// is what the vocabulary has beyond it, so that a key cannot be added
// unnoticed. (A key counts as agreed where the block contains its word.) Later
// additions have their own tests: md_case_test.cpp, studies_test.cpp,
// block_test.cpp,
// block_mesh_test.cpp.
TEST(Vocabulary, HasTheAgreedBlockAndTheseKeysBeyondIt) {
  const Case agreed = read_case("tests/cases/agreed_block.toml");
  EXPECT_EQ(agreed.methods.size(), 3U);

  const std::set<std::string> later = {"md",
                                       "magnification",
                                       "magnification.leak",
                                       "adhesion",
                                       "mesh",
                                       "mesh.counter",
                                       "material.layer",
                                       "material.inclusion",
                                       "material.variation"};
  std::set<std::string> beyond;
  const std::string block = agreed.text;
  for (const Table& table : vocabulary())
    for (const Key& key : table.keys)
      if (table.name != "expect" && !later.contains(table.name) &&
          key.name != "magnification" &&
          block.find(key.name) == std::string::npos)
        beyond.insert(table.name + "." + key.name);

  EXPECT_EQ(beyond, (std::set<std::string>{".base",
                                           "expect.band.above",
                                           "expect.band.below",
                                           "expect.band.if_undecided",
                                           "halfspace.boundaries",
                                           "halfspace.max_iterations",
                                           "fem.max_iterations",
                                           "fem.mesh",
                                           "fem.sides",
                                           "fem.linear_solver",
                                           "fem.contact_at",
                                           "fem.height_interpolation",
                                           "fem.bodies",
                                           "fem.stiffness",
                                           "surface.form_radius",
                                           "surface.recess",
                                           "surface.tilt",
                                           "material.layers",
                                           "report.fields",
                                           "report.stress_inside",
                                           "report.vtu",
                                           "surface.align_lines",
                                           "surface.amplitudes",
                                           "surface.channel",
                                           "surface.crop_length_x",
                                           "surface.crop_length_y",
                                           "surface.crop_x",
                                           "surface.crop_y",
                                           "surface.fill",
                                           "surface.height_unit",
                                           "surface.length_unit",
                                           "surface.length_y",
                                           "surface.max_missing",
                                           "surface.missing_value",
                                           "surface.press_windowed_map",
                                           "surface.remove_spikes",
                                           "surface.rescale",
                                           "sweep.combine",
                                           "winkler.stiffness"}));
}

} // namespace asperity::cases::vocabulary_test
