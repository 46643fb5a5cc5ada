// The figures, the text and the quantities of [magnification].
#include "base/shown_number.hpp"
#include "input/types/quantity_at_load.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"
#include "results/observables/distributions.hpp"
#include "results/types/result.hpp"
#include "studies/magnification/magnification.hpp"
#include "studies/theory_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numeric>
#include <vector>

namespace asperity::studies {

using namespace reports;

namespace {

/// One load of the study.
struct MagnifiedLoad {
  std::size_t index = 0;
  double pressure = 0.0;                ///< [Pa]
  double contact_weight = 0.0;          ///< A(zeta_1)/A_0 [1]
  const results::Table* seen = nullptr; ///< one row per zeta
  const results::Table* gaps = nullptr; ///< quantiles of u_1
};

/// A magnification study in the form that its figures need.
struct MagnifiedStudy {
  double rms_height = 0.0;          ///< with all of the roughness [m]
  std::vector<MagnifiedLoad> loads; ///< loads whose tables are present
};

// Checks that the table has all the columns and that they have equal length.
bool has_columns(const results::Table* table,
                 std::initializer_list<const char*> names) {
  if (table == nullptr)
    return false;
  const std::size_t rows = table->values(*names.begin()).size();
  return rows > 0 &&
         std::all_of(names.begin(), names.end(), [&](const char* name) {
           return table->values(name).size() == rows;
         });
}

/// Returns the available part of the study; no loads if the study was not run.
MagnifiedStudy study_of(const results::Result& result) {
  MagnifiedStudy study;
  const results::Table* loads = result.table("magnification");
  if (loads == nullptr)
    return study;
  const std::vector<double> pressures = loads->values("nominal_pressure");
  const std::vector<double> weights = loads->values("contact_weight");
  const std::vector<double> heights = loads->values("rms_height");
  if (heights.empty() || weights.size() < pressures.size())
    return study;
  study.rms_height = heights.front();
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const MagnifiedLoad load{
        i, pressures[i], weights[i],
        result.table(fmt::format("magnification-{}", i + 1)),
        result.table(fmt::format("gap-distribution-{}", i + 1))};
    if (has_columns(load.seen, {"magnification", "area_fraction", "rms_height",
                                "mean_gap", "opening_gap"}) &&
        has_columns(load.gaps, {"gap", "density"}))
      study.loads.push_back(load);
  }
  return study;
}

// P_u of a map is shown beside the distribution of Eq. (27) of Yang and Persson
// (2008) if the ratio of their loads is at most this.
constexpr double nearest_load_ratio = 1.25;
constexpr int shown_gap_bins = 60;
constexpr double widest_gap = 4.0; ///< of the distributions, in h_rms

CurveStyle colored(std::size_t load, int dash = 1) {
  return line(method_color(load), 1.6, dash);
}

ChartAxis magnification_axis() {
  return {.label = "magnification ζ", .is_log = true, .has_powers = true};
}

/// Returns axes against zeta on which y starts at 1e-4.
ChartPanel logarithmic_panel(const std::string& label) {
  return {
      .x = magnification_axis(),
      .y = {.label = label, .low = 1e-4, .is_log = true, .has_powers = true}};
}

/// Plots u/h_rms against zeta, one curve per load.
Figure separation_figure(const MagnifiedStudy& study) {
  Figure figure;
  figure.name = "magnification-separation";
  figure.title = "Separation in the apparent contact";
  CsvTable table({"load", "index", "zeta [1]", "u/h_rms [1]"});
  ChartPanel panel = logarithmic_panel("u / h_{rms}");
  for (const MagnifiedLoad& load : study.loads) {
    const std::string name = "p = " + quantity_text(load.pressure, "Pa", 3);
    const std::vector<double> zeta = load.seen->values("magnification");
    const std::vector<double> gap = load.seen->values("mean_gap");
    for (std::size_t i = 0; i < zeta.size(); ++i)
      table.add(name, {static_cast<double>(load.index), zeta[i],
                       gap[i] / study.rms_height});
    panel.add(name, colored(load.index), load.index, 3, 4);
  }
  figure.caption =
      "u(ζ), Eq. (23) of Yang and Persson (2008): the mean separation in the "
      "apparent contact at the magnification ζ = q/q_ref, in units of the rms "
      "height of the whole surface.";
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

/// Plots A, h_rms and u against zeta.
Figure parts_figure(const MagnifiedStudy& study) {
  Figure figure;
  figure.name = "magnification-parts";
  figure.title = "Area, roughness and separation";
  CsvTable table({"load", "index", "zeta [1]", "A/A_0 [1]", "u/h_rms [1]",
                  "h_rms(zeta)/h_rms [1]"});
  ChartPanel panel =
      logarithmic_panel("A/A_0,  u/h_{rms},  h_{rms}(ζ)/h_{rms}");
  for (const std::size_t chosen : three_of(study.loads.size())) {
    const MagnifiedLoad& load = study.loads[chosen];
    const std::string name = "p = " + quantity_text(load.pressure, "Pa", 3);
    const std::vector<double> zeta = load.seen->values("magnification");
    const std::vector<double> area = load.seen->values("area_fraction");
    const std::vector<double> gap = load.seen->values("mean_gap");
    const std::vector<double> height = load.seen->values("rms_height");
    for (std::size_t i = 0; i < zeta.size(); ++i)
      table.add(name,
                {static_cast<double>(load.index), zeta[i], area[i],
                 gap[i] / study.rms_height, height[i] / study.rms_height});
    if (panel.curves.empty())
      panel.add("h_rms(ζ)/h_rms", line("#222222", 1.6), load.index, 3, 6);
    panel.add("A/A₀, " + name, colored(load.index), load.index, 3, 4);
    panel.add("u/h_rms, " + name, colored(load.index, 2), load.index, 3, 5);
  }
  figure.caption =
      "Solid: the apparent contact area at the magnification ζ, Eq. (4) of "
      "Yang and Persson (2008) with the roughness up to ζ q_ref; dashed: the "
      "separation in it; black: the rms height still unresolved.";
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

/// Plots u and u_1 in nm against zeta, with A on the right-hand axis.
Figure opening_figure(const MagnifiedStudy& study) {
  Figure figure;
  figure.name = "magnification-opening";
  figure.title = "Loss of contact";
  CsvTable table(
      {"load", "index", "zeta [1]", "u [nm]", "u_1 [nm]", "A/A_0 [1]"});
  ChartPanel panel{.x = magnification_axis(),
                   .y = {.label = "u, u_1  [nm]", .low = 0.0},
                   .second =
                       ChartAxis{.label = "A/A_0", .low = 0.0, .high = 1.0}};
  double top = 0.0;
  for (const std::size_t chosen : three_of(study.loads.size())) {
    const MagnifiedLoad& load = study.loads[chosen];
    const std::string name = ", p = " + quantity_text(load.pressure, "Pa", 3);
    const std::vector<double> zeta = load.seen->values("magnification");
    const std::vector<double> gap = load.seen->values("mean_gap");
    const std::vector<double> opening = load.seen->values("opening_gap");
    const std::vector<double> area = load.seen->values("area_fraction");
    for (std::size_t i = 0; i < zeta.size(); ++i) {
      table.add(quantity_text(load.pressure, "Pa", 3),
                {static_cast<double>(load.index), zeta[i], gap[i] * 1e9,
                 std::isfinite(opening[i]) ? opening[i] * 1e9 : not_a_number,
                 area[i]});
      top = std::max(top, 2.0 * gap[i] * 1e9);
    }
    panel.add("u" + name, colored(load.index), load.index, 3, 4);
    panel.add("u₁" + name, colored(load.index, 2), load.index, 3, 5);
    panel.add("A/A₀" + name, colored(load.index, 3), load.index, 3, 6)
        .is_on_second_axis = true;
  }
  figure.caption =
      "u₁(ζ), Eq. (25) of Yang and Persson (2008): the separation of the area "
      "that comes into apparent contact as ζ falls; it rises without bound at "
      "small ζ, where hardly any area (dotted, right axis) is left to lose "
      "contact. Drawn up to twice the mean gap.";
  panel.y.high = rounded(top, 6);
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

const results::Fields* nearest_map(const results::MethodRecord& method,
                                   double pressure) {
  const results::Fields* nearest = nullptr;
  double least = std::log(nearest_load_ratio);
  for (const results::Fields* fields : whole_maps(method)) {
    const double ratio =
        std::abs(std::log(fields->nominal_pressure / pressure));
    if (ratio <= least) { // false for a NaN
      nearest = fields;
      least = ratio;
    }
  }
  return nearest;
}

/// Adds P_u of the methods' maps near the given load, one series per map.
void add_maps(const ReportEntry& entry, const MagnifiedLoad& load,
              double rms_height, CsvTable& table, ChartPanel& panel) {
  for (const results::MethodRecord* method : methods_with_maps(*entry.result)) {
    const results::Fields* map = nearest_map(*method, load.pressure);
    if (map == nullptr)
      continue;
    const std::size_t index = panel.curves.size();
    const results::Histogram histogram = results::gap_histogram(
        map->gap_map(), map->pressure_map(), shown_gap_bins,
        contact_criterion_of(*entry.contact_case, *method, rms_height));
    double open = 0.0;
    for (std::size_t i = 0; i < histogram.density.size(); ++i) {
      open += histogram.density[i] * histogram.bin_width();
      table.add(method->name, {static_cast<double>(index),
                               histogram.bin_centre(i) / rms_height,
                               histogram.density[i] * rms_height});
    }
    panel.add(fmt::format("P_u, {} at {}, {:.3g} at u = 0", method->name,
                          quantity_text(map->nominal_pressure, "Pa", 3),
                          1.0 - open),
              colored(index - 1, 2), index, 3, 4);
  }
}

/// Plots the distribution of u_1 beside P_u of the maps at the nearest load.
Figure distribution_figure(const ReportEntry& entry,
                           const MagnifiedStudy& study,
                           const MagnifiedLoad& load) {
  Figure figure;
  figure.name = fmt::format("separation-distributions-{}", load.index + 1);
  figure.title = "Distributions of the separation, p = " +
                 quantity_text(load.pressure, "Pa", 3);
  CsvTable table({"curve", "index", "u/h_rms [1]", "P h_rms [1]"});
  const std::vector<double> gap = load.gaps->values("gap");
  const std::vector<double> density = load.gaps->values("density");
  double top = 0.0;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const double reduced = gap[i] / study.rms_height;
    table.add("P_u1", {0.0, std::isfinite(reduced) ? reduced : not_a_number,
                       density[i] * study.rms_height});
    if (reduced > 0.2)
      top = std::max(top, density[i] * study.rms_height);
  }
  ChartPanel panel{
      .x = {.label = "separation u / h_{rms}", .low = 0.0, .high = widest_gap},
      .y = {.label = "P h_{rms}", .low = 0.0, .high = rounded(1.3 * top, 4)},
      .curves = {curve(
          fmt::format("theory, Eq. (27), {:.3g} at u = 0", load.contact_weight),
          line("#222222", 1.6), 0, 3, 4)}};
  add_maps(entry, load, study.rms_height, table, panel);
  figure.caption = fmt::format(
      "Solid: the theory's density of u₁, Eq. (27) of Yang and Persson (2008), "
      "a mean over the area that loses contact at one magnification and "
      "therefore narrower than Eq. (26); its delta function at u = 0 has the "
      "weight A(ζ₁)/A₀ = {:.4g}.{}",
      load.contact_weight,
      panel.curves.size() > 1
          ? " Dashed: P_u of Eq. (26) for the saved map at the "
            "nearest load; the rest of it is at u = 0, or below "
            "zero for a penalty and for atoms."
          : "");
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

void add_leaks(const results::Result& result, Figure& figure) {
  const results::Table* leak = result.table("leak");
  if (leak == nullptr)
    return;
  const std::vector<double> pressures = leak->values("nominal_pressure");
  const std::vector<double> flows = leak->values("mass_flow");
  const std::vector<double> gaps = leak->values("pore_gap");
  figure.caption += " Leakage through the critical pore, where the non-contact "
                    "area percolates:";
  for (std::size_t i = 0; i < pressures.size() && i < flows.size(); ++i)
    figure.caption += (i == 0 ? " " : "; ") +
                      quantity_text(pressures[i], "Pa", 3) +
                      (std::isfinite(flows[i])
                           ? fmt::format(", {:.2g} kg/s at u₁ = {}", flows[i],
                                         quantity_text(gaps[i], "m", 3))
                           : std::string(", none"));
  figure.caption += ".";
}

std::vector<Figure> magnification_figures(const ReportEntry& entry) {
  const MagnifiedStudy study = study_of(*entry.result);
  if (study.loads.empty())
    return {};
  std::vector<Figure> figures{separation_figure(study), parts_figure(study),
                              opening_figure(study)};
  add_leaks(*entry.result, figures.back());
  for (const std::size_t chosen : three_of(study.loads.size()))
    figures.push_back(distribution_figure(entry, study, study.loads[chosen]));
  return figures;
}

std::string leak_words(const results::Result& result, std::size_t load) {
  const results::Table* const leak = result.table("leak");
  if (leak == nullptr || !has_columns(leak, {"mass_flow", "pore_gap"}) ||
      leak->values("mass_flow").size() <= load)
    return "";
  const double flow = leak->values("mass_flow")[load];
  return std::isfinite(flow)
             ? fmt::format(
                   " {} leaks through its critical pore, {} high.",
                   quantity_text(flow, "kg/s", 3),
                   quantity_text(leak->values("pore_gap")[load], "m", 3))
             : " It does not leak: the open area does not percolate.";
}

/// What is in contact under the heaviest load: where half of the area is, and
/// with all of the roughness.
std::string magnification_answer(const ReportEntry& entry) {
  const MagnifiedStudy study = study_of(*entry.result);
  if (study.loads.empty())
    return "";
  const MagnifiedLoad& load =
      *std::ranges::max_element(study.loads, {}, &MagnifiedLoad::pressure);
  std::vector<double> shares = load.seen->values("area_fraction");
  for (double& share : shares) // ascending
    share = 1.0 / share;
  const double zeta =
      between_rows(shares, load.seen->values("magnification"), 2.0);
  const double gap = between_rows(shares, load.seen->values("mean_gap"), 2.0);
  std::string words = fmt::format(
      "Under {} the theory has {} % of the area in contact with all roughness",
      quantity_text(load.pressure, "Pa", 3),
      digits_text(100.0 * load.contact_weight, 3));
  if (std::isfinite(zeta + gap))
    words += fmt::format(", and half of it at the magnification {}, where the "
                         "faces are {} apart",
                         digits_text(zeta, 3), quantity_text(gap, "m", 3));
  return words + "." + leak_words(*entry.result, load.index);
}

// Loads that a case writes in two units are equal within this relative
// tolerance.
constexpr double unit_rounding = 1e-9;

const results::Table* table_of_load(const results::Result& result,
                                    std::size_t load) {
  return result.table(fmt::format("magnification-{}", load + 1));
}

Estimate at_magnification(const results::Result& result,
                          const cases::QuantityAtLoad& asked) {
  const results::Table* loads = result.table("magnification");
  if (loads == nullptr)
    return {.remark = "the study of magnifications was not run"};
  const double pressure =
      asked.nominal_pressure.in_si({result.contact_modulus, 0.0, 0.0, 0.0});
  const std::vector<double> pressures = loads->values("nominal_pressure");
  const auto found =
      std::find_if(pressures.begin(), pressures.end(), [&](double one) {
        return std::abs(one - pressure) <= unit_rounding * pressure;
      });
  const auto load = static_cast<std::size_t>(found - pressures.begin());
  const results::Table* rows =
      found == pressures.end() ? nullptr : table_of_load(result, load);
  if (rows == nullptr)
    return {.remark = fmt::format("p = {} is not a load of [magnification]",
                                  quantity_text(pressure, "Pa", 6))};
  const bool is_area = asked.quantity == "area_fraction";
  const double value =
      between_rows(rows->values("magnification"),
                   rows->values(is_area ? "area_fraction" : "mean_gap"),
                   *asked.magnification);
  const double scale = is_area ? 1.0
                       : asked.quantity == "reduced_mean_gap"
                           ? loads->values("rms_height").at(load)
                           : loads->values("mean_gap").at(load);
  return single_number(
      value / scale, "from the formula",
      fmt::format("zeta = {:g} lies outside the computed range",
                  *asked.magnification));
}

/// Returns the largest |u/u' - 1| between the rows of two loads, for
/// magnifications of at least `from`.
double largest_difference(const results::Table& light,
                          const results::Table& heavy, double from) {
  const std::vector<double> zeta = light.values("magnification");
  const std::vector<double> gap = light.values("mean_gap");
  const std::vector<double> other = heavy.values("mean_gap");
  double largest = not_a_number;
  for (std::size_t i = 0; i < zeta.size() && i < other.size(); ++i)
    if (zeta[i] >= from && other[i] > 0.0)
      largest = std::fmax(largest, std::abs(gap[i] / other[i] - 1.0));
  return largest;
}

Estimate gap_pressure_dependence(const results::Result& result) {
  const results::Table* loads = result.table("magnification");
  const std::vector<double> pressures = loads == nullptr
                                            ? std::vector<double>{}
                                            : loads->values("nominal_pressure");
  if (pressures.size() < 2)
    return {.remark = "the study of magnifications has fewer than two loads"};
  std::vector<std::size_t> order(pressures.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return pressures[a] < pressures[b];
  });
  const results::Table* light = table_of_load(result, order[0]);
  const results::Table* heavy = table_of_load(result, order[1]);
  if (light == nullptr || heavy == nullptr)
    return {.remark = "a table of magnifications is missing"};
  const double begin = loads->values("lowest_magnification").at(order[0]);
  return single_number(largest_difference(*light, *heavy, 2.0 * begin),
                       "from the formula",
                       "no computed magnification is high enough");
}

void add_magnification_quantities(const results::Result& result,
                                  const cases::Case& contact_case,
                                  const results::MethodRecord& method,
                                  std::span<const std::string> names,
                                  MethodSummary& summary) {
  if (!asks<MagnificationStudy>(contact_case) ||
      !is_study_theory(contact_case, method))
    return;
  auto& quantities = summary.quantities;
  quantities["gap_pressure_dependence"] = gap_pressure_dependence(result);
  for (const std::string& name : names) {
    const auto asked = cases::read_quantity_at_load(name).at_load;
    if (asked && asked->magnification)
      quantities[name] = at_magnification(result, *asked);
  }
}

std::vector<cases::ExpectationName> quantities_of_magnification() {
  const auto seen = [](const char* name, const char* description) {
    return quantity_of_theory(name, description, "magnification",
                              cases::QuantityOf::magnification);
  };
  return {
      quantity_of_theory("gap_pressure_dependence",
                         "Largest |u(zeta) / u'(zeta) - 1| between the two "
                         "lightest loads of [magnification], from twice the "
                         "zeta at which roughness begins [1].",
                         "magnification"),
      seen("area_fraction", "A(zeta)/A_0 [1]."),
      seen("reduced_mean_gap",
           "u(zeta) / h_rms, with h_rms of the full surface [1]."),
      seen("mean_gap_ratio", "u(zeta) divided by the mean gap u [1].")};
}

std::string magnification_text(const cases::Case& contact_case) {
  const auto* const study = contact_case.study<MagnificationStudy>();
  if (study == nullptr)
    return "";
  std::string text =
      fmt::format(" The contact was evaluated at magnifications from {:g} to "
                  "{:g} by Eqs. (23) to (28) of [yang2008].",
                  study->from, study->to);
  if (study->leak)
    text += fmt::format(
        " The leakage of a fluid with the viscosity {:g} Pa s under a "
        "pressure drop of {:g} Pa was estimated from the one pore at which "
        "the open area percolates.",
        study->leak->viscosity, study->leak->pressure_drop);
  return text;
}

} // namespace

const StudyPages& magnification_pages() {
  static const StudyPages pages{
      .name = "magnification",
      .figure_names = {"magnification-opening", "magnification-parts",
                       "magnification-separation", "separation-distributions-"},
      .figures = drawn_by<magnification_figures>,
      .answer = magnification_answer,
      .methods_text = magnification_text,
      .quantities = quantities_of_magnification(),
      .add_quantities = add_magnification_quantities};
  return pages;
}

} // namespace asperity::studies
