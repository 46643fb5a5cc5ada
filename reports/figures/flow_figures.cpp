#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace asperity::reports {
namespace {

using results::CurvePoint;

/// Flows at one load over the realisations and both directions. Their mean is
/// the geometric one.
struct FlowSpread {
  double pressure = 0.0; ///< nominal [Pa], of the first realisation
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  double sum_of_logarithms = 0.0;
  int count = 0;
  int sealed = 0;

  void add(double flow) {
    if (flow == 0.0)
      ++sealed;
    if (!(flow > 0.0))
      return;
    low = std::min(low, flow);
    high = std::max(high, flow);
    sum_of_logarithms += std::log(flow);
    ++count;
  }

  double mean() const { return std::exp(sum_of_logarithms / count); }
};

/// By the number of the load step.
using FlowCurve = std::map<int, FlowSpread>;

/// @param flows  of a row [m^3/s], one or several
template <class Flows>
FlowCurve flow_curve(const results::MethodRecord& method, const Flows& flows) {
  FlowCurve curve;
  for (const results::Curve& realization : method.realizations)
    for (const CurvePoint& row : realization.points)
      if (row.nominal_pressure > 0.0 && !row.is_unloading) {
        FlowSpread& at = curve[row.step];
        at.pressure = at.pressure > 0.0 ? at.pressure : row.nominal_pressure;
        for (const double flow : flows(row))
          at.add(flow);
      }
  std::erase_if(curve, [](const auto& at) {
    return at.second.count + at.second.sealed == 0;
  });
  return curve;
}

class FlowFigure {
public:
  explicit FlowFigure(const cases::FlowStudy& study)
      : rate_(study.pressure_drop / (12.0 * study.viscosity) * study.aspect()) {
  }

  void add_theory(const results::MethodRecord& method) {
    add(method.name + ", effective medium", line("#222222", 1.6),
        flow_curve(method, [](const CurvePoint& row) {
          return std::array{row.leak_rate_x};
        }));
    add(method.name + ", critical junction", line("#222222", 1.2, 2),
        flow_curve(method, [&](const CurvePoint& row) {
          return std::array{rate_ * std::pow(row.critical_gap_x, 3.0)};
        }));
  }

  void add_numbers(const results::MethodRecord& method, std::size_t color) {
    Series as_series;
    as_series.kind = method.kind;
    as_series.color = color;
    const FlowCurve leaks = flow_curve(method, [](const CurvePoint& row) {
      return std::array{row.leak_rate_x, row.leak_rate_y};
    });
    add(method.name + ", Reynolds", point_style(as_series), leaks);
    add(method.name + ", effective medium of its gaps",
        line(series_color(as_series), 1.0, 3),
        flow_curve(method, [&](const CurvePoint& row) {
          return std::array{rate_ * row.effective_medium};
        }));
    for (const auto& [step, at] : leaks) {
      sealed_ += at.sealed;
      all_ += at.sealed + at.count;
    }
  }

  bool is_empty() const { return panel_.curves.empty(); }

  Figure take() && {
    Figure figure;
    figure.name = "leak-rate";
    figure.title = "Leak rate against load";
    figure.caption =
        "Flow through the seal of the case. Markers: Reynolds' equation on "
        "the gap, the geometric mean over realisations and both "
        "directions; bars span their range. Effective medium: Bruggeman, with "
        "the distribution of the gaps of the method or of Eq. (27) of Yang and "
        "Persson (2008). Critical junction: their Sec. 8.";
    if (sealed_ > 0)
      figure.caption += fmt::format(
          " {} of {} maps are sealed: no path joins the sides. They are not in "
          "the means.",
          sealed_, all_);
    panel_.x = {.label = "nominal pressure  [MPa]", .is_log = true};
    panel_.y = {
        .label = "leak rate  [m^3/s]", .is_log = true, .has_powers = true};
    figure.panels = {std::move(panel_)};
    figure.data = table_.text();
    return figure;
  }

private:
  void add(const std::string& label, CurveStyle style, const FlowCurve& flows) {
    const bool has_spread = style.has_markers;
    std::size_t rows = 0;
    for (const auto& [step, at] : flows) {
      if (at.count == 0)
        continue;
      table_.add(label,
                 {static_cast<double>(next_), at.pressure * 1e-6, at.mean(),
                  at.low, at.high, static_cast<double>(at.sealed)});
      ++rows;
    }
    if (rows == 0)
      return;
    ChartCurve& curve = panel_.add(label, std::move(style), next_++, 3, 4);
    if (has_spread) {
      curve.low = 5;
      curve.high = 6;
    }
  }

