#include "reports/figures/figures.hpp"

#include "reports/analysis/warnings.hpp"
#include "reports/figures/height_figure.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/figures/shown_panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <new>

namespace asperity::reports {
namespace {

void append(std::vector<Figure>& figures, Figure figure) {
  figures.push_back(std::move(figure));
}

void append(std::vector<Figure>& figures, std::optional<Figure> figure) {
  if (figure)
    figures.push_back(std::move(*figure));
}

void append(std::vector<Figure>& figures, std::vector<Figure> more) {
  std::move(more.begin(), more.end(), std::back_inserter(figures));
}

// Adds the figures that `build` returns. If it throws, a placeholder figure
// that states the reason is added instead, so that the report continues.
template <class Build>
void add(std::vector<Figure>& figures, const char* name, const Build& build) {
  try {
    append(figures, build());
  } catch (const std::bad_alloc&) {
    throw; // a system error, not a property of the data
  } catch (const std::exception& error) {
    Figure none;
    none.name = none.title = name;
    none.problem = error.what();
    figures.push_back(std::move(none));
  }
}

// Returns the folder name of a case. The leading number makes it unique.
std::string folder_name(std::size_t index, const std::string& name) {
  return fmt::format("{}-{}", index + 1, file_word(name));
}

bool has_tension(const results::Result& result) {
  for (const results::MethodRecord& method : result.methods)
    for (const results::Curve& curve : method.realizations)
      for (const results::CurvePoint& row : curve.points)
        if (row.status == results::StepStatus::converged &&
            row.nominal_pressure < 0.0)
          return true;
  return false;
}

/// True if steps converged and none is pressed: a warning says so, or the
/// figure of the path with adhesion shows it.
bool is_never_pressed(std::span<const ReportEntry> entries,
                      std::span<const Series> series) {
  return std::ranges::all_of(
             series, [](const Series& one) { return one.rows.empty(); }) &&
         std::ranges::any_of(entries, [](const ReportEntry& entry) {
           return has_tension(*entry.result) ||
                  std::ranges::any_of(
                      warnings_of(*entry.result, *entry.contact_case),
                      [](const Warning& one) {
                        return one.kind == "no_contact";
                      });
         });
}

FigureGroup shared_curves(std::span<const ReportEntry> entries,
                          std::span<const Series> series) {
  FigureGroup group{"The curves", "", {}};
  const bool has_rough =
      std::any_of(entries.begin(), entries.end(), [](const ReportEntry& e) {
        return !is_exact_shape(*e.contact_case);
      });
  if (!has_rough || is_never_pressed(entries, series))
    return group;
  auto& figures = group.figures;
  const FigureScales scales = figure_scales(entries);
  add(figures, "pressure-gap",
      [&] { return pressure_gap_figure(series, scales); });
  add(figures, "gap-deviation",
      [&] { return gap_deviation_figure(series, scales); });
  add(figures, "area-pressure", [&] { return area_figure(series, scales); });
  add(figures, "area-coefficient",
      [&] { return area_coefficient_figure(series); });
  add(figures, "area-theory", [&] { return area_theory_figure(series); });
  return group;
}

FigureGroup figures_of_one(const ReportEntry& entry, std::size_t index,
                           bool is_one_of_many) {
  FigureGroup group{"Surface and contact", "", {}};
  if (is_one_of_many) {
    group.heading += ": " + entry.summary.case_name;
    group.folder = folder_name(index, entry.summary.case_name);
  }
  auto& figures = group.figures;
  const bool is_exact = is_exact_shape(*entry.contact_case);
  if (is_exact)
    add(figures, "exact", [&] { return exact_figures(entry); });
  add(figures, "surface", [&] { return surface_figure(entry); });
  add(figures, "two-faces", [&] { return two_faces_figure(entry); });
  add(figures, "spectrum", [&] { return spectrum_figure(entry); });
  add(figures, "height-distribution", [&] { return height_figure(entry); });
  if (!is_exact) {
    add(figures, "pressure-distribution",
        [&] { return pressure_distribution_figures(entry); });
    add(figures, "gap-distribution",
        [&] { return gap_distribution_figures(entry); });
  }
  add(figures, "plastic-area", [&] { return plastic_area_figure(entry); });
  add(figures, "maps", [&] { return map_figures(entry); });
  add(figures, "stress-inside", [&] { return stress_figures(entry); });
  return group;
}

/// Returns the figures of the studies of one result; the group is empty if the
/// result has none.
FigureGroup study_figures(const ReportEntry& entry, std::size_t index,
                          std::span<const Series> series, bool is_one_of_many) {
  FigureGroup group{
      "Magnification, adhesion, flow, conductance and friction", "", {}};
  if (is_one_of_many) {
    group.heading += ": " + entry.summary.case_name;
    group.folder = folder_name(index, entry.summary.case_name);
  }
  add(group.figures, "magnification",
      [&] { return magnification_figures(entry); });
  add(group.figures, "adhesion", [&] { return adhesion_figures(entry); });
  add(group.figures, "leak-rate", [&] { return flow_figure(entry); });
  add(group.figures, "flux", [&] { return flux_figures(entry); });
  add(group.figures, "partial-slip",
      [&] { return slip_figure(entry, index, series); });
  add(group.figures, "traction", [&] { return traction_figures(entry); });
  add(group.figures, "conductance", [&] { return conductance_figure(entry); });
  add(group.figures, "spots", [&] { return spot_figures(entry); });
  return group;
}

} // namespace

std::vector<FigureGroup> figures_of(std::span<const ReportEntry> entries) {
  const std::vector<Series> series = series_of(entries);
  const bool has_many = entries.size() > 1;
  std::vector<FigureGroup> groups;
  groups.push_back(shared_curves(entries, series));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    groups.push_back(figures_of_one(entries[i], i, has_many));
    groups.push_back(study_figures(entries[i], i, series, has_many));
  }
  FigureGroup differences{"Differences of the pressures", "", {}};
  add(differences.figures, "pressure-difference",
      [&] { return difference_figures(entries); });
  groups.push_back(std::move(differences));
  FigureGroup cost{"Cost", "", {}};
  add(cost.figures, "cost",
      [&] { return cost_figure(series, figure_scales(entries)); });
  groups.push_back(std::move(cost));
  const FigureScales scales = figure_scales(entries);
  for (FigureGroup& group : groups) {
    leave_out_empty_panels(group.figures);
    for (Figure& figure : group.figures)
      put_units(figure, scales);
  }
  std::erase_if(groups,
                [](const FigureGroup& group) { return group.figures.empty(); });
  return groups;
}

} // namespace asperity::reports
