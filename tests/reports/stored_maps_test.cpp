// Claim: the figures of a result whose large maps stay in the file are those of
// the same result in memory, byte for byte.
#include "reports/analysis/summary.hpp"
#include "reports/analysis/warnings.hpp"
#include "reports/figures/gnuplot_script.hpp"
#include "tests/reports/drawn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "synthetic.hpp"

namespace asperity::reports::stored_maps_test {

/// Single precision, as fields have in a file.
void round_to_single(std::vector<double>& values) {
  for (double& value : values)
    value = static_cast<float>(value);
}

/// The map in pieces of 8 rows, as if it were in a file.
results::StoredMap stored(std::vector<double>& values, const Grid& grid) {
  const auto width = static_cast<std::size_t>(grid.points_x);
  return {static_cast<std::size_t>(grid.points_y), width,
          [all = std::exchange(values, {}), width](std::size_t first,
                                                   std::size_t count) {
            const auto begin =
                all.begin() + static_cast<std::ptrdiff_t>(first * width);
            return std::vector<double>(
                begin, begin + static_cast<std::ptrdiff_t>(count * width));
          },
          8 * width};
}

/// A result whose maps are in memory, and one whose maps have many pieces.
class StoredMaps : public ::testing::Test {
protected:
  StoredMaps() {
    case_.surface.points = 64;
    in_memory_ = synthetic::rough_result(case_, 1);
    results::SurfaceRecord& surface = in_memory_.surfaces.at(0);
    surface.rms_curvature = surface.skewness = surface.kurtosis =
        results::not_given; // not stated: a synthetic result has those of a
                            // Gaussian
    for (results::Fields& fields : fields_of(in_memory_)) {
      round_to_single(fields.pressure);
      round_to_single(fields.gap);
    }
    in_file_ = in_memory_;
    results::SurfaceRecord& left = in_file_.surfaces.at(0);
    left.stored_heights = stored(left.heights, left.grid);
    for (results::Fields& fields : fields_of(in_file_)) {
      fields.stored_pressure = stored(fields.pressure, fields.grid);
      fields.stored_gap = stored(fields.gap, fields.grid);
    }
  }

  static std::vector<results::Fields>& fields_of(results::Result& result) {
    return result.methods.at(1).realizations.at(0).fields;
  }

  ReportEntry entry_of(const results::Result& result) const {
    return {&result, &case_, summarize(result, case_)};
  }

  cases::Case case_ = synthetic::contact_case();
  results::Result in_memory_, in_file_;
};

void expect_same(const Figure& left, const Figure& held) {
  EXPECT_EQ(left.name, held.name);
  EXPECT_EQ(left.caption, held.caption) << held.name;
  EXPECT_TRUE(gnuplot_script(left) == gnuplot_script(held)) << held.name;
  EXPECT_TRUE(left.data == held.data) << held.name;
  EXPECT_TRUE(left.maps == held.maps) << held.name;
  ASSERT_EQ(left.stack.has_value(), held.stack.has_value());
  for (std::size_t i = 0; held.stack && i < held.stack->frames.size(); ++i)
    for (std::size_t k = 0; k < held.stack->frames[i].maps.size(); ++k)
      EXPECT_TRUE(left.stack->frames.at(i).maps.at(k).data ==
                  held.stack->frames[i].maps[k].data)
          << held.name;
}

TEST_F(StoredMaps, GiveTheFiguresOfMapsInMemory) {
  const results::Fields& left = fields_of(in_file_).at(0);
  ASSERT_TRUE(left.pressure_map().is_stored());
  ASSERT_GT(left.pressure_map().size(), left.pressure_map().piece());
  const ReportEntry held = entry_of(in_memory_);
  const ReportEntry stored = entry_of(in_file_);
  const auto all = [](const ReportEntry& entry) {
    std::vector<Figure> all_drawn;
    for (const ReportFigure* const figure :
         {&figures::maps, &figures::pressure_distribution,
          &figures::gap_distribution, &figures::surface,
          &figures::height_distribution})
      std::ranges::move(drawn(*figure, entry), std::back_inserter(all_drawn));
    return all_drawn;
  };
  const std::vector<Figure> expected = all(held);
  const std::vector<Figure> found = all(stored);
  ASSERT_EQ(expected.size(), 5U);
  ASSERT_EQ(found.size(), 5U);
  for (std::size_t i = 0; i < expected.size(); ++i)
    expect_same(found[i], expected[i]);
}

// An open node of an adhesive contact has the rounding error of a pressure: the
// map of the page and the distribution of the gap are by the gap.
TEST_F(StoredMaps, OfAnAdhesiveContactAreThoseOfItsGap) {
  const auto shown = [&] {
    const ReportEntry entry = entry_of(in_memory_);
    const std::vector<Figure> maps = drawn(figures::maps, entry);
    std::vector<std::string> data{
        drawn(figures::gap_distribution, entry).at(0).data};
    for (const MapFrame& frame : maps.at(0).stack->frames)
      data.push_back(frame.maps.at(1).data);
    return data;
  };
  const std::vector<std::string> expected = shown();
  ASSERT_EQ(expected.size(), 4U);
  std::get<mechanics::FemSettings>(case_.methods.at(1).settings).contact.law =
      mechanics::ContactLaw::dugdale;
  for (results::Fields& fields : fields_of(in_memory_))
    for (std::size_t i = 0; i < fields.gap.size(); ++i)
      if (fields.gap[i] > 0.0)
        fields.pressure[i] = 1e-9;

  EXPECT_TRUE(shown() == expected);
}

// The shells of a map in a file come from transforms of rows and columns, those
// of a map in memory from one of FFTW: roundoff, some 1e-13 of the moments.
TEST_F(StoredMaps, GiveTheQuantitiesOfMapsInMemory) {
  const Summary held = summarize(in_memory_, case_);
  const Summary stored = summarize(in_file_, case_);
  for (std::size_t m = 0; m < held.methods.size(); ++m)
    for (const auto& [name, estimate] : held.methods[m].quantities)
      if (estimate.has_value()) {
        EXPECT_NEAR(stored.methods.at(m).quantities.at(name).value,
                    estimate.value, 1e-10 * std::abs(estimate.value))
            << held.methods[m].name << " " << name;
      }
  EXPECT_TRUE(held.methods.at(1).quantities.at("gamma_slope").has_value());
  EXPECT_EQ(warning_lines(in_file_, case_), warning_lines(in_memory_, case_));
}

} // namespace asperity::reports::stored_maps_test
