// Tests of run/provenance_of_run.hpp: the description of a map in a result.
#include "run/provenance_of_run.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

namespace asperity::run::provenance_test {

class ProvenanceOfAMap : public tests::FolderTest {
protected:
  ProvenanceOfAMap() {
    std::ofstream file(folder / "map.txt");
    for (int iy = 0; iy < 16; ++iy) {
      for (int ix = 0; ix < 16; ++ix)
        file << (7 * ix * ix + 5 * iy * iy + 3 * ix * iy) % 17 << ' ';
      file << '\n';
    }
    measured.surface.kind = mechanics::SurfaceKind::measured;
    measured.surface.file = (folder / "map.txt").string();
    measured.surface.format = "plain";
    measured.surface.length = 1e-6;
    measured.surface.height_unit = 1e-9;
  }

  std::map<std::string, std::string> facts() const {
    const results::Provenance list = provenance_at_start(measured, 3);
    return {list.begin(), list.end()};
  }

  cases::Case measured;
};

// Every map is described, and the effect of the window function is
// stated where it is applied and nowhere else.
TEST_F(ProvenanceOfAMap, SaysWhatTheWindowDoes) {
  using mechanics::Edges;
  for (const Edges edges : {Edges::periodic, Edges::mirror, Edges::free}) {
    measured.surface.edges = edges;
    EXPECT_FALSE(facts().contains("window"));
    EXPECT_NE(facts()["map"].find("reader"), std::string::npos);
  }

  measured.surface.edges = Edges::window;
  EXPECT_NE(facts()["window"].find("changes the rms height"),
            std::string::npos);
  EXPECT_EQ(facts()["threads"], "3");
}

} // namespace asperity::run::provenance_test
