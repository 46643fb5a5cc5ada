// The loading curves of all points of a sweep in one figure per method.
#include "reports/figures/plot_parts.hpp"
#include "reports/sweeps/sweep_axis.hpp"
#include "reports/sweeps/sweep_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

/// Which observable a figure shows against which.
enum class CurveKind { pressure_gap, area_pressure };

/// A point of a curve in the coordinates of the figure, with the half-width of
/// the 95 % interval of the observable; NaN: there is none.
struct CurveRow {
  double x = 0.0;
  double y = 0.0;
  double half_width = not_a_number;
};

CurveRow row_of(const SeriesRow& row, CurveKind kind) {
  return kind == CurveKind::pressure_gap
             ? CurveRow{row.gap, row.pressure, row.gap_interval}
             : CurveRow{row.pressure, row.area_corrected, row.area_interval};
}

/// Assembles the curves of one method.
class CurveFigure {
public:
  CurveFigure(const SweepRecord& record, const std::string& method,
              CurveKind kind)
      : record_(record), kind_(kind), method_(method) {
    const bool is_gap = kind == CurveKind::pressure_gap;
    figure_.name =
        fmt::format("sweep-{}-{}", is_gap ? "pressure-gap" : "area-pressure",
                    file_word(method));
    figure_.title = fmt::format("{}: {}",
                                is_gap ? "Pressure against separation"
                                       : "Contact area against pressure",
                                method);
    for (const cases::SweptKey& key : record.keys)
      axes_.push_back(axis_of(key));
  }

  void add(const SweptResult& result, const Series& series) {
    if (series.rows.empty())
      return;
    const std::size_t index = n_curves_++;
    for (const SeriesRow& one : series.rows) {
      const CurveRow row = row_of(one, kind_);
      table_.add(record_.label(result.point),
                 {static_cast<double>(index), row.x, row.y, row.half_width});
    }
    const std::vector<std::size_t>& choice =
        record_.points[result.point].choice;
    if (kind_ == CurveKind::pressure_gap)
      add_gap_band(panel_, series.rows, color(choice));
    else
      add_area_band(panel_, series.rows, color(choice));
    panel_.add(key_entry(choice), line(color(choice), 1.4, dash(choice)), index,
               3, 4);
  }

  bool is_empty() const { return n_curves_ == 0; }

  Figure take() && {
    const bool is_gap = kind_ == CurveKind::pressure_gap;
    figure_.data = table_.text();
    figure_.caption = caption();
    panel_.x.label = is_gap ? "mean separation u / h_{rms}" : "p / E*";
    panel_.y.label = is_gap ? "p / E*" : "A / A_0";
    panel_.y.is_log = panel_.y.has_powers = true;
    panel_.x.is_log = panel_.x.has_powers = !is_gap;
    panel_.has_narrow_legend = true;
    figure_.panels = {std::move(panel_)};
    return std::move(figure_);
  }

private:
  std::string color(const std::vector<std::size_t>& choice) const {
    return scale_color(choice[0], axes_[0].labels.size());
  }

  /// The second key of a zip has one value per value of the first, and no dash
  /// type of its own.
  int dash(const std::vector<std::size_t>& choice) const {
    return has_dashes() ? 1 + static_cast<int>(choice[1] % 5) : 1;
  }

  bool has_dashes() const {
    return axes_.size() > 1 && record_.combine == cases::Combine::product;
  }

  /// The legend has one entry per value of the first swept key, at most ten,
  /// and one per value of the second; others are empty.
  std::string key_entry(const std::vector<std::size_t>& choice) {
    const std::size_t n = axes_[0].labels.size();
    const std::size_t stride = (n + 9) / 10;
    std::string title;
    if (choice[0] % stride == 0 &&
        !std::exchange(colors_shown_[choice[0]], true))
      title = axes_[0].labels[choice[0]];
    if (has_dashes() && !std::exchange(dashes_shown_[choice[1]], true))
      title += (title.empty() ? "" : ", ") + axes_[1].labels[choice[1]];
    return title;
  }

  std::string caption() const {
    std::string words = fmt::format(
        "One line per point; the colour is the value of {}, from "
        "{} (dark) to {}",
        record_.keys[0].key, axes_[0].labels.front(), axes_[0].labels.back());
    if (has_dashes())
      words += fmt::format(", the dash type that of {}", record_.keys[1].key);
    for (std::size_t k = has_dashes() ? 2 : 1; k < axes_.size(); ++k)
      words += fmt::format("; {} also varies", record_.keys[k].key);
    words += !panel_.bands.empty()
                 ? ". Bands: 95 % interval of the mean over the "
                   "realisations."
                 : ". There are no bands, because each point has one "
                   "realisation.";
    return words;
  }

  const SweepRecord& record_;
  CurveKind kind_;
  std::string method_;
  std::vector<FigureAxis> axes_;
  Figure figure_;
  CsvTable table_{{"curve", "index", "x", "y", "half-width of 95 % interval"}};
  ChartPanel panel_;
  std::map<std::size_t, bool> colors_shown_;
  std::map<std::size_t, bool> dashes_shown_;
  std::size_t n_curves_ = 0;
};

} // namespace

std::vector<Figure> sweep_curve_figures(const SweepRecord& record,
                                        const SweptResults& results) {
  std::vector<Figure> figures;
  for (const CurveKind kind :
       {CurveKind::pressure_gap, CurveKind::area_pressure})
    for (const std::string& method : swept_methods(results)) {
      CurveFigure figure(record, method, kind);
      for (const auto& result : results)
        for (const Series& series : result->series)
          if (series.label == method)
            figure.add(*result, series);
      if (!figure.is_empty())
        figures.push_back(std::move(figure).take());
    }
  return figures;
}

} // namespace asperity::reports
