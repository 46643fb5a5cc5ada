// The figures, the answer and the text of [flow].
#include "base/shown_number.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/load_spread.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/pages/answers.hpp"
#include "studies/answers.hpp"
#include "studies/flow/flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace asperity::studies {

using namespace reports;

namespace {

using results::CurvePoint;

class FlowFigure {
public:
  explicit FlowFigure(const FlowStudy& study)
      : rate_(study.pressure_drop / (12.0 * study.viscosity) * study.aspect()) {
  }

  void add_theory(const results::MethodRecord& method) {
    panel_.add(method.name + ", effective medium", line("#222222", 1.6),
               spread_curve(method, [](const CurvePoint& row, std::size_t) {
                 return row[columns::leak_rate.x];
               }));
    panel_.add(method.name + ", critical junction", line("#222222", 1.2, 2),
               spread_curve(method, [&](const CurvePoint& row, std::size_t) {
                 return rate_ * std::pow(row[columns::critical_gap.x], 3.0);
               }));
  }

  void add_numbers(const results::MethodRecord& method, std::size_t color) {
    Series as_series;
    as_series.kind = method.kind;
    as_series.color = color;
    CurveStyle style = point_style(as_series);
    for (const auto& [direction, rate] :
         {std::pair("x", &columns::leak_rate.x),
          std::pair("y", &columns::leak_rate.y)}) {
      const SpreadCurve leaks = spread_curve(
          method, [rate = rate](const CurvePoint& row, std::size_t) {
            return row[*rate];
          });
      panel_.add(fmt::format("{}, Reynolds, along {}", method.name, direction),
                 style, leaks);
      count_sealed(method.name, direction, leaks);
      style.marker -= 1; // open
    }
    panel_.add(method.name + ", effective medium of its gaps",
               line(series_color(as_series), 1.0, 3),
               spread_curve(method, [&](const CurvePoint& row, std::size_t) {
                 return rate_ * row[columns::effective_medium];
               }));
  }

  bool is_empty() const { return panel_.is_empty(); }

  Figure take() && {
    Figure figure;
    figure.name = "leak-rate";
    figure.title = "Leak rate against load";
    figure.caption =
        "Flow through the seal of the case, of each direction. Markers: "
        "Reynolds' equation on the gap, the median over realisations; bars "
        "span their range. Effective medium: Bruggeman, with the distribution "
        "of the gaps of the method or of Eq. (27) of Yang and Persson (2008). "
        "Critical junction: their Sec. 8.";
    if (!sealed_.empty())
      figure.caption += fmt::format(
          " Crosses at the axis: loads at which contacts are sealed, so that "
          "no path joins the sides and the leak rate is 0, as the median "
          "counts them: {}.",
          fmt::join(sealed_, "; "));
    panel_.move_to(figure, "leak rate  [m^3/s]");
    return figure;
  }

private:
  void count_sealed(const std::string& method, const std::string& direction,
                    const SpreadCurve& leaks) {
    int sealed = 0;
    std::size_t all = 0;
    for (const auto& [step, at] : leaks) {
      sealed += at.zeros();
      all += at.numbers.size();
    }
    if (sealed > 0)
      sealed_.push_back(fmt::format("{} of {} of {} along {}", sealed, all,
                                    method, direction));
  }

