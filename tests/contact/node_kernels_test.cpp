// Tests of contact/solvers/node_kernels.hpp: each loop against the formula of
// its declaration, one node after another.
#include "contact/solvers/node_kernels.hpp"
#include "tests/narrower_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace asperity::contact::node_kernels_test {

constexpr float mean = 0.1F;
constexpr float beta = 0.7F;
constexpr double compliance = 0.3;
constexpr double rigid = -0.2;
constexpr double hardness = 0.6;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Fields with all kinds of nodes: two blocks and a part of a third.
struct Fields {
  explicit Fields(bool is_weighted) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    for (std::size_t i = 0; i < nodes; ++i) {
      pressure[i] = std::max(0.0, value(random));
      raw_gap[i] = value(random);
      freedom[i] = static_cast<std::uint8_t>(i % 4);
      weight[i] = 1.0 + 0.3 * value(random);
      for (std::vector<float>* field :
           {&residual, &previous, &preconditioned, &direction, &displaced})
        (*field)[i] = static_cast<float>(value(random));
    }
    if (!is_weighted)
      weight.clear();
  }

  NodeFields view() {
    return {weight.empty() ? nullptr : weight.data(),
            pressure.data(),
            raw_gap.data(),
            residual.data(),
            previous.data(),
            freedom.data(),
            preconditioned.data(),
            direction.data(),
            displaced.data(),
            change.data(),
            nullptr,
            active.data(),
            lowest.data(),
            compliance};
  }

  double weight_at(std::size_t i) const {
    return weight.empty() ? 1.0 : weight[i];
  }

  float restricted(std::size_t i) const {
    return allowed(preconditioned[i] - mean, freedom[i]);
  }

  static constexpr std::size_t nodes = 2 * block_nodes + 37;
  std::vector<double> weight = std::vector<double>(nodes);
  std::vector<double> pressure = weight, raw_gap = weight;
  std::vector<std::uint8_t> freedom = std::vector<std::uint8_t>(nodes);
  std::vector<float> residual = std::vector<float>(nodes);
  std::vector<float> previous = residual, preconditioned = residual,
                     direction = residual, displaced = residual,
                     change = residual;
  std::vector<std::uint8_t> active{1, 1, 1}; ///< of the blocks
  std::vector<double> lowest = std::vector<double>(3, infinity);
};

constexpr NodeRange all{0, Fields::nodes};

/// A sum of up to 165 terms of order 1 in any order: 165 eps 165, rounded up.
constexpr double roundoff = 1e-11;

/// Sums of products of single-precision fields: terms below 3, each of which is
/// rounded by eps / 2 up to four times, and three times in a sum of four.
constexpr double single_roundoff =
    3.0 * (4.0 + 3.0) * 165.0 * 0.5 * std::numeric_limits<float>::epsilon();

class NodeKernels : public testing::TestWithParam<bool> {};

TEST_P(NodeKernels, MeasuresResidualAndFreedomOfActiveBlocks) {
  Fields fields(GetParam());
  const Fields before = fields;
  fields.active[1] = 0;

  const MeasuredNodes found = measure_nodes(fields.view(), all, rigid);

  MeasuredNodes expected;
  for (std::size_t i = 0; i < Fields::nodes; ++i) {
    if (i / block_nodes == 1) {
      EXPECT_EQ(fields.residual[i], before.residual[i]);
      EXPECT_EQ(fields.freedom[i], before.freedom[i]);
      continue;
    }
    const double value =
        before.raw_gap[i] + compliance * before.pressure[i] + rigid;
    const bool has_pressure = before.pressure[i] > 0.0;
    const bool is_free = has_pressure || value < 0.0;
    EXPECT_EQ(fields.freedom[i], has_pressure ? may_shift
                                 : is_free    ? gains
                                              : fixed);
    EXPECT_EQ(fields.residual[i], is_free ? static_cast<float>(value) : 0.0F);
    if (is_free) {
      expected.error = std::max(expected.error, std::abs(value));
      expected.weight += fields.weight_at(i);
    }
    expected.changed += is_free != (before.freedom[i] > 0) ? 1.0 : 0.0;
  }
  EXPECT_EQ(found.error, expected.error);
  EXPECT_EQ(found.changed, expected.changed);
  EXPECT_NEAR(found.weight, expected.weight, roundoff);
  EXPECT_EQ(fields.active, (std::vector<std::uint8_t>{1, 0, 1}));
}

