#pragma once

// Analyses line scans: profile parameters, the one-dimensional spectrum, and
// its conversion to the spectrum C(q) of an isotropic surface.

#include "surfaces/analysis/spectrum_estimate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::surfaces {

/// Heights at equal distances along a line.
struct LineScan {
  double spacing = 0.0;        ///< [m] > 0
  std::vector<double> heights; ///< [m]

  double length() const {
    return spacing * static_cast<double>(heights.size());
  }
};

/// Lengths and units that a file of numbers does not state, as given by the
/// options of `asperity surface` that have these names.
struct LineScale {
  std::optional<double>
      length; ///< number of points times their spacing [m] > 0
  std::optional<double> height_unit; ///< [m] per unit of the heights > 0
  std::optional<double> length_unit; ///< [m] per unit of the column x > 0
};

/// Whether a text file of numbers is a line scan: one column, one row, or two
/// columns and at least four rows, without a header that gives the sides of a
/// map. False for a file that is not a table of numbers.
bool is_line_scan(const std::string& path);

/// Reads such a file, which may have header lines and decimal commas. The
/// spacing of two columns x and z is that of x, ascending or descending, whose
/// positions must be equidistant as those of lists (xyz_list.hpp). The units in
/// the last header line that has any are used: "x [mm]; z [um]"
/// (column_heads.hpp). One that is no unit of length is refused.
/// Otherwise x needs `length_unit`, or a `length` that is the number of points,
/// or one less, times their spacing in some unit of length.
/// @throws input::InputError  the file is no line scan, with the line of the
///                            point that is missing or not equidistant; it has
///                            fewer than 16 points; or a scale is missing or
///                            contradicts the file
LineScan read_line_scan(const std::string& path, const LineScale& scale);

/// Subtracts the least-squares polynomial of degree 0, 1 or 2.
void level_line(LineScan& line, int degree);

/// Parameters of the unfiltered profile (ISO 21920-2).
struct ProfileParameters {
  double pa = 0.0;            ///< mean of |z| [m]
  double pq = 0.0;            ///< root mean square [m]
  double psk = 0.0;           ///< skewness [1]
  double pku = 0.0;           ///< kurtosis [1]
  double pt = 0.0;            ///< highest minus lowest [m]
  double pdq = 0.0;           ///< rms slope by forward differences [1]
  double rms_second = 0.0;    ///< rms of the second difference [1/m]
  double lowest_second = 0.0; ///< smallest second difference [1/m]
};

ProfileParameters profile_parameters(const LineScan& line);

/// The one-dimensional spectrum of a line, windowed by Hann's window and
/// divided by its mean square 3/8:
///
///     C_1(q) = (1/(2 pi)) int <h(x) h(0)> e^{-i q x} dx     [m^3]
///     <h^2>  = 2 int_0^inf C_1 dq
///
/// Rings of SpectrumRing hold C_1 in `density` here; they are single
/// wavevectors 2 pi j/L, j >= 1, with nu = 2/1.94 (the neighbours of a windowed
/// mode).
std::vector<SpectrumRing> line_spectrum(const LineScan& line);

/// C(q) [m^4] of the isotropic surface whose lines have the spectrum C_1. The
/// profile sees C_1(q) = 2 int_q^inf C(k) k dk/sqrt(k^2 - q^2), an Abel
/// transform, so that
///
///     C(k) = -(1/pi) int_k^inf C_1'(q) dq/sqrt(q^2 - k^2)
///
/// with C_1 interpolated linearly in log-log coordinates between the rows and
/// continued beyond the last by the power law of the last two, but not flatter
/// than q^-1. Rows whose C is not positive, where the scatter of C_1 exceeds
/// its slope, are left out.
/// @param rows  C_1 in a few steps per decade, ascending, at least 3
/// @return  C at the wavevectors of the rows but the last, with their nu
/// @see  P. R. Nayak, Wear 26, 165 (1973); B. N. J. Persson et al., J. Phys.:
///       Condens. Matter 17, R1 (2005), Appendix
std::vector<SpectrumRing>
isotropic_from_line(const std::vector<SpectrumRing>& rows);

} // namespace asperity::surfaces
