#include "suite/exchange/mistakes.hpp"

#include "base/field_sums.hpp"
#include "base/fourier.hpp"
#include "contact/certificate/certificate.hpp"
#include "input/input_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

namespace asperity::exchange {
namespace {

using Field = std::vector<double>;

/// The ratio of the mean pressure to the load that a mistake leads to.
struct LoadMistake {
  double ratio;
  std::string text;
};

std::vector<LoadMistake> load_mistakes(const Problem& problem,
                                       std::size_t load) {
  const Grid& grid = problem.grid;
  const double node_area = grid.spacing_x() * grid.spacing_y();
  std::vector<LoadMistake> known{
      {1e-3, "it seems to be in kPa"},
      {1e-6, "it seems to be in MPa"},
      {1e-9, "it seems to be in GPa"},
      {1e3, "it seems to be in mPa"},
      {10.0, "it seems to be in dyn/cm^2"},
      {1.0 / 101325.0, "it seems to be in atm"},
      {1e-5, "it seems to be in bar"},
      {1.0 / problem.body.contact_modulus, "it seems to be relative to E*"},
      {1.0 / problem.loads[load], "it seems to be relative to the load"},
      {node_area, "it seems to be the force of each node [N]"},
      {1.0 / node_area, "it seems to be divided by the area of a node"},
      {1.0 / static_cast<double>(grid.size()),
       "it seems to be divided by the number of nodes"}};
  for (std::size_t other = 0; other < problem.loads.size(); ++other)
    if (other != load)
      known.push_back(
          {problem.loads[other] / problem.loads[load],
           fmt::format("it seems to be the answer at the load {:g} Pa",
                       problem.loads[other])});
  return known;
}

/// Names the factor between the mean pressure and the load.
std::string words_of_load(const Problem& problem, std::size_t load,
                          double ratio) {
  std::string found =
      fmt::format("the mean pressure is {:.6g} times the load", ratio);
  const auto near = [&](double factor) {
    return std::abs(std::abs(ratio) / factor - 1.0) < 1e-2;
  };
  if (near(1.0))
    return ratio < 0.0 ? found + ": compression must be positive"
                       : found + ", which differs by more than a thousandth";
  for (const LoadMistake& known : load_mistakes(problem, load))
    if (near(known.ratio))
      return fmt::format("{}: {}{}", found, known.text,
                         ratio < 0.0 ? ", and compression must be positive"
                                     : "");
  return found;
}

/// One of the eight symmetries of a square: axes exchanged, then rows and
/// columns reversed.
struct Orientation {
  bool is_transposed = false;
  bool has_reversed_rows = false;
  bool has_reversed_columns = false;

  std::string text() const {
    std::vector<std::string> words;
    if (is_transposed)
      words.emplace_back("transposed");
    if (has_reversed_rows)
      words.emplace_back("its rows in reverse order");
    if (has_reversed_columns)
      words.emplace_back("its columns in reverse order");
    return fmt::format("{}", fmt::join(words, ", "));
  }
};

Field oriented(const Field& field, const Grid& grid,
               const Orientation& orientation) {
  const auto rows = static_cast<std::size_t>(grid.points_y);
  const auto columns = static_cast<std::size_t>(grid.points_x);
  Field result(field.size());
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t row = orientation.has_reversed_rows ? rows - 1 - i : i;
      const std::size_t column =
          orientation.has_reversed_columns ? columns - 1 - j : j;
      result[i * columns + j] = orientation.is_transposed
                                    ? field[column * columns + row]
                                    : field[row * columns + column];
    }
  return result;
}

Field shifted(const Field& field, const Grid& grid, std::size_t rows_down,
              std::size_t columns_right) {
  const auto rows = static_cast<std::size_t>(grid.points_y);
  const auto columns = static_cast<std::size_t>(grid.points_x);
  Field result(field.size());
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j)
      result[(i + rows_down) % rows * columns + (j + columns_right) % columns] =
          field[i * columns + j];
  return result;
}

/// A field that may be the one that was meant.
struct Meant {
  double work = 0.0; ///< <h, p>: the larger, the smaller the potential
  Orientation orientation;
  std::size_t rows_down = 0;
  std::size_t columns_right = 0;
};

