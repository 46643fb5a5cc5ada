// The figures, the text and the quantities of [adhesion].
#include "base/shown_number.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"
#include "studies/adhesion/adhesion.hpp"
#include "studies/theory_quantities.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace asperity::studies {

using namespace reports;

namespace {

using results::Table;

struct Curve {
  const char* column;
  const char* title;
  const char* color;
  bool is_dashed = false;
};

const char* const red = "#D55E00";
const char* const green = "#009E73";
const char* const blue = "#0072B2";

/// A column of the table as x.
struct Across {
  std::string column;
  double scale = 1.0;
  std::string name; ///< in the table of the figure, with its unit
};

/// Plots curves of the table against one of its columns, one series per curve.
Figure figure_of(const Table& rows, const std::string& name,
                 const Across& across, const std::vector<Curve>& curves) {
  Figure figure;
  figure.name = name;
  CsvTable table({"curve", "index", across.name, "value [1]"});
  ChartPanel panel{.y = {.low = -0.2, .high = 1.05}, .has_zero_line = true};
  const std::vector<double> x = rows.values(across.column);
  std::size_t index = 0;
  for (const Curve& one : curves) {
    const std::vector<double> y = rows.values(one.column);
    for (std::size_t i = 0; i < x.size() && i < y.size(); ++i)
      table.add(one.title,
                {static_cast<double>(index), x[i] * across.scale, y[i]});
    panel.add(one.title, line(one.color, 1.6, one.is_dashed ? 2 : 1), index++,
              3, 4);
  }
  figure.data = table.text();
  figure.panels = {std::move(panel)};
  return figure;
}

void label_axes(Figure& figure, const std::string& x, const std::string& y) {
  figure.panels.front().x.label = x;
  figure.panels.front().y.label = y;
}

const char* const ratio_axis = "h_{rms} / h_{rms0}";
const char* const both_axis = "γ_{eff}(1) / Δγ,  A/A_0";

Figure branches_figure(const Table& rows) {
  Figure figure = figure_of(
      rows, "adhesion-branches", {"height_ratio", 1.0, "h_rms/h_rms0 [1]"},
      {{"binding_partial", "γ_eff/Δγ, partial contact", red},
       {"binding_complete", "γ_eff/Δγ, complete contact", green},
       {"area_fraction_partial", "A/A₀, partial contact", red, true}});
  figure.title = "Both branches of adhesive contact";
  figure.caption = "The effective binding energy at the lowest magnification "
                   "and the real contact area against the rms height of the "
                   "roughness, without external pressure. The equilibrium "
                   "state is the branch with the larger binding energy.";
  label_axes(figure, ratio_axis, both_axis);
  return figure;
}

Figure equilibrium_figure(const Table& rows, const Table* flip) {
  Figure figure = figure_of(
      rows, "adhesion-equilibrium", {"height_ratio", 1.0, "h_rms/h_rms0 [1]"},
      {{"binding_equilibrium", "γ_eff/Δγ", blue},
       {"area_fraction_equilibrium", "A/A₀", blue, true}});
  figure.title = "Adhesive contact in equilibrium";
  const std::vector<double> ratio =
      flip == nullptr ? std::vector<double>{} : flip->values("height_ratio");
  const std::vector<double> left =
      flip == nullptr ? std::vector<double>{} : flip->values("area_fraction");
  figure.caption =
      ratio.size() == 1 && left.size() == 1 && std::isfinite(ratio.front())
          ? fmt::format("Contact flips from complete to A/A₀ = {:.3g} at "
                        "h_rms/h_rms0 = {:.4g}.",
                        left.front(), ratio.front())
          : std::string("There is no flip between two ratios of the study.");
  figure.caption += " Where there is no curve, the surfaces separate or the "
                    "partial contact did not converge. " +
                    rows.title + ".";
  label_axes(figure, ratio_axis, both_axis);
  return figure;
}

Figure height_figure(const Table& rows) {
  const double in_um = 1e6;
  Figure figure =
      figure_of(rows, "adhesion-height", {"rms_height", in_um, "h_rms [um]"},
                {{"binding_complete", "complete contact", blue},
                 {"binding_equilibrium", "equilibrium", red}});
  figure.title = "Binding energy against roughness";
  figure.caption =
      "γ_eff/Δγ, the remaining fraction of the binding energy of flat "
      "surfaces; the pull-off force of a ball is proportional to it.";
  const std::vector<double> heights = rows.values("rms_height");
  const std::vector<double> forces = rows.values("pull_off_force");
  if (!forces.empty() && forces.size() == heights.size())
    figure.caption += fmt::format(
        " For the case's ball it falls from {:.3g} N at {:.3g} µm to {:.3g} N "
        "at {:.3g} µm.",
        forces.front(), heights.front() * in_um, forces.back(),
        heights.back() * in_um);
  label_axes(figure, "h_{rms}  [µm]", "γ_{eff}(1) / Δγ");
  return figure;
}

std::vector<Figure> adhesion_figures(const ReportEntry& entry) {
  const Table* rows = entry.result->table("adhesion");
  if (rows == nullptr)
    return {};
  return {branches_figure(*rows),
          equilibrium_figure(*rows, entry.result->table("adhesion-flip")),
          height_figure(*rows)};
}

Estimate of_flip(const results::Result& result, const std::string& column,
                 const std::string& reason_if_none) {
  const Table* flip = result.table("adhesion-flip");
  if (flip == nullptr || flip->values(column).empty())
    return {.remark = "the study of adhesion was not run"};
  return single_number(flip->values(column).front(), "from the formula",
                       reason_if_none);
}

void add_adhesion_quantities(const results::Result& result,
                             const cases::Case& contact_case,
                             const results::MethodRecord& method,
                             std::span<const std::string>,
                             MethodSummary& summary) {
  if (!asks<AdhesionStudy>(contact_case) ||
      !is_study_theory(contact_case, method))
    return;
  auto& quantities = summary.quantities;
  const std::string no_flip = "no flip between two ratios of the study";
  quantities["adhesion_flip"] = of_flip(result, "height_ratio", no_flip);
  quantities["adhesion_flip_area"] = of_flip(result, "area_fraction", no_flip);
  quantities["complete_contact_binding"] =
      of_flip(result, "complete_contact_binding", "not a number");
  if (const Table* const rows = result.table("adhesion")) {
    const auto here = [&](const char* column) {
      return single_number(
          between_rows(rows->values("height_ratio"), rows->values(column), 1.0),
          "from the formula", "no partial contact at h_rms/h_rms0 = 1");
    };
    quantities["effective_work_approach"] = here("binding_partial");
    quantities["unloaded_area_approach"] = here("area_fraction_partial");
    quantities["effective_work_retraction"] = here("binding_complete");
    quantities["unloaded_area_retraction"] = here("area_fraction_complete");
  }
}

/// The state at the rms height that is nearest to that of the case, and where
/// complete contact ends.
std::string adhesion_answer(const ReportEntry& entry) {
  const Table* const rows = entry.result->table("adhesion");
  if (rows == nullptr || rows->values("rms_height").empty())
    return "";
  const std::vector<double> ratios = rows->values("height_ratio");
  const auto nearest = static_cast<std::size_t>(
      std::ranges::min_element(
          ratios, {}, [](double ratio) { return std::abs(ratio - 1.0); }) -
      ratios.begin());
  const auto here = [&](const char* column) {
    const std::vector<double> values = rows->values(column);
    return nearest < values.size() ? values[nearest] : not_a_number;
  };
  const double height = here("rms_height");
  const double area = here("area_fraction_equilibrium");
  std::vector<std::string> parts;
  if (const double binding = here("binding_equilibrium"); binding > 0.0)
    parts.push_back(fmt::format(
        "at an rms height of {} and without load, {} % of the area touches, "
        "with {} % of the binding energy of flat faces",
        quantity_text(height, "m", 3), digits_text(100.0 * area, 3),
        digits_text(100.0 * binding, 3)));
  if (const double force = here("pull_off_force"); force > 0.0)
    parts.push_back(
        fmt::format("the ball comes off at {}", quantity_text(force, "N", 3)));
  const Table* const flip = entry.result->table("adhesion-flip");
  if (flip != nullptr && !flip->values("height_ratio").empty())
    if (const double ratio = flip->values("height_ratio").front();
        std::isfinite(ratio))
      parts.push_back(
          fmt::format("contact is complete up to {}",
                      quantity_text(ratio * height / ratios[nearest], "m", 3)));
  return parts.empty() ? ""
                       : fmt::format("By the theory of rough adhesion: {}.",
                                     fmt::join(parts, "; "));
}

std::vector<cases::ExpectationName> quantities_of_adhesion() {
  return {
      quantity_of_theory("adhesion_flip",
                         "h_rms / h_rms0 at which complete and partial "
                         "contact have the same gamma_eff [1].",
                         "adhesion"),
      quantity_of_theory("adhesion_flip_area",
                         "A/A_0 of the partial contact at this transition [1].",
                         "adhesion"),
      quantity_of_theory("complete_contact_binding",
                         "gamma_eff / Delta gamma of complete contact on "
                         "the case's surface [1].",
                         "adhesion")};
}

std::string adhesion_text(const cases::Case& contact_case) {
  return asks<AdhesionStudy>(contact_case) ? " Adhesion follows [persson2002]."
                                           : "";
}

} // namespace

const StudyPages& adhesion_pages() {
  static const StudyPages pages{.name = "adhesion",
                                .figure_names = {"adhesion-branches",
                                                 "adhesion-equilibrium",
                                                 "adhesion-height"},
                                .figures = drawn_by<adhesion_figures>,
                                .answer = adhesion_answer,
                                .methods_text = adhesion_text,
                                .quantities = quantities_of_adhesion(),
                                .add_quantities = add_adhesion_quantities};
  return pages;
}

} // namespace asperity::studies
