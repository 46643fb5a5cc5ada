// Tests of surfaces/analysis/line_scan.hpp.
#include "input/input_error.hpp"
#include "surfaces/analysis/line_scan.hpp"
#include "surfaces/formats/tabulated_spectrum.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/realization.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>

namespace asperity::surfaces::line_scan_test {

constexpr double pi = std::numbers::pi;

std::vector<SpectrumRing> rows_of(const std::function<double(double)>& density,
                                  double low, double high, int per_decade) {
  std::vector<SpectrumRing> rows;
  for (int i = 0;; ++i) {
    const double q = low * std::pow(10.0, static_cast<double>(i) / per_decade);
    if (q > high * 1.0001)
      return rows;
    rows.push_back({q, density(q), 10.0, 0.0});
  }
}

std::string written(const std::string& name, const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / name;
  std::ofstream(path) << text;
  return path.string();
}

// C = k^-p has the lines C_1 = q^(1-p) sqrt(pi) Gamma((p-1)/2)/Gamma(p/2). A
// power law is interpolated exactly; the rest is quadrature.
TEST(IsotropicFromLine, InvertsAPowerLawExactly) {
  const double p = 3.6;
  const double factor =
      std::sqrt(pi) * std::tgamma(0.5 * (p - 1.0)) / std::tgamma(0.5 * p);
  const auto rows = rows_of(
      [&](double q) { return factor * std::pow(q, 1.0 - p); }, 1.0, 1e3, 8);

  const auto found = isotropic_from_line(rows);

  ASSERT_EQ(found.size(), rows.size() - 1);
  for (const SpectrumRing& row : found)
    EXPECT_NEAR(row.density * std::pow(row.wavevector, p), 1.0, 1e-5);
}

// C = exp(-k^2) has the lines C_1 = sqrt(pi) exp(-q^2). The interpolation
// between 100 rows per decade is of second order: 4e-4 measured, with a factor
// of two to spare.
TEST(IsotropicFromLine, InvertsAGaussian) {
  const auto rows = rows_of(
      [](double q) { return std::sqrt(pi) * std::exp(-q * q); }, 0.1, 4.0, 100);

  const auto found = isotropic_from_line(rows);

  int compared = 0;
  for (const SpectrumRing& row : found)
    if (row.wavevector < 2.0) {
      EXPECT_NEAR(row.density / std::exp(-row.wavevector * row.wavevector), 1.0,
                  1e-2);
      ++compared;
    }
  EXPECT_GT(compared, 100);
  EXPECT_THROW(isotropic_from_line({rows[0], rows[1]}), std::domain_error);
}

// All lines of a periodic isotropic surface together give its C(q). Tolerance:
// steps of eight per decade, and the scatter of 128 rows.
TEST(LineScan, OfASurfaceGivesItsSpectrum) {
  const double unit = 2.0 * pi;
  const auto exact = SelfAffineSpectrum::with_rms_height(
      {0.8, unit, 4 * unit, 63 * unit}, 1e-3);
  std::vector<SpectrumRing> all;
  for (int r = 0; r < 4; ++r) {
    const HeightMap map = realize(exact.isotropic(), {128, 128, 1.0, 1.0},
                                  {3, r}, mechanics::Amplitudes::gaussian);
    for (std::size_t row = 0; row < 128; ++row) {
      const auto first = map.heights.begin() + static_cast<long>(128 * row);
      const auto rows = line_spectrum({1.0 / 128, {first, first + 128}});
      all.insert(all.end(), rows.begin() + 1, rows.end());
    }
  }

  const auto found = isotropic_from_line(joined_rings(all, 8.0));

  for (const SpectrumRing& row : rings_between(found, 7 * unit, 32 * unit)) {
    EXPECT_NEAR(row.density / exact(row.wavevector), 1.0, 0.25)
        << row.wavevector / unit;
  }
}

// Parseval's theorem with the window: the sum is the weighted variance.
TEST(LineScan, HasASpectrumThatSumsToTheVariance) {
  LineScan line{0.01, {}};
  for (int i = 0; i < 101; ++i)
    line.heights.push_back(std::sin(2.0 * pi * i / 10.0));

  double sum = 0.0;
  for (const SpectrumRing& row : line_spectrum(line))
    sum += row.mean_square_height;

  // Ten waves in the window: 1/2 up to the overlap of their sidelobes.
  EXPECT_NEAR(sum, 0.5, 1e-3);
}

TEST(LineScan, HasTheParametersOfAParabola) {
  LineScan line{0.5, {}};
  for (int i = 0; i < 21; ++i)
    line.heights.push_back(0.125 * (i - 10) * (i - 10)); // x^2/2

  const ProfileParameters found = profile_parameters(line);
  level_line(line, 2);

  EXPECT_NEAR(found.rms_second, 1.0, 1e-12);
  EXPECT_NEAR(found.pt, 12.5, 1e-12);
  EXPECT_NEAR(profile_parameters(line).pq, 0.0, 1e-12);
}

/// 20 points x z with a step of 2 and heights 0, 1, 2, 0, ...
std::string two_columns(const std::string& header, const char* separator,
                        bool has_decimal_commas, bool is_descending) {
  std::string text = header;
  for (int i = 0; i < 20; ++i) {
    const int at = is_descending ? 19 - i : i;
    std::string row = std::to_string(10 + 2 * at) + ".0" + separator +
                      std::to_string(at % 3) + ".0\n";
    if (has_decimal_commas)
      std::ranges::replace(row, '.', ',');
    text += row;
  }
  return text;
}

LineScan line_of(const std::string& text, const LineScale& scale) {
  const std::string path = written("asperity-line.txt", text);
  EXPECT_TRUE(is_line_scan(path)) << text;
  return read_line_scan(path, scale);
}

std::string line_refusal(const std::string& text, const LineScale& scale) {
  std::string message =
      tests::message_of<input::InputError>([&] { line_of(text, scale); });
  EXPECT_NE(message, "");
  const std::string folder =
      std::filesystem::temp_directory_path().string() + "/";
  for (std::size_t at = 0; (at = message.find(folder)) != std::string::npos;)
    message.erase(at, folder.size());
  return message;
}

// The spacing is that of the column x, whatever its order, separator, header
// and decimal sign; a length must be that of the column in some unit.
TEST(LineScan, HasTheSpacingOfItsColumn) {
  const LineScale in_um{{}, 1e-9, 1e-6};
  for (const bool is_descending : {false, true})
    for (const bool has_commas : {false, true}) {
      const LineScan line = line_of(
          two_columns("Profile 1\nx;z\n", "; ", has_commas, is_descending),
          in_um);
      ASSERT_EQ(line.heights.size(), 20U);
      EXPECT_NEAR(line.spacing, 2e-6, 1e-18);
      EXPECT_EQ(line.heights[2], 2e-9);
      EXPECT_EQ(line.heights[19], 1e-9);
    }
  const std::string plain = two_columns("", " ", false, false);
  for (const double length : {40e-6, 38e-6, 40e-3})
    EXPECT_NEAR(line_of(plain, {length, 1e-9, {}}).spacing,
                length > 1e-3 ? 2e-3 : 2e-6, 1e-15);
  const std::string stated =
      two_columns("X [mm]\tZ [nm]\n", "\t", false, false);
  EXPECT_NEAR(line_of(stated, {}).spacing, 2e-3, 1e-15);
  EXPECT_EQ(line_of(stated, {}).heights[1], 1e-9);

  EXPECT_NE(line_refusal(plain, {45e-6, 1e-9, {}})
                .find("which is that length in no unit; give --length-unit"),
            std::string::npos);
  EXPECT_NE(
      line_refusal(plain, {{}, 1e-9, {}})
          .find(
              "does not give the unit of x; give, for example, --length-unit"),
      std::string::npos);
  EXPECT_NE(line_refusal(plain, {}).find(
                "the unit of x and the unit of its heights; give"),
            std::string::npos);
  EXPECT_NE(line_refusal(stated, {{}, 1e-6, {}})
                .find("line 1 of asperity-line.txt gives the unit 'nm'"),
            std::string::npos)
      << line_refusal(stated, {{}, 1e-6, {}});
}

// Each column has the unit of its head, however the head is written. An option
// that says otherwise is refused, and so is a unit that is no length.
TEST(LineScan, HasTheUnitsOfItsHeader) {
  struct Header {
    const char* line;
    const char* separator;
  };

  for (const Header& header :
       {Header{"Lateral [in],Raw [uin]\n", ","},
        Header{"\"Lateral [in]\",\"Raw (uin)\"\n", ","},
        Header{"Lateral (in) Raw (\u00b5in)\n", " "},
        Header{"x / in;z / uin\n", ";"}, Header{"x_in\tz_uin\n", "\t"},
        Header{"% x in   z uin\n", "  "},
        Header{"# x [in] z [uin]\n# measured\n", " "}}) {
    const std::string text =
        two_columns(header.line, header.separator, false, false);
    const LineScan line = line_of(text, {});
    EXPECT_NEAR(line.spacing, 2.0 * 25.4e-3, 1e-15) << header.line;
    EXPECT_NEAR(line.heights[1], 25.4e-9, 1e-20) << header.line;
    EXPECT_NE(line_refusal(text, {{}, {}, 1e-3})
                  .find("--length-unit = 0.001 m, but line 1 of "
                        "asperity-line.txt gives the unit 'in'"),
              std::string::npos);
    EXPECT_NEAR(line_of(text, {{}, {}, 0.0254}).spacing, 0.0508, 1e-15);
  }
  // Only x has a unit, and the option is of the heights.
  const std::string half = two_columns("x [mm],z\n", ",", false, false);
  EXPECT_NEAR(line_of(half, {{}, 1e-9, {}}).spacing, 2e-3, 1e-15);
  EXPECT_NE(line_refusal(half, {{}, 1e-9, 1e-6}).find("gives the unit 'mm'"),
            std::string::npos);

  for (const char* const header :
       {"x [furlong],z [foo]\n", "x (V),z (mV)\n", "x [furlong],z [nm]\n"})
    EXPECT_NE(
        line_refusal(two_columns(header, ",", false, false), {{}, 1e-9, 1e-3})
            .find("asperity-line.txt:1: column"),
        std::string::npos)
        << header;
  EXPECT_EQ(line_refusal(two_columns("x [furlong],z [nm]\n", ",", false, false),
                         {{}, {}, 1e-3}),
            "asperity-line.txt:1: column 1 has the unit 'furlong', which is no "
            "unit of length; known are m, mm, um, nm, angstrom and others: "
            "correct the header, or remove it and give --length-unit");
}

TEST(LineScan, IsReadFromOneColumnOrRow) {
  std::string row, column;
  for (int i = 0; i < 20; ++i) {
    row += std::to_string(i % 3) + (i < 19 ? "," : "\n");
    column += std::to_string(i % 3) + "\r";
  }

  const LineScan found = line_of(row, {40e-6, 1e-9, {}});

  EXPECT_NEAR(found.spacing, 2e-6, 1e-18);
  EXPECT_EQ(found.heights[2], 2e-9);
  EXPECT_EQ(line_of("z [nm]\n" + column, {40e-6, {}, {}}).heights,
            found.heights);
  EXPECT_NE(line_refusal(column, {{}, 1e-9, {}})
                .find("give, for example, --length \"5 mm\""),
            std::string::npos);
  EXPECT_NE(line_refusal(column, {40e-6, 1e-9, 1e-6}).find("--length-unit: "),
            std::string::npos);
}

// What is wrong with a line scan is said of a line scan, with its line.
TEST(LineScan, IsRefusedWithTheLine) {
  const LineScale scale{{}, 1e-9, 1e-6};
  const std::string good = two_columns("", " ", false, false);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return line_refusal(text, scale);
  };
  EXPECT_NE(with("20.0 2.0", "20.0 nan")
                .find("asperity-line.txt:6: column 2: the number is missing"),
            std::string::npos);
  EXPECT_EQ(with("20.0 2.0", "20.5 2.0")
                .find("asperity-line.txt:6: x is 20.5 after 18, but the mean "
                      "step is 2; "),
            0U)
      << with("20.0 2.0", "20.5 2.0");
  EXPECT_NE(with("20.0 2.0", "10.0 2.0").find("must be equidistant"),
            std::string::npos);
  std::string one_column; // with decimal commas
  for (int i = 0; i < 20; ++i)
    one_column += std::to_string(i % 2) + "," + std::to_string(i) + "\n";
  EXPECT_NE(line_refusal(one_column, scale).find("one number here, write 0.5"),
            std::string::npos);
  EXPECT_NE(line_refusal("1 2\n2 5\n3 3\n4 2\n", scale)
                .find("4 points, but a line scan must have at least 16"),
            std::string::npos);
  EXPECT_NE(line_refusal("1\n2\n3\n", scale).find("3 points, but a line scan"),
            std::string::npos);
}

TEST(LineScan, IsNotEveryTable) {
  for (const std::string& text :
       {std::string("1 2 3\n4 5 6\n"), std::string("1 2\n0 5\n3 3\n"),
        std::string(99, '\0'), std::string("PK\x03\x04"), std::string("a b\n"),
        "aISO-1.0\nNumPoints = 1\nNumProfiles = 20\nXscale = 1e-6\n*\n" +
            std::string("1\n2\n3\n4\n5\n"),
        std::string("# Width: 1 um\n# Height: 2 um\n1 2\n3 4\n5 6\n7 8\n")})
    EXPECT_FALSE(is_line_scan(written("asperity-no-line", text))) << text;
  EXPECT_THROW(read_line_scan(written("asperity-map.txt", "1 2 3\n4 5 6\n"),
                              {1.0, 1.0, {}}),
               input::InputError);
}

} // namespace asperity::surfaces::line_scan_test
