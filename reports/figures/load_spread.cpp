#include "reports/figures/load_spread.hpp"

#include "reports/figures/plot_parts.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::reports {

namespace {

constexpr int upright_cross = 1, diagonal_cross = 2; ///< gnuplot's numbers

} // namespace

int LoadSpread::zeros() const {
  return static_cast<int>(std::ranges::count(numbers, 0.0));
}

SpreadCurve converged_spread(const results::MethodRecord& method,
                             const results::CurveColumn& column) {
  return spread_curve(method, [&](const results::CurvePoint& row, std::size_t) {
    return row.status == results::StepStatus::converged &&
                   std::isfinite(row[column])
               ? row[column]
               : std::numeric_limits<double>::quiet_NaN();
  });
}

SpreadPanel::SpreadPanel(const std::string& quantity, double unit,
                         std::string zero)
    : unit_(unit), quantity_(quantity), zero_(std::move(zero)) {}

void SpreadPanel::add_rows(const std::string& label, const SpreadCurve& curve,
                           bool is_zero) {
  for (const auto& [step, at] : curve)
    if (is_zero ? at.zeros() > 0 : at.median() > 0.0) {
      rows_.push_back({label, next_, at, is_zero});
      for (const double number : at.numbers)
        if (number > 0.0)
          least_ = std::min(least_, number / unit_);
    }
}

void SpreadPanel::add(const std::string& label, const CurveStyle& style,
                      const SpreadCurve& curve) {
  const std::size_t before = rows_.size();
  add_rows(label, curve, false);
  if (style.has_markers)
    for (const auto& [step, at] : curve)
      for (const double number : at.numbers)
        if (number > 0.0)
          least_marked_ = std::min(least_marked_, number / unit_);
  if (rows_.size() > before) {
    ChartCurve& drawn = panel_.add(label, style, next_++, 3, 4);
    if (style.has_markers) {
      drawn.low = 5;
      drawn.high = 6;
    }
  }
  if (!style.has_markers)
    return;
  const std::size_t drawn = rows_.size();
  add_rows(label + ", " + zero_, curve, true);
  if (rows_.size() > drawn) {
    const bool is_open = style.marker % 2 == 0;
    ChartCurve& zeros =
        panel_.add(label + ", " + zero_,
                   markers(style.color,
                           is_open ? upright_cross : diagonal_cross, 1.0, 1.3),
                   next_++, 3, 4);
    zeros.low = 5;
    zeros.high = 6;
  }
}

void SpreadPanel::move_to(Figure& figure, const std::string& label) {
  constexpr double below = 0.3; // of the least number: half a decade
  const bool has_numbers = least_ < std::numeric_limits<double>::infinity();
  const bool has_marked =
      least_marked_ < std::numeric_limits<double>::infinity();
  const double axis =
      has_numbers ? rounded(below * (has_marked ? least_marked_ : least_), 1)
                  : 0.0;
  CsvTable table({"curve", "index", "p [MPa]", quantity_, "least " + quantity_,
                  "largest " + quantity_, "realisations [1]", zero_ + " [1]"});
  bool has_zeros = false;
  for (const Row& row : rows_) {
    const auto [low, high] = std::ranges::minmax(row.at.numbers);
    has_zeros = has_zeros || low == 0.0;
    const auto place = [&](double number) {
      return number > 0.0 ? number / unit_ : axis;
    };
    const double middle = row.is_zero ? axis : place(row.at.median());
    table.add(row.label,
              {static_cast<double>(row.index), row.at.pressure * 1e-6, middle,
               place(low), place(high),
               static_cast<double>(row.at.numbers.size()),
               static_cast<double>(row.at.zeros())});
  }
  panel_.x = {.label = "nominal pressure  [MPa]", .is_log = true};
  panel_.y = {.label = label, .is_log = has_numbers, .has_powers = has_numbers};
  if (has_zeros || least_ < axis) // a theory may fall by many decades
    panel_.y.low = axis;
  figure.panels = {std::move(panel_)};
  figure.data = table.text();
}

} // namespace asperity::reports