TEST_P(NodeKernels, FindsBlocksWithoutActiveNodes) {
  Fields fields(GetParam());
  std::fill_n(fields.pressure.begin(), block_nodes, 0.0);
  std::fill_n(fields.raw_gap.begin(), block_nodes, 1.0);

  measure_nodes(fields.view(), all, rigid);

  EXPECT_EQ(fields.active, (std::vector<std::uint8_t>{0, 1, 1}));
}

// More blocks than the bytes count that hold the numbers of a few of them.
TEST(NodeCounts, OfManyBlocksAreExact) {
  constexpr std::size_t n = 400 * block_nodes;
  std::vector<double> pressure(n, 1.0), raw_gap(n, 0.0);
  std::vector<float> residual(n);
  const auto check = [&] {
    std::vector<std::uint8_t> freedom(n, fixed), active(400, 1);
    NodeFields many{};
    many.pressure = pressure.data();
    many.raw_gap = raw_gap.data();
    many.residual = residual.data();
    many.freedom = freedom.data();
    many.active = active.data();
    const MeasuredNodes found = measure_nodes(many, {0, n}, rigid);
    EXPECT_EQ(found.weight, static_cast<double>(n));
    EXPECT_EQ(found.changed, static_cast<double>(n));
  };

  check();
  tests::on_narrower_vectors(check);
}

TEST_P(NodeKernels, ReportsValuesThatAreNotFinite) {
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity})
    for (const std::size_t node : {std::size_t{5}, Fields::nodes - 1}) {
      Fields fields(GetParam());
      fields.raw_gap[node] = wrong;

      const MeasuredNodes found = measure_nodes(fields.view(), all, rigid);
      std::ranges::fill(fields.active, std::uint8_t{0});
      change_gap(fields.view(), all, 1.0);

      EXPECT_TRUE(std::isnan(found.error)) << wrong << " at " << node;
      EXPECT_EQ(fields.lowest[node / block_nodes], -infinity);
      EXPECT_TRUE(std::isfinite(fields.lowest[1]));
    }
}

TEST_P(NodeKernels, ChangesTheGapAndSumsItUnderPressure) {
  Fields fields(GetParam());
  const Fields before = fields;
  fields.active[1] = 0;

  const auto found = change_gap(fields.view(), all, 0.6).values;

  std::array<double, 2> expected{};
  std::vector<double> least(3, infinity);
  for (std::size_t i = 0; i < Fields::nodes; ++i) {
    const std::size_t block = i / block_nodes;
    const double gap =
        before.raw_gap[i] + 0.6 * static_cast<double>(before.displaced[i]);
    EXPECT_EQ(fields.raw_gap[i], gap);
    if (fields.active[block] == 0)
      least[block] = std::min(least[block], gap);
    if (fields.active[block] == 0 || before.pressure[i] <= 0.0)
      continue;
    expected[0] +=
        fields.weight_at(i) * (gap + compliance * before.pressure[i]);
    expected[1] += fields.weight_at(i);
  }
  EXPECT_EQ(fields.lowest, least);
  EXPECT_NEAR(found[0], expected[0], roundoff);
  EXPECT_NEAR(found[1], expected[1], roundoff);
}

TEST_P(NodeKernels, SumsTheDirection) {
  Fields fields(GetParam());
  double free = 0.0, energy = 0.0;
  std::array<double, 2> slopes{};
  for (std::size_t i = 0; i < Fields::nodes; ++i) {
    const double weight = fields.weight_at(i);
    if (fields.freedom[i] > fixed)
      free += weight * static_cast<double>(fields.preconditioned[i]);
    const double slope = weight * static_cast<double>(fields.restricted(i));
    slopes[0] += slope * static_cast<double>(fields.residual[i]);
    slopes[1] +=
        slope * static_cast<double>(fields.residual[i] - fields.previous[i]);
    const double d = static_cast<double>(fields.direction[i]);
    energy += weight * d *
              (static_cast<double>(fields.displaced[i]) + compliance * d);
  }

  const auto found = sum_slopes(fields.view(), all, mean).values;

  EXPECT_NEAR(sum_free(fields.view(), all).value, free, single_roundoff);
  EXPECT_NEAR(found[0], slopes[0], single_roundoff);
  EXPECT_NEAR(found[1], slopes[1], single_roundoff);
  EXPECT_NEAR(sum_energy(fields.view(), all).value, energy, single_roundoff);
}

