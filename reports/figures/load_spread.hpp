#pragma once

// Numbers of a load step that spread over realisations, as curves of one panel:
// their median and range against the nominal pressure. Zeros count: a sealed
// realisation leaks nothing, and the others alone would leak too much.

#include "reports/figures/gnuplot.hpp"
#include "reports/numbers/estimate.hpp"
#include "results/types/curve_columns.hpp"
#include "results/types/result.hpp"

#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asperity::reports {

/// Numbers at one load over the realisations.
struct LoadSpread {
  double pressure = 0.0;       ///< nominal [Pa], of the first realisation
  std::vector<double> numbers; ///< >= 0
  bool is_complete = true;     ///< whether each realisation has a number

  void add(double number) {
    if (number >= 0.0)
      numbers.push_back(number);
    else
      is_complete = false;
  }

  int zeros() const;

  /// Of all numbers, of which zeros are the smallest.
  double median() const { return reports::median(numbers); }
};

/// By the number of the load step.
using SpreadCurve = std::map<int, LoadSpread>;

/// The rows of the loading branch, of the loads at which every realisation that
/// has a row has a number: those that failed are not left out of a median.
/// @param number  of a row and its realisation; NaN: none
template <class Number>
SpreadCurve spread_curve(const results::MethodRecord& method,
                         const Number& number) {
  SpreadCurve curve;
  for (std::size_t r = 0; r < method.realizations.size(); ++r)
    for (const results::CurvePoint& row : method.realizations[r].points)
      if (row.nominal_pressure > 0.0 && !row.is_unloading) {
        LoadSpread& at = curve[row.step];
        at.pressure = at.pressure > 0.0 ? at.pressure : row.nominal_pressure;
        at.add(number(row, r));
      }
  std::erase_if(curve, [](const auto& at) { return !at.second.is_complete; });
  return curve;
}

/// The finite numbers of a column in converged rows.
SpreadCurve converged_spread(const results::MethodRecord& method,
                             const results::CurveColumn& column);

/// A panel of such curves against the pressure in MPa, and its table.
class SpreadPanel {
public:
  /// @param quantity  of the header, "leak rate [m^3/s]"
  /// @param unit      by which the numbers are divided
  /// @param zero      what a realisation with the number 0 is: "sealed"
  SpreadPanel(const std::string& quantity, double unit, std::string zero);

  /// Adds a curve, with bars over its range if it has markers. Loads at which
  /// realisations of a curve with markers have the number 0 get a cross at the
  /// bottom axis, as a curve of its own.
  void add(const std::string& label, const CurveStyle& style,
           const SpreadCurve& curve);

  bool is_empty() const { return panel_.curves.empty(); }

  /// Moves panel and table into a figure.
  /// @param label  of the vertical axis
  void move_to(Figure& figure, const std::string& label);

private:
  /// A row of the table, without the numbers of a curve of zeros, which are at
  /// the axis, whose place depends on all curves.
  struct Row {
    std::string label;
    std::size_t index = 0;
    LoadSpread at;
    bool is_zero = false;
  };

  void add_rows(const std::string& label, const SpreadCurve& curve,
                bool is_zero);

  double unit_;
  std::string quantity_, zero_;
  std::size_t next_ = 0;
  double least_ = std::numeric_limits<double>::infinity(); ///< > 0, over unit_
  double least_marked_ =
      std::numeric_limits<double>::infinity(); ///< likewise, of markers
  std::vector<Row> rows_;
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
