// Tests of surfaces/formats/tabulated_spectrum.hpp: interpolation, moments, and
// the messages about an invalid table.
#include "input/input_error.hpp"
#include "surfaces/formats/tabulated_spectrum.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::surfaces::tabulated_spectrum_test {

TabulatedSpectrum read(const std::string& text) {
  return read_tabulated_spectrum_text(text, "polymer.csv");
}

// A power law is interpolated exactly, since it is straight in a log-log plot:
// C = 5 q^-3 between three irregular points. Tolerance: some eps.
TEST(TabulatedSpectrum, IsStraightInALogLogPlot) {
  const TabulatedSpectrum spectrum({1.0, 2.0, 10.0}, {5.0, 0.625, 0.005});

  for (const double q : {1.0, 1.3, 2.0, 3.7, 9.9, 10.0})
    EXPECT_NEAR(spectrum(q) * q * q * q, 5.0, 2e-14) << q;
}

TEST(TabulatedSpectrum, IsZeroOutsideAndClosedAtItsEnds) {
  const TabulatedSpectrum spectrum({1.0, 2.0}, {3.0, 4.0});

  EXPECT_EQ(spectrum(0.99), 0.0);
  EXPECT_EQ(spectrum(2.01), 0.0);
  EXPECT_NEAR(spectrum(1.0 - 1e-12), 3.0, 1e-10);
  EXPECT_NEAR(spectrum(2.0 + 1e-12), 4.0, 1e-10);
}

// The formula of a spectrum that is tabulated at its kinks is reproduced: same
// values, same moments, by two different implementations.
TEST(TabulatedSpectrum, EqualsTheFormulaItWasTakenFrom) {
  const auto formula =
      SelfAffineSpectrum::with_rms_height({0.8, 1e6, 3e6, 8e7}, 1e-8);
  const TabulatedSpectrum table({1e6, 3e6, 8e7},
                                {formula(1e6), formula(3e6), formula(8e7)});

  for (const double q : {1e6, 2e6, 5e6, 7.9e7})
    EXPECT_NEAR(table(q) / formula(q), 1.0, 1e-14);
  for (const int order : {0, 2, 4})
    EXPECT_NEAR(table.moment(order) / formula.moment(order), 1.0, 1e-13);
  EXPECT_EQ(table.isotropic().wavevector_high(), 8e7);
}

TEST(TabulatedSpectrumReader, TakesCommentsCommasAndWindowsLineEnds) {
  const TabulatedSpectrum spectrum = read("# q [1/m], C [m^4]\r\n"
                                          "1e6, 2e-30\r\n"
                                          "\r\n"
                                          "# the roll-off\r\n"
                                          "+4e6\t1e-30\r\n"
                                          "8e6;1E-31\r\n");

  EXPECT_NEAR(spectrum(4e6) / 1e-30, 1.0, 1e-14);
  EXPECT_EQ(spectrum.isotropic().kinks, (std::vector<double>{1e6, 4e6, 8e6}));
}

std::string message_of(const std::string& text) {
  return tests::message_of<input::InputError>([&] { read(text); });
}

TEST(TabulatedSpectrumReader, NamesTheMistakeAndItsPlace) {
  EXPECT_EQ(message_of("# only words\n"), "polymer.csv: contains no numbers");
  EXPECT_EQ(message_of("1 2 3\n4 5 6\n"),
            "polymer.csv:1: 3 columns, but must be 2: q [1/m] and C [m^4]");
  EXPECT_EQ(message_of("1 2\n3 4 5\n"),
            "polymer.csv:2: 3 numbers in this row, but 2 in line 1; every row "
            "must have the same number");
  EXPECT_EQ(message_of("q C\n1 2\n"),
            "polymer.csv:1: column 1: found 'q', but must be a finite number");
  EXPECT_EQ(message_of("2 1\n1 1\n"),
            "polymer.csv:2: q = 1, but must be > 2 [1/m]: wavevectors must "
            "increase from row to row");
  EXPECT_EQ(message_of("#\n0 1\n1 1\n"),
            "polymer.csv:2: q = 0, but must be > 0 [1/m]: wavevectors must "
            "increase from row to row");
  EXPECT_EQ(message_of("1 1\n2 0\n"),
            "polymer.csv:2: C = 0, but must be > 0 [m^4]; leave out rows "
            "without power");
  EXPECT_EQ(message_of("1 1\n"),
            "polymer.csv:1: one row, but a spectrum must have at least two");
}

TEST(TabulatedSpectrumReader, ReportsAMissingFile) {
  try {
    read_tabulated_spectrum("no/such/spectrum.csv");
    FAIL() << "a missing file was accepted";
  } catch (const input::InputError& error) {
    EXPECT_STREQ(error.what(), "no/such/spectrum.csv: there is no such file");
  }
}

TEST(TabulatedSpectrum, RefusesBadArgumentsByName) {
  EXPECT_THROW(TabulatedSpectrum({1.0}, {1.0}), std::domain_error);
  EXPECT_THROW(TabulatedSpectrum({1.0, 2.0}, {1.0}), std::domain_error);
  EXPECT_THROW(TabulatedSpectrum({2.0, 1.0}, {1.0, 1.0}), std::domain_error);
  EXPECT_THROW(TabulatedSpectrum({1.0, 2.0}, {1.0, 0.0}), std::domain_error);
}

} // namespace asperity::surfaces::tabulated_spectrum_test
