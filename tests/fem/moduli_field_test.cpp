// Tests of fem/waves/moduli_field.hpp.
#include "fem/waves/moduli_field.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <vector>

namespace asperity::fem::moduli_field_test {

constexpr double young = 2e9; // Pa
const Grid grid{8, 8, 4e-6, 4e-6};
const mechanics::Scales scales{1e9, 4e-6, 0.5e-6, 1e-8};

std::string words_of(const std::string& expression) {
  return tests::message_of<std::domain_error>(
      [&] { expression_factor(expression, 1e-6); });
}

TEST(ModuliField, PutsTheSphereBeforeLayersAndThoseBeforeTheRest) {
  mechanics::MaterialSpec material;
  material.layers = {
      {{0.25, mechanics::ReferenceUnit::length}, {5.0 * young, 0.2}}};
  material.inclusion =
      mechanics::MaterialInclusion{{0.5e-6, mechanics::ReferenceUnit::si},
                                   {0.25, mechanics::ReferenceUnit::length},
                                   {9.0 * young, 0.1}};

  const ModuliField field =
      moduli_field(material, scales, {young, 0.3}, grid, 4e-6);

  EXPECT_EQ(field.at({0.0, 0.0, 0.9e-6}), moduli({5.0 * young, 0.2}));
  EXPECT_EQ(field.at({0.0, 0.0, 1.1e-6}), moduli({young, 0.3}));
  EXPECT_EQ(field.at({2.3e-6, 2e-6, 0.7e-6}), moduli({9.0 * young, 0.1}));
  EXPECT_EQ(field.at({2.6e-6, 2e-6, 0.9e-6}), moduli({5.0 * young, 0.2}));
}

// Such a block would be uniform.
TEST(ModuliField, RefusesAnInclusionOutsideOfTheBlock) {
  mechanics::MaterialSpec material;
  material.inclusion =
      mechanics::MaterialInclusion{{1.0, mechanics::ReferenceUnit::length},
                                   {0.25, mechanics::ReferenceUnit::length},
                                   {9.0 * young, 0.1}};
  const auto message = [&](double radius, double centre) {
    material.inclusion->radius = {radius, mechanics::ReferenceUnit::si};
    material.inclusion->depth = {centre, mechanics::ReferenceUnit::si};
    return tests::message_of<std::domain_error>([&] {
      (void)moduli_field(material, scales, {young, 0.3}, grid, 4e-6);
    });
  };

  EXPECT_EQ(message(1e-6, 4.9e-6), "accepted");
  EXPECT_EQ(message(1e-6, 5.1e-6),
            "material.inclusion.depth = 5.1e-06, but must be larger than the "
            "radius, 1e-06 m, and less than 5e-06 m, where it lies below the "
            "block");
  EXPECT_NE(message(1e-6, 0.9e-6), "accepted");
}

TEST(ModuliField, LaysLayersOnEachOther) {
  ModuliField field(moduli({young, 0.3}));
  field.add_layer(1e-6, moduli({2.0 * young, 0.2}));
  field.add_layer(0.5e-6, moduli({3.0 * young, 0.1}));

  EXPECT_EQ(field.at({0.0, 0.0, 0.9e-6}), moduli({2.0 * young, 0.2}));
  EXPECT_EQ(field.at({0.0, 0.0, 1.4e-6}), moduli({3.0 * young, 0.1}));
  EXPECT_EQ(field.at({0.0, 0.0, 1.6e-6}), moduli({young, 0.3}));
}

// A factor multiplies E and leaves nu unchanged. Tolerance: roundoff.
TEST(ModuliField, MultipliesBothModuli) {
  ModuliField field(moduli({young, 0.3}));
  field.set_factor([](const meshes::Place&) { return 1.7; });

  const Moduli found = field.at({0.0, 0.0, 0.0});

  const Moduli expected = moduli({1.7 * young, 0.3});
  EXPECT_NEAR(found.lame_modulus / expected.lame_modulus, 1.0, 1e-14);
  EXPECT_NEAR(found.shear_modulus / expected.shear_modulus, 1.0, 1e-14);
}

TEST(ModuliField, CountsAnExpressionsLengthsInTheSurfaces) {
  mechanics::MaterialSpec material;
  material.variation = mechanics::MaterialVariation{};
  material.variation->factor = "1 + 2*x + sin(pi*y)^2 * exp(-z)";

  const ModuliField field =
      moduli_field(material, scales, {young, 0.3}, grid, 4e-6);

  const double expected = 1.0 + 2.0 * 0.25 + 0.5 * std::exp(-0.5);
  EXPECT_NEAR(field.at({1e-6, 1e-6, 2e-6}).shear_modulus /
                  moduli({young, 0.3}).shear_modulus,
              expected, 1e-14);
}

TEST(ModuliField, QuotesTheParserAndTheColumn) {
  EXPECT_NE(words_of("1 + * x").find("column"), std::string::npos);
  EXPECT_NE(words_of("1 + depth").find("depth"), std::string::npos);
  EXPECT_NE(words_of("1 + depth").find("(column 5)"), std::string::npos)
      << words_of("1 + depth");
  EXPECT_EQ(words_of("1 + x*y*z"), "accepted");
  ModuliField field(moduli({young, 0.3}));
  field.set_factor(expression_factor("x - 1", 1e-6));
  EXPECT_THROW(field.at({0.5e-6, 0.0, 0.0}), std::domain_error);
}

// The random factors of cells are uniformly distributed in 1 -+ spread,
// independent of the order in which they are requested. Tolerance: 4 sigma of
// the mean of n uniform numbers and of their mean square.
TEST(ModuliField, DrawsFactorsOfPlacesAlone) {
  const ModulusFactor factor = random_factor(0.5, 7, 0.5e-6);
  const ModulusFactor other = random_factor(0.5, 8, 0.5e-6);
  const ModulusFactor of_high_word =
      random_factor(0.5, 7 + (std::uint64_t{1} << 32), 0.5e-6);
  double mean = 0.0, square = 0.0;
  std::set<double> seen;
  constexpr int n = 12;
  for (int i = 0; i < n * n * n; ++i) {
    const meshes::Place place{(i % n + 0.5) * 0.5e-6,
                              (i / n % n + 0.5) * 0.5e-6,
                              (i / n / n + 0.5) * 0.31e-6};
    const double value = factor(place);
    EXPECT_EQ(value, factor({place[0] * (1.0 + 1e-15), place[1], place[2]}));
    EXPECT_NE(value, other(place));
    EXPECT_NE(value, of_high_word(place));
    seen.insert(value);
    mean += value - 1.0;
    square += (value - 1.0) * (value - 1.0);
  }

  constexpr double count = n * n * n;
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(count));
  EXPECT_LT(*seen.rbegin(), 1.5);
  EXPECT_GT(*seen.begin(), 0.5);
  EXPECT_NEAR(mean / count, 0.0, 4.0 * 0.5 / std::sqrt(3.0 * count));
  EXPECT_NEAR(square / count, 0.25 / 3.0,
              4.0 * 0.25 * std::sqrt(4.0 / 45.0 / count));
}