TEST_P(NodeKernels, ConjugatesWithinTheChangesAllowed) {
  Fields fields(GetParam());
  const std::vector<float> before = fields.direction;

  const double found = conjugate_nodes(fields.view(), all, mean, beta).value;

  double expected = 0.0;
  for (std::size_t i = 0; i < Fields::nodes; ++i) {
    const float wish = fields.restricted(i) + beta * before[i];
    EXPECT_EQ(fields.direction[i], allowed(wish, fields.freedom[i]));
    expected += fields.weight_at(i) * static_cast<double>(fields.direction[i]) *
                static_cast<double>(fields.residual[i]);
  }
  EXPECT_NEAR(found, expected, single_roundoff);
}

/// Pressures of 0, below the hardness and of the hardness; steps of 0 too.
Fields bounded_fields(bool is_weighted) {
  Fields fields(is_weighted);
  for (std::size_t i = 0; i < Fields::nodes; ++i) {
    fields.pressure[i] = std::min(fields.pressure[i], hardness);
    if (i % 5 == 0)
      fields.direction[i] = 0.0F;
  }
  return fields;
}

TEST_P(NodeKernels, AdvanceCutsPressuresOffAtZeroAndAtTheHardness) {
  for (const auto& [bound, way] : {std::pair(infinity, Advance{0.4}),
                                   std::pair(hardness, Advance{0.4, 1.3})}) {
    Fields fields = bounded_fields(GetParam());
    const Fields before = fields;
    NodeFields view = fields.view();
    view.hardness = bound;

    const AdvancedLoad foreseen = sum_advanced(view, all, way);
    EXPECT_EQ(fields.pressure, before.pressure);
    const auto found = advance_nodes(view, all, way).values;

    AdvancedLoad expected;
    for (std::size_t i = 0; i < Fields::nodes; ++i) {
      const double wish = before.pressure[i] -
                          way.step * static_cast<double>(before.direction[i]);
      const bool moves = before.direction[i] != 0.0F;
      const double kept =
          std::clamp(moves ? way.factor * wish : wish, 0.0, bound);
      EXPECT_EQ(fields.pressure[i], kept);
      EXPECT_EQ(fields.change[i],
                static_cast<float>(kept - before.pressure[i]));
      const double weight = fields.weight_at(i);
      expected +=
          {weight * kept, std::abs(kept - wish),
           moves && kept > 0.0 && kept < bound ? weight * wish : 0.0, kept};
    }
    EXPECT_NEAR(foreseen.load, expected.load, roundoff);
    EXPECT_NEAR(foreseen.cut, expected.cut, roundoff);
    EXPECT_NEAR(foreseen.slope, expected.slope, roundoff);
    EXPECT_EQ(foreseen.largest, expected.largest);
    EXPECT_EQ(found[0], foreseen.load);
    EXPECT_EQ(found[1], foreseen.cut);
    EXPECT_GT(found[1], 0.0);
  }
}

TEST_P(NodeKernels, NodesSinkAtTheHardness) {
  Fields fields = bounded_fields(GetParam());
  std::fill_n(fields.pressure.begin(), block_nodes, hardness);
  std::fill_n(fields.raw_gap.begin(), block_nodes, -1.0);
  const Fields before = fields;
  NodeFields view = fields.view();
  view.hardness = hardness;

  const MeasuredNodes found = measure_nodes(view, all, rigid);
  const auto sums = change_gap(view, all, 0.0).values;

  double weight = 0.0;
  std::array<double, 2> elastic{};
  for (std::size_t i = 0; i < Fields::nodes; ++i) {
    const double p = before.pressure[i];
    const double own = before.raw_gap[i] + compliance * p;
    const bool sinks = p >= hardness && own + rigid <= 0.0;
    const Freedom expected = p >= hardness       ? sinks ? fixed : loses
                             : p > 0.0           ? may_shift
                             : own + rigid < 0.0 ? gains
                                                 : fixed;
    EXPECT_EQ(fields.freedom[i], expected) << i;
    weight += expected > fixed ? fields.weight_at(i) : 0.0;
    if (p > 0.0 && p < hardness) {
      elastic[0] += fields.weight_at(i) * own;
      elastic[1] += fields.weight_at(i);
    }
  }
  EXPECT_NEAR(found.weight, weight, roundoff);
  EXPECT_NEAR(sums[0], elastic[0], roundoff);
  EXPECT_NEAR(sums[1], elastic[1], roundoff);
  EXPECT_EQ(fields.active[0], 1) << "a block that carries load is active";
}

