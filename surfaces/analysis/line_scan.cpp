#include "surfaces/analysis/line_scan.hpp"

#include "base/fourier.hpp"
#include "base/plain_text.hpp"
#include "base/require.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "input/units.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"
#include "surfaces/formats/text/column_heads.hpp"
#include "surfaces/formats/text/number_table.hpp"
#include "surfaces/formats/text/text_header.hpp"
#include "surfaces/formats/text/xyz_list.hpp"
#include "surfaces/maps/height_map.hpp"
#include "surfaces/maps/levelling.hpp"
#include "surfaces/maps/statistics.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

namespace asperity::surfaces {
namespace {

constexpr std::size_t fewest_points = 16;

/// Whether a header gives the sides of a map.
bool is_headed_map(const NumberTable& table) {
  const MatrixHeader header = matrix_header(table);
  return gwyddion_header(table).width.line != 0 || header.length_x ||
         header.cell_size;
}

bool is_line(const NumberTable& table) {
  return table.columns == 1 || table.rows() == 1 ||
         (table.columns == 2 && table.rows() >= 4);
}

/// The unit that the last header line with a unit for any column gives for one;
/// its line is 0 if there is none.
/// @param column  of a table with one row: 0
CommentLine header_unit(const NumberTable& table, std::size_t column) {
  const std::size_t columns = table.rows() == 1 ? 1 : table.columns;
  for (const CommentLine& line : lines_above_numbers(table)) {
    const std::vector<ColumnHead> heads = column_heads(line.text, columns);
    const bool is_header =
        heads.size() == columns &&
        std::ranges::any_of(heads, [](const ColumnHead& head) {
          return surfaces::length_unit(head.unit).has_value();
        });
    const bool has_all =
        heads.size() == columns &&
        std::ranges::none_of(
            heads, [](const ColumnHead& head) { return head.unit.empty(); });
    if (is_header || has_all)
      return {heads[column].unit.empty() ? 0 : line.line, heads[column].unit};
  }
  return {};
}

/// The unit of a column, from the header or the option.
/// @param given  by the option
std::optional<double> unit_of(const NumberTable& table, std::size_t column,
                              const std::optional<double>& given,
                              const char* option) {
  const CommentLine unit = header_unit(table, table.rows() == 1 ? 0 : column);
  if (unit.line == 0)
    return given;
  const std::optional<double> metres = surfaces::length_unit(unit.text);
  if (!metres)
    refuse_line(table.name, unit.line,
                fmt::format("column {} has the unit '{}', which is no unit of "
                            "length; known are {} and others: correct the "
                            "header, or remove it and give {}",
                            column + 1, printable(unit.text),
                            known_length_units(), option));
  if (given && std::abs(*given / *metres - 1.0) > 1e-9)
    throw input::InputError(fmt::format(
        "{} = {:.6g} m, but line {} of {} gives the unit '{}'; leave it out",
        option, *given, unit.line, table.name, printable(unit.text)));
  return metres;
}

/// The unit of x for which a number of points, or one less, times their
/// spacing is the length [m].
double unit_for_length(const NumberTable& table, const ListAxis& x,
                       double length) {
  for (const input::Unit& unit : input::units()) {
    const double points = length / (unit.in_si(1.0) * x.spacing);
    const auto count = static_cast<double>(x.points);
    if (unit.dimension == input::Dimension::length && points > count - 1.5 &&
        points < count + 0.5)
      return unit.in_si(1.0);
  }
  throw input::InputError(fmt::format(
      "--length = {:.6g} m, but the {} points of {} are {:.6g} apart in the "
      "column x, which is that length in no unit; give --length-unit instead",
      length, x.points, table.name, x.spacing));
}

/// Whether x grows or falls from row to row on an axis with as many points.
bool is_in_order(const NumberTable& table, const ListAxis& x) {
  const bool is_descending = table.number(0, 0) > table.number(1, 0);
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (x.index_of(table.number(row, 0)) !=
        (is_descending ? table.rows() - 1 - row : row))
      return false;
  return x.points == table.rows();
}

/// @throws input::InputError  x is not equidistant, with the first such line
[[noreturn]] void refuse_positions(const NumberTable& table) {
  const double mean = (table.number(table.rows() - 1, 0) - table.number(0, 0)) /
                      static_cast<double>(table.rows() - 1);
  std::size_t worst = 1;
  const auto step = [&](std::size_t row) {
    return table.number(row, 0) - table.number(row - 1, 0);
  };
  for (std::size_t row = 2; row < table.rows(); ++row)
    if (std::abs(step(row) - mean) > std::abs(step(worst) - mean))
      worst = row;
  bool is_whole = true; // "0,5" is read as two columns
  for (std::size_t row = 0; row < table.rows(); ++row)
    is_whole =
        is_whole && table.number(row, 0) == std::round(table.number(row, 0));
  refuse_line(
      table.name, table.lines[worst],
      fmt::format("x is {:.6g} after {:.6g}, but the mean step is {:.6g}; the "
                  "positions of a line scan must be equidistant: interpolate "
                  "the heights first, or read a matrix of two columns by --set "
                  "surface.format=plain{}",
                  table.number(worst, 0), table.number(worst - 1, 0), mean,
                  is_whole ? "; if 0,5 is one number here, write 0.5" : ""));
}

/// @param scale  gives the unit of x or the length, or the header does
double spacing_of(const NumberTable& table, const LineScale& scale) {
  const std::optional<ListAxis> x = axis_of(table, 0);
  if (!x || !is_in_order(table, *x))
    refuse_positions(table);
  const std::optional<double> unit =
      unit_of(table, 0, scale.length_unit, "--length-unit");
  const double of_length =
      scale.length ? unit_for_length(table, *x, *scale.length) : *unit;
  if (unit && std::abs(of_length / *unit - 1.0) > 1e-9)
    throw input::InputError(fmt::format(
        "--length = {:.6g} m, but the {} points of {} have a length of {:.6g} "
        "m; leave it out",
        *scale.length, x->points, table.name,
        *unit * x->spacing * static_cast<double>(x->points)));
  return x->spacing * of_length;
}

void require_no_missing(const NumberTable& table) {
  for (std::size_t i = 0; i < table.numbers.size(); ++i)
    if (!std::isfinite(table.numbers[i]))
      refuse_line(table.name, table.lines[i / table.columns],
                  fmt::format("column {}: the number is missing, but a line "
                              "scan must be complete; interpolate it first",
                              i % table.columns + 1));
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
/// k^2) the integrand -C_1'(q)/q du is smooth.
double abel_integral(const PowerPiece& piece, double wavevector) {
  const double square = wavevector * wavevector;
  const auto distance = [&](double q) {
    return std::sqrt(std::max(0.0, q * q - square));
  };
  return boost::math::quadrature::gauss<double, 20>::integrate(
      [&](double u) {
        const double q = std::sqrt(square + u * u);
        return -piece.exponent * piece.density *
               std::pow(q / piece.start, piece.exponent) / (q * q);
      },
      distance(std::max(piece.start, wavevector)), distance(piece.end));
}

} // namespace

bool is_line_scan(const std::string& path) {
  try {
    const MapBytes bytes = MapBytes::of_file(path);
    // A text of no own format.
    if (format_of_map(bytes, "auto").name != std::string_view())
      return false;
    NumberTableReader reader(path, NumberStyle::profile);
    std::size_t columns = 0;
    each_line(bytes.all(), [&](std::string_view line) {
      reader.take(line);
      columns = std::max(columns, reader.numbers_so_far().size());
      // A map need not be parsed twice: two rows tell.
      return reader.rows() <= 1 || columns <= 2;
    });
    if (reader.rows() > 1 && columns > 2)
      return false;
    const NumberTable table = reader.finish();
    return is_line(table) && !is_headed_map(table);
  } catch (const input::InputError&) {
    return false; // text of an instrument, which has its own reader
  }
}

LineScan read_line_scan(const std::string& path, const LineScale& scale) {
  for (const auto& [name, value] :
       {std::pair("length", scale.length),
        std::pair("height_unit", scale.height_unit),
        std::pair("length_unit", scale.length_unit)})
    if (value)
      require_positive(name, *value, "m");
  NumberTable table =
      read_number_text(input::read_input_file(path, input::largest_number_file),
                       path, NumberStyle::profile);
  if (!is_line(table))
    throw input::InputError(fmt::format(
        "{}: {} columns and {} rows, but a line scan has one column, one row, "
        "or two columns x and z",
        path, table.columns, table.rows()));
  const bool has_positions = table.columns == 2 && table.rows() > 1;
  const std::size_t points =
      has_positions ? table.rows() : table.numbers.size();
  if (points < fewest_points)
    throw input::InputError(
        fmt::format("{}: {} points, but a line scan must have at least {}",
                    path, points, fewest_points));
  require_no_missing(table);
  const std::optional<double> unit =
      unit_of(table, table.columns - 1, scale.height_unit, "--height-unit");
  std::vector<const char*> missing, options;
  if (!scale.length && !(has_positions && unit_of(table, 0, scale.length_unit,
                                                  "--length-unit"))) {
    missing.push_back(has_positions ? "the unit of x" : "its length");
    options.push_back(has_positions ? "--length-unit um" : "--length \"5 mm\"");
  }
  if (!unit) {
    missing.push_back("the unit of its heights");
    options.push_back("--height-unit um");
  }
  if (!missing.empty())
    throw input::InputError(fmt::format(
        "{}: is a line scan, which does not give {}; give, for example, {}",
        path, fmt::join(missing, " and "), fmt::join(options, " ")));
  LineScan line;
  if (has_positions) {
    line.spacing = spacing_of(table, scale);
    for (std::size_t row = 0; row < table.rows(); ++row)
      line.heights.push_back(table.number(row, 1));
    if (table.number(0, 0) > table.number(1, 0))
      std::ranges::reverse(line.heights);
  } else {
    if (scale.length_unit)
      throw input::InputError(fmt::format(
          "--length-unit: {} is a line scan without positions; give --length",
          path));
    line.spacing = *scale.length / static_cast<double>(points);
    line.heights = std::move(table.numbers);
  }
  for (double& height : line.heights)
    height *= *unit;
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
  const auto count = static_cast<double>(line.heights.size());
  const HeightMoments moments = moments_of(line.heights);
  ProfileParameters found{.pa = moments.mean_magnitude,
                          .pq = moments.rms,
                          .psk = moments.skewness,
                          .pku = moments.kurtosis,
                          .pt = moments.highest - moments.lowest};
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