// x runs fastest, then y, then z; the index of a box follows from the counts
// along each axis.
TEST(ModuliField, FindsABoxByXThenYThenZ) {
  FactorTable table{{2, 3, 4}, {}, {2e-6, 3e-6, 4e-6}};
  for (int i = 0; i < 24; ++i)
    table.factors.push_back(1.0 + i);

  const ModulusFactor factor = table_factor(table);

  for (int i = 0; i < 24; ++i)
    EXPECT_EQ(factor({(i % 2 + 0.5) * 1e-6, (i / 2 % 3 + 0.5) * 1e-6,
                      (i / 6 + 0.5) * 1e-6}),
              1.0 + i);
}

/// The factor of E at a position in a field with that variation.
double factor_at(const mechanics::MaterialVariation& variation,
                 const meshes::Place& place) {
  mechanics::MaterialSpec material;
  material.variation = variation;
  return moduli_field(material, scales, {young, 0.3}, grid, 2e-6)
             .at(place)
             .shear_modulus /
         moduli({young, 0.3}).shear_modulus;
}

// Verifies that the table of a case covers the block down to its depth, which
// is not its length, and that its random factors use the spacing of the
// surface. Tolerance: roundoff.
TEST(ModuliField, LaysACasesVariationOverTheBlock) {
  const std::string path =
      (std::filesystem::temp_directory_path() / "asperity_case_factors.txt")
          .string();
  std::ofstream(path) << "# boxes 1 2 2\n1\n2\n3\n4\n";
  mechanics::MaterialVariation table;
  table.kind = mechanics::VariationKind::table;
  table.file = path;
  mechanics::MaterialVariation random;
  random.kind = mechanics::VariationKind::random;
  random.spread = 0.5;
  random.seed = 7;
  const meshes::Place place{0.75e-6, 3.25e-6, 1.5e-6};

  EXPECT_NEAR(factor_at(table, {1e-6, 1e-6, 0.9e-6}), 1.0, 1e-15);
  EXPECT_NEAR(factor_at(table, {1e-6, 3e-6, 0.9e-6}), 2.0, 1e-15);
  EXPECT_NEAR(factor_at(table, {1e-6, 1e-6, 1.1e-6}), 3.0, 1e-15);
  EXPECT_NEAR(factor_at(random, place),
              random_factor(0.5, 7, grid.spacing_x())(place), 1e-15);
  random.edge = {4.0, mechanics::ReferenceUnit::spacing};
  EXPECT_NEAR(factor_at(random, place),
              random_cubes(0.5, 7, 4.0 * grid.spacing_x())(place), 1e-15);
  std::remove(path.c_str());
}