  double rate_; ///< leak rate over the conductance of a square [1/s]
  std::vector<std::string> sealed_;
  SpreadPanel panel_{"leak rate [m^3/s]", 1.0, "sealed"};
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

std::vector<Figure> flow_figures(const ReportEntry& entry) {
  std::vector<Figure> figures;
  if (const auto* const study = entry.contact_case->study<FlowStudy>())
    if (auto leaks =
            figure_of_methods(FlowFigure(*study), entry.result->methods))
      figures.push_back(std::move(*leaks));
  for (const results::MethodRecord& method : entry.result->methods)
    if (const results::Table* table =
            entry.result->table("flow-" + method.name))
      if (std::optional<Figure> figure = flux_figure(method.name, *table))
        figures.push_back(std::move(*figure));
  return figures;
}

std::string flow_text(const cases::Case& contact_case) {
  const auto* const study = contact_case.study<FlowStudy>();
  if (study == nullptr)
    return "";
  return fmt::format(
      " The flow of a fluid with the viscosity {:g} Pa s under a pressure "
      "drop of {:g} Pa through the gap was computed by Reynolds' equation "
      "with finite volumes, for a seal {:g} times as wide as long.",
      study->viscosity, study->pressure_drop, study->aspect());
}

/// "water at 100 kPa", or by its viscosity.
std::string fluid_words(const FlowStudy& study) {
  std::string name =
      fmt::format("a fluid of {} mPa s", digits_text(1e3 * study.viscosity, 3));
  for (const auto& [fluid, viscosity] : named_fluids)
    if (std::abs(study.viscosity / viscosity - 1.0) < 1e-6)
      name = fluid;
  return name + " at " + quantity_text(study.pressure_drop, "Pa", 3);
}

std::vector<AnswerColumn> leak_columns(const cases::Case& contact_case) {
  const auto* const study = contact_case.study<FlowStudy>();
  if (study == nullptr)
    return {};
  const std::string words = "Leak rate of " + fluid_words(*study);
  return {{&columns::leak_rate.x, words + " along x", "tight"},
          {&columns::leak_rate.y, words + " along y", "tight"}};
}

/// "5e-14 m³/s along y at 1 MPa" of the heaviest load, or "tight along x from
/// 15 kPa on (2e-16 m³/s at 10 kPa)" with the heaviest load that leaks. Of
/// several realisations these are medians, in which tight ones count as 0.
std::string flow_along(const char* direction, const SpreadCurve& leaks) {
  const LoadSpread *leaking = nullptr, *tight = nullptr;
  for (const auto& [step, at] : leaks) {
    const bool does_leak = at.median() > 0.0;
    const LoadSpread*& found = does_leak ? leaking : tight;
    if (found == nullptr || (at.pressure > found->pressure) == does_leak)
      found = &at;
  }
  const auto load = [](const LoadSpread& at) {
    return quantity_text(at.pressure, "Pa", 3);
  };
  const auto rate = [](const LoadSpread& at) {
    return quantity_text(at.median(), "m^3/s", 3);
  };
  const auto count = [](const LoadSpread& at) -> std::string {
    const std::size_t all = at.numbers.size();
    return all == 1 ? ""
           : at.zeros() > 0
               ? fmt::format(", {} of {} realisations tight", at.zeros(), all)
               : fmt::format(", median of {} realisations", all);
  };
  if (tight == nullptr)
    return fmt::format("{} along {} at {}{}", rate(*leaking), direction,
                       load(*leaking), count(*leaking));
  std::string words = fmt::format("tight along {} from {} on{}", direction,
                                  load(*tight), count(*tight));
  if (leaking != nullptr)
    words += fmt::format(" ({} at {}{})", rate(*leaking), load(*leaking),
                         count(*leaking));
  return words;
}

/// The answer of the method of answered_load().
std::string flow_answer(const ReportEntry& entry) {
  const auto* const study = entry.contact_case->study<FlowStudy>();
  const results::MethodRecord* const method =
      answered_load(entry, columns::leak_rate.x).method;
  if (study == nullptr || method == nullptr)
    return "";
  std::string fluid = fluid_words(*study);
  fluid.front() = static_cast<char>(std::toupper(fluid.front()));
  const SpreadCurve along_x = converged_spread(*method, columns::leak_rate.x);
  const SpreadCurve along_y = converged_spread(*method, columns::leak_rate.y);
  std::string words = flow_along("x and y", along_x);
  if (words != flow_along("x and y", along_y))
    words = flow_along("x", along_x) + ", " + flow_along("y", along_y);
  return fmt::format("{}: {}{}.", fluid, words,
                     method_in_words(entry, *method));
}

/// Mean over both directions of log10 of a number; minus infinity if one of
/// them is sealed.
double mean_log10(const CurvePoint& row, const columns::DirectedColumn& flow) {
  return 0.5 * (std::log10(row[flow.x]) + std::log10(row[flow.y]));
}

std::vector<NumberAtLoad> numbers_of_flow() {
  constexpr const char* sealed =
      "{} of {} realisations are sealed at p/E* = {:.4g} in a direction, where "
      "the leak rate is 0 and has no logarithm";
  return {
      {{.name = "log10_flow_factor",
        .description = "log10 of the flow factor, the mean of both "
                       "directions; needs [flow] and a step at this load [1].",
        .theory_answers = true,
        .of = cases::QuantityOf::load},
       [](const StepAtLoad& step) {
         return mean_log10(step.row, columns::flow_factor);
       },
       sealed},
      {{.name = "leak_departure",
        .description = "log10 of the leak rate over that of theory, the mean "
                       "of both directions; needs [flow] and a step at this "
                       "load [1].",
        .needs_theory = true,
        .of = cases::QuantityOf::load},
       [](const StepAtLoad& step) {
         return mean_log10(step.row, columns::leak_rate) -
                mean_log10(*step.theory, columns::leak_rate);
       },
       sealed}};
}

} // namespace

const StudyPages& flow_pages() {
  static const StudyPages pages{.name = "flow",
                                .figure_names = {"flux-", "leak-rate"},
                                .figures = drawn_by<flow_figures>,
                                .answer = flow_answer,
                                .answer_columns = leak_columns,
                                .methods_text = flow_text,
                                .at_load = numbers_of_flow()};
  return pages;
}

} // namespace asperity::studies
