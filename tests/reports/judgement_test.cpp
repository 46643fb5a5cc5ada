// Tests of reports/analysis/judgement.hpp: each verdict and its limits.
#include "reports/analysis/judgement.hpp"

#include <gtest/gtest.h>

namespace asperity::reports::judgement_test {

Estimate ours(double value, double half_width = not_a_number) {
  Estimate estimate;
  estimate.value = value;
  estimate.half_width = half_width;
  return estimate;
}

std::string words(const cases::ReferenceValue& reference,
                  const Estimate& estimate) {
  return compare_with_published(reference, estimate).words;
}

const cases::ReferenceValue printed{"gamma", 0.4, "1", 0.05, "paper", ""};
const cases::ReferenceValue excused{"gamma", 0.4, "1", 0.05, "paper", "secret"};
const cases::ReferenceValue exact{"pi", 4.0, "1", 0.0, "formula", ""};
const cases::ReferenceValue nothing{"u", 0.0, "1", 0.01, "paper", ""};

// The printed digit and our interval are added, no less and no more.
TEST(Judgement, AddsTheTwoUncertainties) {
  EXPECT_EQ(words(printed, ours(0.4499)), "reproduced");
  EXPECT_EQ(words(printed, ours(0.4501)), "differs by 13 %");
  EXPECT_EQ(words(printed, ours(0.4501, 0.01)), "reproduced");
  EXPECT_EQ(words(printed, ours(0.3399, 0.01)), "differs by 16 %");
}

// The stated difference is never less than the actual one: 0.0501/4 is 1.2525
// %.
TEST(Judgement, RoundsTheDistanceUp) {
  EXPECT_EQ(words(exact, ours(4.0)), "reproduced");
  EXPECT_EQ(words(exact, ours(4.0501)), "differs by 1.3 %");
  EXPECT_EQ(words(exact, ours(17.2)), "differs by 330 %");
  EXPECT_EQ(words(exact, ours(-4.0)), "differs by 200 %");
  EXPECT_EQ(words(nothing, ours(0.0234)), "differs by 0.024");
}

// A wide interval agrees with anything, so that agreement means nothing; a wide
// one that does not agree shows that the numbers differ.
TEST(Judgement, IsInconclusiveWithinAWideInterval) {
  EXPECT_EQ(words(printed, ours(0.5, 0.079)), "reproduced");
  EXPECT_EQ(words(printed, ours(0.5, 0.081)),
            "inconclusive: our interval, ± 0.081, is so wide that many other "
            "values would agree");
  EXPECT_EQ(compare_with_published(printed, ours(0.4, 0.3)).reproduction,
            Reproduction::inconclusive);
  EXPECT_EQ(compare_with_published(printed, ours(0.9, 0.3)).reproduction,
            Reproduction::differs);
  EXPECT_EQ(words(nothing, ours(0.015, 0.009)), "reproduced");
  EXPECT_EQ(compare_with_published(nothing, ours(0.015, 0.011)).reproduction,
            Reproduction::inconclusive);
}

TEST(Judgement, StatesTheReasonOnlyIfNotMet) {
  EXPECT_EQ(words(excused, ours(0.42)), "reproduced");
  EXPECT_EQ(words(excused, ours(0.5)), "not reproducible: secret");
  EXPECT_EQ(words(excused, ours(not_a_number)), "not reproducible: secret");
  EXPECT_EQ(compare_with_published(excused, ours(0.5)).reproduction,
            Reproduction::not_reproducible);
}

// An input of the case is not counted as reproduced, however near it is.
TEST(Judgement, TakesNoCreditForAnInput) {
  Estimate set = ours(0.4);
  set.is_input = true;

  EXPECT_EQ(compare_with_published(printed, set).reproduction,
            Reproduction::input);
}

// Neither is a number to which the case was fitted; if it is missed, it is
// counted as missed.
TEST(Judgement, TakesNoCreditForWhatTheCaseWasFittedTo) {
  cases::ReferenceValue fitted = printed;
  fitted.input = "q_0 of [surface]";

  EXPECT_EQ(compare_with_published(fitted, ours(0.41)).reproduction,
            Reproduction::input);
  EXPECT_EQ(words(fitted, ours(0.41)), "set in the case: q_0 of [surface]");
  EXPECT_EQ(compare_with_published(fitted, ours(0.5)).reproduction,
            Reproduction::differs);
}

TEST(Judgement, HasNoneWithoutANumber) {
  Estimate none;
  none.remark = "too few rows";

  const Judgement judgement = compare_with_published(printed, none);

  EXPECT_EQ(judgement.reproduction, Reproduction::missing);
  EXPECT_EQ(judgement.words, "not determined: too few rows");
}

} // namespace asperity::reports::judgement_test
