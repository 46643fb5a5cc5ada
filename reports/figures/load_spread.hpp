#pragma once

// Numbers of a load step that spread over realisations, as curves of one panel:
// their geometric mean and range against the nominal pressure.

#include "reports/figures/gnuplot.hpp"
#include "results/types/result.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace asperity::reports {

/// Numbers at one load over the realisations. Their mean is the geometric one.
struct LoadSpread {
  double pressure = 0.0; ///< nominal [Pa], of the first realisation
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  double sum_of_logarithms = 0.0;
  int count = 0;
  int zeros = 0; ///< not in the mean

  void add(double number) {
    if (number == 0.0)
      ++zeros;
    if (!(number > 0.0))
      return;
    low = std::fmin(low, number);
    high = std::fmax(high, number);
    sum_of_logarithms += std::log(number);
    ++count;
  }

  double mean() const { return std::exp(sum_of_logarithms / count); }
};

/// By the number of the load step.
using SpreadCurve = std::map<int, LoadSpread>;

/// The rows of the loading branch.
/// @param numbers  of a row and its realisation, one or several
template <class Numbers>
SpreadCurve spread_curve(const results::MethodRecord& method,
                         const Numbers& numbers) {
  SpreadCurve curve;
  for (std::size_t r = 0; r < method.realizations.size(); ++r)
    for (const results::CurvePoint& row : method.realizations[r].points)
      if (row.nominal_pressure > 0.0 && !row.is_unloading) {
        LoadSpread& at = curve[row.step];
        at.pressure = at.pressure > 0.0 ? at.pressure : row.nominal_pressure;
        for (const double number : numbers(row, r))
          at.add(number);
      }
  std::erase_if(curve, [](const auto& at) {
    return at.second.count + at.second.zeros == 0;
  });
  return curve;
}

/// A panel of such curves against the pressure in MPa, and its table.
class SpreadPanel {
public:
  /// @param quantity  of the header, "leak rate [m^3/s]"
  /// @param unit      by which the numbers are divided
  /// @param zeros     header of the column of zeros; empty: without it
  SpreadPanel(const std::string& quantity, double unit,
              const std::string& zeros = "");

  /// Adds a curve, with bars over its range if it has markers.
  void add(const std::string& label, CurveStyle style,
           const SpreadCurve& curve);

  bool is_empty() const { return panel_.curves.empty(); }

  /// Moves panel and table into a figure.
  /// @param label  of the vertical axis
  void move_to(Figure& figure, const std::string& label);

private:
  double unit_;
  bool has_zeros_;
  std::size_t next_ = 0;
  CsvTable table_;
  ChartPanel panel_;
};

/// Returns the figure of all methods, or nothing if it is empty.
/// @param figure  with add_theory(method), add_numbers(method, index of its
///                colour), is_empty() and take()
template <class MethodsFigure>
std::optional<Figure>
figure_of_methods(MethodsFigure figure,
                  std::span<const results::MethodRecord> methods) {
  std::size_t color = 0;
  for (const results::MethodRecord& method : methods) {
    if (method.kind == "theory")
      figure.add_theory(method);
    else
      figure.add_numbers(method, color++);
  }
  if (figure.is_empty())
    return std::nullopt;
  return std::move(figure).take();
}

} // namespace asperity::reports
