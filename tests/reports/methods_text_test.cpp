// Tests of reports/pages/methods_text.hpp: the text for a publication says what
// was computed, so that no key that changes the problem changes nothing in it.
#include "input/reader/vocabulary.hpp"
#include "reports/pages/methods_text.hpp"
#include "studies/magnification/magnification.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "report_folder.hpp"
#include "synthetic.hpp"

namespace asperity::reports::methods_text_test {

class MethodsTextOf : public ReportFolder {
protected:
  std::string text() const {
    const ReportEntry entry = entry_of(result, rough);
    return methods_text(std::span(&entry, 1)).paragraphs.front();
  }

  void expect_said(const std::string& part) const {
    EXPECT_NE(text().find(part), std::string::npos) << text();
  }

  results::Result result = synthetic::rough_result(rough, 1);
};

// Tables that say what is shown or tested, not what is computed.
const std::set<std::string> other_tables{"", "report", "expect", "sweep"};

TEST_F(MethodsTextOf, ShowsEachKeyThatChangesTheProblem) {
  const std::string base = "[surface]\nkind = \"measured\"\n";
  set_text(rough, base);
  const ReportEntry entry = entry_of(result, rough); // refers to the case
  const auto text_now = [&] {
    return methods_text(std::span(&entry, 1)).paragraphs.front();
  };
  const std::string without = text_now();
  int n_keys = 0;
  for (const cases::Table& table : cases::vocabulary())
    for (const cases::Key& key : table.keys) {
      if (table.is_part || other_tables.contains(table.name) ||
          (table.name == "surface" && key.name == "kind"))
        continue;
      const std::string path = table.name + "." + key.name;
      const std::string value = key.example.empty() ? "1" : key.example;
      set_text(rough, base + "#--set " + path + "=" + value + "\n");
      EXPECT_NE(text_now(), without) << path;
      EXPECT_NE(text_now().find(path + " = "), std::string::npos) << path;
      ++n_keys;
    }
  EXPECT_GT(n_keys, 100);
}

TEST_F(MethodsTextOf, LeavesOutFoldersOfFiles) {
  set_text(rough, "[surface]\nfile = \"/home/somebody/maps/a.x3p\"\n");
  expect_said("surface.file = \"a.x3p\"");
}

TEST_F(MethodsTextOf, NamesWhatIsNotAUniformHalfSpaceUnderARigidSurface) {
  EXPECT_EQ(text().find("layer"), std::string::npos);
  rough.material.layers = {{{1e-7, {}}, {2e10, 0.3}}};
  expect_said("under 1 bonded layer was pressed against a rigid ");
  rough.material.counter = mechanics::BodyModuli{2e11, 0.3};
  expect_said("against an elastic body, which E* includes, with a ");

  mechanics::HalfspaceSettings slab;
  slab.thickness = mechanics::Quantity{1e-6, {}};
  rough.methods = {{"fem", slab}};
  result.methods[1].kind = "halfspace";
  expect_said("The continuum slab of finite thickness was treated");
  result.methods[1].description = "with free boundaries";
  expect_said("fem: with free boundaries");
}

TEST_F(MethodsTextOf, SaysHowAMapWasRead) {
  rough.surface.kind = mechanics::SurfaceKind::measured;
  rough.surface.level = mechanics::Levelling::bow;
  result.provenance.emplace_back("map", "X3P; 3 missing point(s) filled");
  expect_said("read by: X3P; 3 missing point(s) filled; levelled by a "
              "second-order form");
}

TEST_F(MethodsTextOf, NamesTheLeakage) {
  studies::MagnificationStudy study;
  study.leak.emplace().viscosity = 1e-3;
  rough.studies.ask(study);
  expect_said("with the viscosity 0.001 Pa s");
}

// Every entry of the literature has an identifier.
TEST_F(MethodsTextOf, CitesWithIdentifiers) {
  const ReportEntry entry = entry_of(result, rough);
  const std::string all = methods_text(std::span(&entry, 1)).literature;
  std::size_t entries = 0;
  std::size_t identifiers = 0;
  for (std::size_t at = 0; (at = all.find('@', at)) != all.npos; ++at)
    ++entries;
  for (std::size_t at = 0; (at = all.find("doi = ", at)) != all.npos; ++at)
    ++identifiers;
  EXPECT_GT(entries, 3U);
  EXPECT_EQ(identifiers, entries);
}

} // namespace asperity::reports::methods_text_test
