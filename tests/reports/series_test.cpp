// Tests of reports/figures/series.hpp: a variant that coincides with its method
// is drawn with it as one curve, one that differs visibly is not.
#include "reports/pages/report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "synthetic.hpp"

namespace asperity::reports::series_test {

using Change = std::function<void(results::CurvePoint&)>;

// "fem" and "fem.hard", a copy of it with one row changed.
std::vector<Series> series_with_variant(const Change& change,
                                        const std::string& name = "fem.hard") {
  const cases::Case rough = synthetic::contact_case();
  results::Result result = synthetic::rough_result(rough, 1);
  results::MethodRecord variant = result.methods.back();
  variant.name = name;
  change(variant.realizations.front().points[7]);
  result.methods.push_back(variant);
  const ReportEntry entry = entry_of(result, rough);
  std::vector<Series> series = series_of(std::span(&entry, 1));
  for (Series& one : series)
    one.method = nullptr; // it ends with the entry
  return series;
}

bool is_variant_drawn(const Change& change) {
  return series_with_variant(change)[2].is_drawn;
}

TEST(SeriesOfAVariant, IsDrawnOnlyWhereItDiffers) {
  const double rms_height = 34e-9; // of the synthetic surface

  EXPECT_FALSE(is_variant_drawn([](auto&) {}));
  EXPECT_FALSE(is_variant_drawn(
      [&](auto& row) { row.mean_gap += 0.0015 * rms_height; }));
  EXPECT_TRUE(is_variant_drawn(
      [&](auto& row) { row.mean_gap += 0.0025 * rms_height; }));
  EXPECT_FALSE(is_variant_drawn([](auto& row) { row.area_fraction *= 1.008; }));
  EXPECT_TRUE(is_variant_drawn([](auto& row) { row.area_fraction *= 1.012; }));
  EXPECT_TRUE(is_variant_drawn(
      [](auto& row) { row.area_fraction_corrected *= 0.985; }));
  EXPECT_TRUE(
      is_variant_drawn([](auto& row) { row.nominal_pressure *= 1.006; }));
  EXPECT_TRUE(is_variant_drawn([](auto& row) {
    row.status = results::StepStatus::not_converged; // its row is missing
  }));
}

// The band is Student's 95 % interval of the mean, 12.706 s/sqrt(2) for two
// realisations, and there is none for one.
TEST(SeriesOfAnEnsemble, HasTheIntervalOfTheMean) {
  const cases::Case rough = synthetic::contact_case();
  results::Result result = synthetic::rough_result(rough, 2);
  std::vector<results::Curve>& curves = result.methods.back().realizations;
  curves[0].points[5].area_fraction_corrected = 0.10;
  curves[1].points[5].area_fraction_corrected = 0.12;
  const ReportEntry two = entry_of(result, rough);
  results::Result alone = synthetic::rough_result(rough, 1);
  const ReportEntry one = entry_of(alone, rough);

  const std::vector<Series> series = series_of(std::span(&two, 1));
  const std::vector<Series> single = series_of(std::span(&one, 1));

  EXPECT_NEAR(series.back().rows[5].area_interval, 12.7062 * 0.01, 1e-5);
  EXPECT_FALSE(std::isfinite(single.back().rows[5].area_interval));
}

// At a prescribed gap one of two surfaces may not touch. Its pressure is 0, and
// the mean is half of that of the other; a step that failed has no mean.
TEST(SeriesOfAnEnsemble, IsAMeanOfAllRealisations) {
  const cases::Case rough = synthetic::contact_case();
  results::Result result = synthetic::rough_result(rough, 2);
  std::vector<results::Curve>& curves = result.methods.back().realizations;
  curves[1].points[0].nominal_pressure = 0.0;
  curves[1].points[0].area_fraction = 0.0;
  curves[1].points[4].status = results::StepStatus::not_converged;
  const ReportEntry entry = entry_of(result, rough);

  const std::vector<SeriesRow> rows =
      series_of(std::span(&entry, 1)).back().rows;

  ASSERT_EQ(rows.size(), curves[0].points.size() - 1);
  EXPECT_NEAR(rows[0].pressure / (curves[0].points[0].nominal_pressure /
                                  result.contact_modulus),
              0.5, 1e-12);
  EXPECT_NEAR(rows[4].pressure / (curves[0].points[5].nominal_pressure /
                                  result.contact_modulus),
              1.0, 1e-12);
}

// Between its loads a theory is evaluated, not interpolated: to the rounding of
// other sums. Rows that are not the theory of this surface have no such curve.
TEST(SeriesOfATheory, IsEvaluatedBetweenItsLoads) {
  const cases::Case rough = synthetic::contact_case();
  results::Result result = synthetic::rough_result(rough, 1);
  const theory::PerssonContact contact = synthetic::contact_of(rough.surface);
  const ReportEntry entry = entry_of(result, rough);

  const std::vector<Series> series = series_of(std::span(&entry, 1));

  const std::vector<SeriesRow>& fine = series.front().fine;
  ASSERT_GE(fine.size(), 96U);
  EXPECT_EQ(fine.front().pressure, series.front().rows.front().pressure);
  EXPECT_EQ(fine.back().pressure, series.front().rows.back().pressure);
  for (const SeriesRow& row : fine) {
    const double pressure = row.pressure * synthetic::contact_modulus;
    EXPECT_NEAR(row.area / contact.area_fraction(pressure), 1.0, 1e-9);
    EXPECT_NEAR(row.gap * contact.spectrum().rms_height(),
                contact.mean_gap(pressure), 1e-9 * contact.mean_gap(pressure));
  }
  for (results::CurvePoint& row : result.methods[0].realizations[0].points)
    row.area_fraction *= 0.99;
  const ReportEntry other = entry_of(result, rough);
  EXPECT_TRUE(series_of(std::span(&other, 1)).front().fine.empty());
}

TEST(SeriesOfAVariant, IsInTheLegendOfItsMethod) {
  const std::vector<Series> joined = series_with_variant([](auto&) {});

  EXPECT_EQ(joined[1].legend, "fem, fem.hard");
  EXPECT_EQ(joined[1].label, "fem");
  EXPECT_TRUE(joined[1].is_drawn);
}

// Two methods with the same numbers are both drawn; neither is a variant of the
// other.
TEST(SeriesOfAVariant, IsNotEveryMethodThatAgrees) {
  const std::vector<Series> both =
      series_with_variant([](auto&) {}, "halfspace");

  EXPECT_TRUE(both[2].is_drawn);
  EXPECT_EQ(both[1].legend, "fem");
}

} // namespace asperity::reports::series_test
