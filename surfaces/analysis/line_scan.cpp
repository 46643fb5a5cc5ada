#include "surfaces/analysis/line_scan.hpp"

#include "base/fourier.hpp"
#include "base/require.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/text/number_table.hpp"
#include "surfaces/maps/height_map.hpp"
#include "surfaces/maps/levelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <fstream>
#include <numbers>
#include <sstream>

namespace asperity::surfaces {
namespace {

constexpr std::size_t fewest_points = 16;
constexpr double step_tolerance = 0.01;

bool has_equal_steps(const NumberTable& table) {
  const double mean = (table.number(table.rows() - 1, 0) - table.number(0, 0)) /
                      static_cast<double>(table.rows() - 1);
  if (!(mean > 0.0))
    return false;
  for (std::size_t row = 1; row < table.rows(); ++row)
    if (std::abs(table.number(row, 0) - table.number(row - 1, 0) - mean) >
        step_tolerance * mean)
      return false;
  return true;
}

bool is_line(const NumberTable& table) {
  return table.columns == 1 || table.rows() == 1 ||
         (table.columns == 2 && table.rows() >= fewest_points &&
          has_equal_steps(table));
}

/// Number of entries of a line of a text table; 0 for comments and for lines
/// that do not begin with a number.
int count_numbers(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r,;");
  if (first == std::string::npos ||
      std::string("+-.0123456789").find(line[first]) == std::string::npos)
    return 0;
  int count = 0;
  bool was_gap = true;
  for (const char c : line) {
    const bool is_gap = std::string(" \t\r,;").find(c) != std::string::npos;
    count += was_gap && !is_gap;
    was_gap = is_gap;
  }
  return count;
}

std::vector<double> hann_window(std::size_t points) {
  std::vector<double> window(points);
  for (std::size_t i = 0; i < points; ++i)
    window[i] =
        std::pow(std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) /
                          static_cast<double>(points)),
                 2);
  return window;
}

/// A piece C_1 = density (q/start)^exponent, start <= q <= end.
struct PowerPiece {
  double start = 0.0;
  double end = 0.0;
  double density = 0.0;
  double exponent = 0.0;
};

std::vector<PowerPiece> pieces_of(const std::vector<SpectrumRing>& rows) {
  std::vector<PowerPiece> pieces;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    pieces.push_back(
        {rows[i].wavevector, rows[i + 1].wavevector, rows[i].density,
         std::log(rows[i + 1].density / rows[i].density) /
             std::log(rows[i + 1].wavevector / rows[i].wavevector)});
  // Beyond the last row, in octaves; what is left out falls with 1/q at least
  // once more than C_1.
  const double exponent = std::min(-1.0, pieces.back().exponent);
  double start = rows.back().wavevector;
  double density = rows.back().density;
  for (int octave = 0; octave < 40; ++octave) {
    pieces.push_back({start, 2.0 * start, density, exponent});
    start *= 2.0;
    density *= std::pow(2.0, exponent);
  }
  return pieces;
}

/// int -C_1'(q) dq/sqrt(q^2 - k^2) over one piece, q >= k. With u = sqrt(q^2 -
/// k^2) the integrand -C_1'(q)/q du is smooth; the rule is Gauss-Legendre of
/// 5 points on four parts.
double abel_integral(const PowerPiece& piece, double wavevector) {
  static constexpr double nodes[] = {-0.9061798459386640, -0.5384693101056831,
                                     0.0, 0.5384693101056831,
                                     0.9061798459386640};
  static constexpr double weights[] = {0.2369268850561891, 0.4786286704993665,
                                       0.5688888888888889, 0.4786286704993665,
                                       0.2369268850561891};
  constexpr int parts = 4;
  const double square = wavevector * wavevector;
  const auto distance = [&](double q) {
    return std::sqrt(std::max(0.0, q * q - square));
  };
  const double begin = distance(std::max(piece.start, wavevector));
  const double width = (distance(piece.end) - begin) / parts;
  double sum = 0.0;
  for (int part = 0; part < parts; ++part)
    for (int i = 0; i < 5; ++i) {
      const double u = begin + width * (part + 0.5 + 0.5 * nodes[i]);
      const double q = std::sqrt(square + u * u);
      sum += 0.5 * width * weights[i] * -piece.exponent * piece.density *
             std::pow(q / piece.start, piece.exponent) / (q * q);
    }
  return sum;
}

} // namespace

bool is_line_scan(const std::string& path) {
  // A map need not be parsed twice: the first two rows tell.
  constexpr std::size_t head_size = 65536;
  std::string head(head_size, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), head_size);
  head.resize(static_cast<std::size_t>(file.gcount()));
  if (head.empty() || head.find('\0') != std::string::npos ||
      head.starts_with("PK")) // an archive
    return false;
  std::istringstream lines(head);
  int rows = 0;
  int columns = 0;
  for (std::string line; rows < 2 && std::getline(lines, line);) {
    const int numbers = count_numbers(line);
    if (numbers == 0)
      continue;
    ++rows;
    columns = std::max(columns, numbers);
  }
  const bool may_be_line =
      rows > 0 && (columns <= 2 || (rows == 1 && head.size() < head_size));
  if (!may_be_line)
    return false;
  try {
    return is_line(read_number_file(path));
  } catch (const input::InputError&) {
    return false; // text of an instrument, which has its own reader
  }
}