/// The shift by which a field does the most work on the heights. An isotropic
/// body stores the same energy in each, so it is the one of least potential.
Meant best_shift(const RealFourier& fourier,
                 const std::vector<std::complex<double>>& heights,
                 const Field& field) {
  std::vector<std::complex<double>> spectrum(heights.size());
  fourier.forward(field, spectrum);
  for (std::size_t i = 0; i < spectrum.size(); ++i)
    spectrum[i] = std::conj(spectrum[i]) * heights[i];
  Field work(field.size());
  fourier.backward(spectrum, work);
  const auto most =
      static_cast<std::size_t>(std::ranges::max_element(work) - work.begin());
  const auto columns = static_cast<std::size_t>(fourier.grid().points_x);
  return {work[most], {}, most / columns, most % columns};
}

/// The orientation and shift of least potential on the heights.
Meant best_orientation(const Problem& problem, const Field& heights,
                       const Field& field) {
  const Grid& grid = problem.grid;
  const RealFourier fourier(grid);
  std::vector<std::complex<double>> spectrum(grid.half_spectrum_size());
  fourier.forward(heights, spectrum);
  const bool is_square =
      grid.points_x == grid.points_y && grid.length_x == grid.length_y;
  std::optional<Meant> best;
  for (unsigned kind = 0; kind < (is_square ? 8U : 4U); ++kind) {
    const Orientation orientation{(kind & 4U) != 0, (kind & 2U) != 0,
                                  (kind & 1U) != 0};
    Meant meant =
        best_shift(fourier, spectrum, oriented(field, grid, orientation));
    meant.orientation = orientation;
    if (!best || meant.work > best->work * (1.0 + 1e-9))
      best = meant;
  }
  return *best;
}

/// A field is another one's answer if its duality gap is that much smaller.
constexpr double far_better = 0.1;

double gap_of(contact::SurfaceOperator& elasticity, const Field& heights,
              double load, const Field& field) {
  return contact::check_field(elasticity, {heights, 0.0, load, field})
      .duality_gap;
}

/// Names an orientation or shift that fits the heights far better.
std::optional<std::string>
words_of_orientation(contact::SurfaceOperator& elasticity,
                     const Problem& problem, double load, const Field& field) {
  const double as_submitted = gap_of(elasticity, problem.heights, load, field);
  Field valleys = problem.heights;
  for (double& height : valleys)
    height = -height;
  for (const bool is_inverted : {false, true}) {
    const Field& heights = is_inverted ? valleys : problem.heights;
    const Meant meant = best_orientation(problem, heights, field);
    const Field turned =
        shifted(oriented(field, problem.grid, meant.orientation), problem.grid,
                meant.rows_down, meant.columns_right);
    if (gap_of(elasticity, heights, load, turned) > far_better * as_submitted)
      continue;
    std::vector<std::string> words;
    if (is_inverted)
      words.emplace_back("the sign of the heights reversed (peaks must be "
                         "positive)");
    if (const std::string text = meant.orientation.text(); !text.empty())
      words.push_back(text);
    if (meant.rows_down + meant.columns_right > 0)
      words.push_back(fmt::format("shifted by {} rows and {} columns",
                                  meant.rows_down, meant.columns_right));
    return fmt::format("the field fits the heights far better with {}",
                       fmt::join(words, ", "));
  }
  return std::nullopt;
}

/// Recognises the answer with periodic instead of free boundaries, or the
/// reverse.
std::optional<std::string>
words_of_boundaries(contact::SurfaceOperator& elasticity,
                    const Problem& problem, double load, const Field& field) {
  const double as_submitted = gap_of(elasticity, problem.heights, load, field);
  // The other operator is not set up for answers that are nearly right.
  if (as_submitted < 1e-3 * load * problem.rms_height ||
      !problem.body.is_halfspace())
    return std::nullopt;
  Problem other;
  other.body = problem.body;
  other.body.border = problem.is_periodic() ? mechanics::Border::free
                                            : mechanics::Border::periodic;
  if (gap_of(*surface_operator(other, problem.grid), problem.heights, load,
             field) > far_better * as_submitted)
    return std::nullopt;
  return fmt::format("the field is that of {} boundaries, but those of this "
                     "problem are {}",
                     other.is_periodic() ? "periodic" : "free",
                     problem.is_periodic() ? "periodic" : "free");
}