  double rate_; ///< leak rate over the conductance of a square [1/s]
  std::size_t next_ = 0;
  int sealed_ = 0, all_ = 0;
  CsvTable table_{{"curve", "index", "p [MPa]", "leak rate [m^3/s]",
                   "least leak rate [m^3/s]", "largest leak rate [m^3/s]",
                   "sealed maps [1]"}};
  ChartPanel panel_;
};

constexpr double least_flux = 1e-3; // drawn, over the mean

/// A map of log10 |q|/(Q/W).
std::optional<Figure> flux_figure(const std::string& method,
                                  const results::Table& flow) {
  const std::vector<double> x = flow.values("x"), y = flow.values("y"),
                            flux = flow.values("flux"),
                            critical = flow.values("is_critical");
  if (flux.empty() || x.size() != flux.size() || y.size() != flux.size() ||
      critical.size() != flux.size())
    return std::nullopt;
  Figure figure;
  figure.name = "flux-" + file_word(method);
  figure.title = "Flux through the gap, " + method;
  figure.width = 480;
  figure.height = 440;
  CsvTable table({"map", "x [um]", "y [um]", "log10 |q|/(Q/W) [1]"});
  ChartImage image{.x = 2,
                   .y = 3,
                   .value = 4,
                   .colors = "pressure",
                   .low = std::log10(least_flux),
                   .label = "log_{10} |q| / (Q/W)",
                   .proportions = Proportions::equal_scales};
  for (std::size_t i = 0; i < flux.size(); ++i) {
    table.add(method, {x[i] * 1e6, y[i] * 1e6,
                       std::log10(std::max(flux[i], least_flux))});
    if (critical[i] > 0.0)
      image.notes.push_back({{x[i] * 1e6, y[i] * 1e6}, "\u2715"});
  }
  figure.caption = flow.title +
                   ", at the cross. The colour is the flow per width |q| over "
                   "its mean Q/W, light where less than 1/1000 of it flows: "
                   "the heaviest saved map that is not sealed.";
  figure.panels = {{.x = {.label = "x [µm]",
                          .low = rounded(x.front() * 1e6, 6),
                          .high = rounded(x.back() * 1e6, 6)},
                    .y = {.label = "y [µm]",
                          .low = rounded(y.front() * 1e6, 6),
                          .high = rounded(y.back() * 1e6, 6)},
                    .image = std::move(image)}};
  figure.data = table.text();
  return figure;
}

} // namespace

std::optional<Figure> flow_figure(const ReportEntry& entry) {
  if (!entry.contact_case->flow_study)
    return std::nullopt;
  FlowFigure figure(*entry.contact_case->flow_study);
  std::size_t color = 0;
  for (const results::MethodRecord& method : entry.result->methods) {
    if (method.kind == "theory")
      figure.add_theory(method);
    else
      figure.add_numbers(method, color++);
  }
  if (figure.is_empty())
    return std::nullopt;
  return std::move(figure).take();
}

std::vector<Figure> flux_figures(const ReportEntry& entry) {
  std::vector<Figure> figures;
  for (const results::MethodRecord& method : entry.result->methods)
    if (const results::Table* table =
            entry.result->table("flow-" + method.name))
      if (std::optional<Figure> figure = flux_figure(method.name, *table))
        figures.push_back(std::move(*figure));
  return figures;
}

} // namespace asperity::reports
