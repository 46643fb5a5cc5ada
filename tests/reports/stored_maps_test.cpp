// Claim: the figures of a result whose large maps stay in the file are those of
// the same result in memory, byte for byte.
#include "reports/analysis/summary.hpp"
#include "reports/analysis/warnings.hpp"
#include "reports/figures/gnuplot_script.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "tests/reports/drawn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

#include "synthetic.hpp"

namespace asperity::reports::stored_maps_test {

namespace fs = std::filesystem;

/// A result whose maps have two pieces, read in both ways.
class StoredMaps : public ::testing::Test {
protected:
  static void SetUpTestSuite() {
    case_.surface.points = 2080;
    const results::Result made = synthetic::rough_result(case_, 1);
    results::ResultWriter writer(folder_, {made.case_name,
                                           made.case_title,
                                           made.case_text,
                                           made.case_hash,
                                           made.contact_modulus,
                                           "",
                                           {}});
    results::SurfaceRecord surface = made.surfaces.at(0);
    surface.rms_curvature = surface.skewness = surface.kurtosis =
        results::not_given; // not stated: a synthetic result has those of a
                            // Gaussian
    writer.record_surface(0, surface);
    for (const results::MethodRecord& method : made.methods) {
      writer.begin_method(method.name, method.kind, method.description);
      const results::Curve& curve = method.realizations.at(0);
      for (const results::CurvePoint& point : curve.points) {
        const auto maps =
            std::ranges::find(curve.fields, point.step, &results::Fields::step);
        if (maps == curve.fields.end())
          writer.append_step(method.name, 0, point);
        else
          writer.append_step_with_fields(method.name, 0, point, maps->grid,
                                         *maps);
      }
    }
    writer.finish("complete");
    in_memory_ = results::read_result(folder_);
    in_file_ = results::read_result(folder_, results::MapsInFile::large);
  }

  static void TearDownTestSuite() {
    fs::remove_all(folder_);
    in_memory_ = in_file_ = {};
  }

  static ReportEntry entry_of(const results::Result& result) {
    return {&result, &case_, summarize(result, case_)};
  }

  inline static const fs::path folder_ =
      fs::path(::testing::TempDir()) /
      ("asperity_stored_maps_" + std::to_string(::getpid()));
  inline static cases::Case case_ = synthetic::contact_case();
  inline static results::Result in_memory_, in_file_;
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
  const results::Fields& left =
      in_file_.methods.at(1).realizations.at(0).fields.at(0);
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