/// Names another modulus or height unit: in the contact, h and C p then differ
/// by a constant only if one of them is scaled.
std::optional<std::string> words_of_scale(contact::SurfaceOperator& elasticity,
                                          const Problem& problem,
                                          const Field& field) {
  Field displacement(field.size());
  elasticity.displacement(field, displacement);
  Field h, w;
  for (std::size_t i = 0; i < field.size(); ++i)
    if (field[i] > 0.0) {
      h.push_back(problem.heights[i]);
      w.push_back(displacement[i]);
    }
  const double h_mean = mean(h);
  const double w_mean = mean(w);
  double hh = 0.0, hw = 0.0, ww = 0.0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    hh += (h[i] - h_mean) * (h[i] - h_mean);
    hw += (h[i] - h_mean) * (w[i] - w_mean);
    ww += (w[i] - w_mean) * (w[i] - w_mean);
  }
  const bool is_proportional = hw > 0.0 && hw * hw > 0.999 * hh * ww;
  const double scale = hw / ww; // of the modulus, or 1/scale of the heights
  if (!is_proportional || std::abs(scale - 1.0) < 0.05)
    return std::nullopt;
  const double nu = problem.body.poisson_ratio;
  std::string known;
  const auto near = [&](double factor) {
    return std::abs(scale / factor - 1.0) < 1e-2;
  };
  if (near(2.0) || near(0.5))
    known = ": has the compliance of one or of two bodies been taken?";
  else if (nu != 0.0 && (near(1.0 - nu * nu) || near(1.0 / (1.0 - nu * nu))))
    known = ": E* = E/(1 - nu^2) is not E";
  else if (near(1e3) || near(1e6) || near(1e9) || near(1e-3) || near(1e-6) ||
           near(1e-9))
    known = ": is it a matter of units?";
  return fmt::format("the field is that of a modulus {:.4g} times E*, or of "
                     "heights {:.4g} times as large{}",
                     1.0 / scale, scale, known);
}

} // namespace

void require_grid(const Problem& problem, const SubmittedLoad& load) {
  const auto rows = static_cast<std::size_t>(problem.grid.points_y);
  const auto columns = static_cast<std::size_t>(problem.grid.points_x);
  if (load.rows == rows && load.columns == columns)
    return;
  std::string known;
  if (load.rows == columns && load.columns == rows)
    known = ": it is transposed; rows go along y";
  else if (load.rows == rows + 1 && load.columns == columns + 1)
    known = ": leave out the periodic end points";
  else if (load.rows * load.columns == rows * columns)
    known = ": it must not be flattened or reshaped";
  throw input::InputError(fmt::format(
      "{}: has {} rows and {} columns, but the problem has {} and {}{}",
      load.file.string(), load.rows, load.columns, rows, columns, known));
}

std::vector<std::string>
recognised_mistakes(contact::SurfaceOperator& elasticity,
                    const Problem& problem, const SubmittedLoad& load) {
  const double nominal = problem.loads.at(load.load);
  const double mean_pressure = mean(load.pressure);
  if (mean_pressure == 0.0)
    return {"the mean pressure is 0"};
  std::vector<std::string> found;
  const double ratio = mean_pressure / nominal;
  if (!(std::abs(ratio - 1.0) <= 1e-3))
    found.push_back(words_of_load(problem, load.load, ratio));
  // Whatever the factor is, the shape of the field tells the rest.
  Field field = load.pressure;
  for (double& value : field)
    value /= ratio;
  const double tension =
      std::max(0.0, -*std::ranges::min_element(field)) / nominal;
  if (tension > 1e-3)
    found.push_back(fmt::format(
        "the largest tension is {:.3g} times the load, but p must be >= 0",
        tension));
  if (auto other = words_of_boundaries(elasticity, problem, nominal, field))
    found.push_back(*other);
  else if (auto words =
               words_of_orientation(elasticity, problem, nominal, field))
    found.push_back(*words);
  else if (auto scaled = words_of_scale(elasticity, problem, field))
    found.push_back(*scaled);
  return found;
}

} // namespace asperity::exchange
