// A figure of one file: the report draws it in its part of the page, where it
// applies, and its name is known.
#include "reports/figures/figures.hpp"
#include "tests/reports/drawn.hpp"
#include "tests/reports/report_folder.hpp"

#include <gtest/gtest.h>

#include "synthetic.hpp"

namespace asperity::reports::toy_figure_test {

std::optional<Figure> energy_figure(std::span<const Series> series) {
  Figure figure;
  figure.name = "energy";
  figure.title = "Curves that are drawn";
  figure.caption = "Every curve has its number.";
  figure.data = "curve,number\n";
  for (const Series& one : series)
    figure.data += "\"" + one.label + "\",1\n";
  if (series.empty())
    return std::nullopt;
  return figure;
}

Figure failing_figure(std::span<const Series> /*series*/) {
  throw std::runtime_error("no number is left");
}

const ReportFigure energy{.names = {"energy", "energy-"},
                          .section = FigureSection::curves,
                          .draw = drawn_by<energy_figure>,
                          .applies = has_rough_contact};
const ReportFigure failing{.names = {"failing-"},
                           .section = FigureSection::cost,
                           .draw = drawn_by<failing_figure>};

TEST(ToyFigure, IsTheLastOfItsPartOfThePage) {
  const RegisteredFigure first(energy);
  const RegisteredFigure second(failing);
  const cases::Case rough = synthetic::contact_case();
  const results::Result result = synthetic::rough_result(rough, 1);
  const ReportEntry entry = entry_of(result, rough);

  const std::vector<FigureGroup> groups = figures_of({&entry, 1});

  ASSERT_EQ(groups.front().heading, "The curves");
  EXPECT_EQ(groups.front().figures.front().name, "pressure-gap");
  EXPECT_EQ(groups.front().figures.back().name, "energy");
  EXPECT_TRUE(is_figure_name("energy"));
  EXPECT_TRUE(is_figure_name("energy-fem"));
  const Figure& last = groups.back().figures.back();
  EXPECT_EQ(last.name, "failing"); // "cost" stands before it
  EXPECT_EQ(last.problem, "no number is left");
}

TEST(ToyFigure, IsLeftOutWhereItDoesNotApply) {
  const cases::Case rough = synthetic::contact_case();
  cases::Case smooth = rough;
  smooth.surface.kind = mechanics::SurfaceKind::sphere;
  const results::Result result = synthetic::rough_result(rough, 1);

  EXPECT_EQ(drawn(energy, entry_of(result, rough)).size(), 1U);
  EXPECT_TRUE(drawn(energy, entry_of(result, smooth)).empty());
}

} // namespace asperity::reports::toy_figure_test