LineScan read_line_scan(const std::string& path, const LineScale& scale) {
  require_positive("length", scale.length, "m");
  require_positive("height_unit", scale.height_unit, "m");
  NumberTable table = read_number_file(path);
  if (!is_line(table))
    throw input::InputError(fmt::format(
        "{}: {} columns and {} rows, but a line scan has one column, one row, "
        "or two columns x and z with x ascending in equal steps",
        path, table.columns, table.rows()));
  LineScan line;
  if (table.columns == 2 && table.rows() > 1)
    for (std::size_t row = 0; row < table.rows(); ++row)
      line.heights.push_back(table.number(row, 1));
  else
    line.heights = std::move(table.numbers);
  if (line.heights.size() < fewest_points)
    throw input::InputError(
        fmt::format("{}: {} points, but a line scan must have at least {}",
                    path, line.heights.size(), fewest_points));
  line.spacing = scale.length / static_cast<double>(line.heights.size());
  for (double& height : line.heights)
    height *= scale.height_unit;
  return line;
}

void level_line(LineScan& line, int degree) {
  HeightMap map{{static_cast<int>(line.heights.size()), 1, line.length(), 1.0},
                std::move(line.heights)};
  remove_trend(map, degree == 0   ? mechanics::Levelling::none
                    : degree == 1 ? mechanics::Levelling::plane
                                  : mechanics::Levelling::bow);
  line.heights = std::move(map.heights);
}

ProfileParameters profile_parameters(const LineScan& line) {
  ProfileParameters found;
  const auto count = static_cast<double>(line.heights.size());
  double mean = 0.0;
  for (const double height : line.heights)
    mean += height / count;
  double cube = 0.0;
  double fourth = 0.0;
  for (const double node : line.heights) {
    const double height = node - mean;
    found.pa += std::abs(height) / count;
    found.pq += height * height / count;
    cube += std::pow(height, 3) / count;
    fourth += std::pow(height, 4) / count;
  }
  found.psk = cube / std::pow(found.pq, 1.5);
  found.pku = fourth / (found.pq * found.pq);
  found.pq = std::sqrt(found.pq);
  const auto [lowest, highest] =
      std::minmax_element(line.heights.begin(), line.heights.end());
  found.pt = *highest - *lowest;
  for (std::size_t i = 0; i + 1 < line.heights.size(); ++i) {
    const double slope = (line.heights[i + 1] - line.heights[i]) / line.spacing;
    found.pdq += slope * slope / (count - 1.0);
    if (i == 0)
      continue;
    const double second =
        (line.heights[i + 1] - 2.0 * line.heights[i] + line.heights[i - 1]) /
        (line.spacing * line.spacing);
    found.rms_second += second * second / (count - 2.0);
    found.lowest_second = std::min(found.lowest_second, second);
  }
  found.pdq = std::sqrt(found.pdq);
  found.rms_second = std::sqrt(found.rms_second);
  return found;
}

std::vector<SpectrumRing> line_spectrum(const LineScan& line) {
  const std::size_t points = line.heights.size();
  const std::vector<double> window = hann_window(points);
  double weights = 0.0;
  double squares = 0.0;
  double mean = 0.0;
  for (std::size_t i = 0; i < points; ++i) {
    weights += window[i];
    squares += window[i] * window[i] / static_cast<double>(points);
    mean += window[i] * line.heights[i];
  }
  mean /= weights;
  std::vector<double> shown(points);
  for (std::size_t i = 0; i < points; ++i)
    shown[i] = window[i] * (line.heights[i] - mean);

  const Grid grid{static_cast<int>(points), 1, line.length(), 1.0};
  std::vector<std::complex<double>> modes(grid.half_spectrum_size());
  RealFourier(grid).forward(shown, modes);
  constexpr double dependent = 1.0 + 2.0 * (4.0 / 9.0 + 1.0 / 36.0);
  std::vector<SpectrumRing> rows;
  for (std::size_t j = 1; j < modes.size(); ++j) {
    const bool is_nyquist = 2 * j == points;
    const double power = std::norm(modes[j] / static_cast<double>(points)) /
                         squares; // of q alone
    const double count = is_nyquist ? 1.0 : 2.0;
    rows.push_back({wavevector(static_cast<int>(j), line.length()),
                    power * line.length() / (2.0 * std::numbers::pi),
                    count / dependent, count * power});
  }
  return rows;
}

std::vector<SpectrumRing>
isotropic_from_line(const std::vector<SpectrumRing>& rows) {
  if (rows.size() < 3)
    refuse_argument("rows", static_cast<double>(rows.size()), ">= 3");
  const std::vector<PowerPiece> pieces = pieces_of(rows);
  std::vector<SpectrumRing> converted;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    double sum = 0.0;
    for (std::size_t piece = i; piece < pieces.size(); ++piece)
      sum += abel_integral(pieces[piece], rows[i].wavevector);
    if (sum > 0.0)
      converted.push_back({rows[i].wavevector, sum / std::numbers::pi,
                           rows[i].degrees_of_freedom, 0.0});
  }
  return converted;
}

} // namespace asperity::surfaces