TEST_P(NodeKernels, ScalesThePressure) {
  Fields fields(GetParam());
  const Fields before = fields;

  scale_nodes(fields.view(), all, 1.25);

  for (std::size_t i = 0; i < Fields::nodes; ++i) {
    EXPECT_EQ(fields.pressure[i], 1.25 * before.pressure[i]);
    EXPECT_EQ(fields.change[i],
              before.change[i] + static_cast<float>(0.25 * before.pressure[i]));
  }
}

// With the scale the bits of all sums are those of fields of order 1. Without
// it the products are below the smallest number in single precision.
TEST_P(NodeKernels, ScaledProductsDoNotUnderflow) {
  constexpr int of_pressure = -60, of_length = -90;
  Fields ordinary(GetParam());
  Fields small(GetParam());
  for (std::size_t i = 0; i < Fields::nodes; ++i) {
    for (std::vector<float>* field : {&small.preconditioned, &small.direction})
      (*field)[i] = std::ldexp((*field)[i], of_pressure);
    for (std::vector<float>* field :
         {&small.residual, &small.previous, &small.displaced})
      (*field)[i] = std::ldexp((*field)[i], of_length);
  }
  NodeFields scaled = small.view();
  scaled.product_scale = std::ldexp(1.0F, 120);
  const auto back = [](double sum) {
    return std::ldexp(sum, -of_pressure - of_length);
  };

  const auto expected = sum_slopes(ordinary.view(), all, mean).values;
  const auto found =
      sum_slopes(scaled, all, std::ldexp(mean, of_pressure)).values;
  EXPECT_EQ(back(found[0]), expected[0]);
  EXPECT_EQ(back(found[1]), expected[1]);
  EXPECT_EQ(
      back(conjugate_nodes(scaled, all, std::ldexp(mean, of_pressure), beta)
               .value),
      conjugate_nodes(ordinary.view(), all, mean, beta).value);
  scaled.compliance = std::ldexp(compliance, of_length - of_pressure);
  EXPECT_EQ(back(sum_energy(scaled, all).value),
            sum_energy(ordinary.view(), all).value);
}

/// What all loops return and leave in the fields, one after another.
std::vector<double> all_results(bool is_weighted) {
  Fields fields(is_weighted);
  std::vector<double> found;
  const auto take = [&](const TwoSums& sums) {
    found.insert(found.end(), sums.values.begin(), sums.values.end());
  };
  take(change_gap(fields.view(), all, 0.6));
  const MeasuredNodes measured = measure_nodes(fields.view(), all, rigid);
  found.insert(found.end(), {measured.error, measured.weight, measured.changed,
                             sum_free(fields.view(), all).value});
  take(sum_slopes(fields.view(), all, mean));
  found.push_back(conjugate_nodes(fields.view(), all, mean, beta).value);
  found.push_back(sum_energy(fields.view(), all).value);
  NodeFields bounded = fields.view();
  bounded.hardness = hardness;
  const AdvancedLoad next = sum_advanced(bounded, all, {0.4, 1.2});
  found.insert(found.end(), {next.load, next.cut, next.slope, next.largest});
  take(advance_nodes(fields.view(), all, {0.4}));
  take(advance_nodes(bounded, all, {0.2, 1.2}));
  take(change_gap(bounded, all, 0.1));
  found.push_back(measure_nodes(bounded, all, rigid).weight);
  scale_nodes(fields.view(), all, 1.1);
  for (const auto* field : {&fields.pressure, &fields.raw_gap})
    found.insert(found.end(), field->begin(), field->end());
  for (const auto* field :
       {&fields.residual, &fields.direction, &fields.change})
    found.insert(found.end(), field->begin(), field->end());
  found.insert(found.end(), fields.freedom.begin(), fields.freedom.end());
  return found;
}

TEST_P(NodeKernels, GiveTheSameBitsForEveryWidth) {
  const std::vector<double> widest = all_results(GetParam());

  tests::on_narrower_vectors(
      [&] { EXPECT_EQ(all_results(GetParam()), widest); });
}

INSTANTIATE_TEST_SUITE_P(EqualAndUnequalAreas, NodeKernels, testing::Bool());

} // namespace asperity::contact::node_kernels_test
