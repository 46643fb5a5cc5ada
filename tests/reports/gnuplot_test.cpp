// Claims about reports/figures/gnuplot.hpp: words stay words, and what goes
// wrong is said.
#include "reports/figures/gnuplot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace asperity::reports {
namespace {

namespace fs = std::filesystem;

class Drawing : public ::testing::Test {
protected:
  Drawing() { fs::remove_all(folder); }

  ~Drawing() override { fs::remove_all(folder); }

  DrawnFigure drawn(const std::string& script) const {
    Figure figure;
    figure.name = "trial";
    figure.data = "x,y\n1,2\n2,3\n";
    figure.script = script;
    return draw(figure, folder);
  }

  fs::path folder = fs::temp_directory_path() / "asperity-gnuplot-test";
};

// Claim: a title that would run a command, by quote, by backquote or by
// markup, runs none and is shown letter by letter, but for the quote's shape.
TEST_F(Drawing, ShowsHostileTitlesAsTheyAre) {
  for (const std::string title :
       {"'; system('touch owned'); '", "`touch owned`", "a_b^c{d}@e~f"}) {
    const DrawnFigure figure =
        drawn("plot 'trial.csv' using 1:2 with lines title " +
              gnuplot_text(title) + "\n");

    EXPECT_EQ(figure.problem, "") << title;
    EXPECT_FALSE(fs::exists(folder / "owned")) << title;
    std::string shown = title;
    for (std::size_t at = shown.find('\''); at != std::string::npos;
         at = shown.find('\''))
      shown.replace(at, 1, "’");
    EXPECT_NE(figure.svg.find(shown), std::string::npos) << title;
  }
}

// Claim: a name that could end the quotes it stands in is an error, whoever
// made it.
TEST_F(Drawing, RefusesNamesThatAreNoFileWords) {
  for (const std::string name :
       {"", "a.b", "a'; system('touch owned'); '", "a/../b", "A", "a b"}) {
    Figure figure;
    figure.name = name;
    EXPECT_THROW(draw(figure, folder), std::domain_error) << name;
    figure.name = "good";
    figure.maps = {{name, ""}};
    EXPECT_THROW(draw(figure, folder), std::domain_error) << name;
  }
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(Drawing, SaysWhatGnuplotRefused) {
  const DrawnFigure figure = drawn("plot no_such_function(x)\n");

  EXPECT_TRUE(figure.svg.empty());
  EXPECT_NE(figure.problem.find("no_such_function"), std::string::npos);
}

// Claim: gnuplot leaves neither its messages nor a temporary in the folder.
TEST_F(Drawing, LeavesThreeFilesAndNothingElse) {
  drawn("plot 'trial.csv' using 1:2 with lines notitle\n");

  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    ++files;
    EXPECT_EQ(entry.path().stem(), "trial") << entry.path();
  }
  EXPECT_EQ(files, 3U);
}

TEST(CsvTable, QuotesLabelsAndWritesNanForWhatIsNotThere) {
  CsvTable table({"curve", "gap [m]"});

  table.add("a \"b\",c", {0.25});
  table.add("d", {NAN});

  EXPECT_EQ(table.text(), "curve,gap [m]\n\"a \"\"b\"\",c\",0.25\n\"d\",nan\n");
}

} // namespace
} // namespace asperity::reports