// Places of one cube share a factor, also at the origin and at negative
// coordinates; neighbouring cubes have factors of their own in 1 -+ spread.
TEST(ModuliField, GivesEveryCubeARandomFactor) {
  const ModulusFactor factor = random_cubes(0.5, 3, 2.0);
  std::vector<double> found;
  for (const double x : {-1.0, 1.0, 3.0, 5.0})
    for (const double z : {1.0, 3.0}) {
      found.push_back(factor({x, 1.0, z}));
      EXPECT_EQ(factor({x - 0.9, 0.1, z + 0.9}), found.back());
      EXPECT_GE(found.back(), 0.5);
      EXPECT_LE(found.back(), 1.5);
    }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
}

TEST(ModuliField, ReadsATableOfBoxes) {
  const std::string path =
      (std::filesystem::temp_directory_path() / "asperity_factors.txt")
          .string();
  std::ofstream(path) << "# boxes 2 1 3\n1 2\n3 4\n5 6\n";

  const ModulusFactor factor =
      table_factor(read_factor_table(path, {4e-6, 4e-6, 3e-6}));

  EXPECT_EQ(factor({1e-6, 3e-6, 0.5e-6}), 1.0);
  EXPECT_EQ(factor({3e-6, 1e-6, 0.5e-6}), 2.0);
  EXPECT_EQ(factor({3e-6, 1e-6, 2.5e-6}), 6.0);
  std::ofstream(path) << "# boxes 2 2 3\n1 2\n3 4\n5 6\n";
  EXPECT_THROW(read_factor_table(path, {1.0, 1.0, 1.0}), std::runtime_error);
  std::ofstream(path) << "# boxes 2 1 2\n1 2\n3 0\n";
  try {
    read_factor_table(path, {1.0, 1.0, 1.0});
    FAIL() << "a factor of 0 was taken";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(path + ":3: factor 0.0"),
              std::string::npos)
        << error.what();
  }
  std::remove(path.c_str());
}

} // namespace asperity::fem::moduli_field_test
