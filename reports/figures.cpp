#include "reports/figures.hpp"

#include "reports/height_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <iterator>

namespace asperity::reports {
namespace {

void append(std::vector<Figure>& figures, std::optional<Figure> figure) {
  if (figure)
    figures.push_back(std::move(*figure));
}

void append(std::vector<Figure>& figures, std::vector<Figure> more) {
  std::move(more.begin(), more.end(), std::back_inserter(figures));
}

/// Adds what `draw` gives. A figure is no reason to end a run: what it throws
/// becomes a figure without a name, whose caption says why it is not there.
template <class Draw>
void add(std::vector<Figure>& figures, const char* title, Draw draw) {
  try {
    append(figures, draw());
  } catch (const std::exception& error) {
    Figure missing;
    missing.title = title;
    missing.caption = error.what();
    figures.push_back(std::move(missing));
  }
}

// The case's name as a folder's: whatever is not a letter or digit is a dash.
std::string folder_name(std::size_t index, std::string name) {
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return std::isalnum(c) == 0; }, '-');
  return fmt::format("{}-{}", index + 1, name);
}

FigureGroup shared_curves(std::span<const ReportEntry> entries,
                          std::span<const Series> series) {
  FigureGroup group{"The curves", "", {}};
  const bool has_rough =
      std::any_of(entries.begin(), entries.end(), [](const ReportEntry& e) {
        return !is_exact_shape(*e.contact_case);
      });
  if (!has_rough)
    return group;
  add(group.figures, "Pressure and gap",
      [&] { return std::optional(pressure_gap_figure(entries, series)); });
  add(group.figures, "Gap against the theory's",
      [&] { return gap_deviation_figure(series); });
  add(group.figures, "Contact area",
      [&] { return std::optional(area_figure(series)); });
  add(group.figures, "Area-load coefficient",
      [&] { return std::optional(area_coefficient_figure(series)); });
  add(group.figures, "Contact area against the theory's",
      [&] { return area_theory_figure(series); });
  return group;
}

FigureGroup figures_of_one(const ReportEntry& entry, std::size_t index,
                           bool is_one_of_many) {
  FigureGroup group{"Surface and contact", "", {}};
  if (is_one_of_many) {
    group.heading += ": " + entry.summary.case_name;
    group.folder = folder_name(index, entry.summary.case_name);
  }
  const bool is_exact = is_exact_shape(*entry.contact_case);
  std::vector<Figure>& figures = group.figures;
  if (is_exact)
    add(figures, "Against the exact solution",
        [&] { return exact_figures(entry); });
  add(figures, "Surface", [&] { return surface_figure(entry); });
  add(figures, "Both surfaces", [&] { return two_faces_figure(entry); });
  add(figures, "Height spectrum", [&] { return spectrum_figure(entry); });
  add(figures, "Height distribution", [&] { return height_figure(entry); });
  if (!is_exact) {
    add(figures, "Distribution of the contact pressure",
        [&] { return pressure_distribution_figures(entry); });
    add(figures, "Distribution of the separation",
        [&] { return gap_distribution_figures(entry); });
  }
  add(figures, "Maps of pressure and gap", [&] { return map_figures(entry); });
  add(figures, "Stress inside", [&] { return stress_figures(entry); });
  return group;
}

/// What the studies of one result draw; empty if it has none.
FigureGroup study_figures(const ReportEntry& entry, std::size_t index,
                          bool is_one_of_many) {
  FigureGroup group{"Magnification and adhesion", "", {}};
  if (is_one_of_many) {
    group.heading += ": " + entry.summary.case_name;
    group.folder = folder_name(index, entry.summary.case_name);
  }
  add(group.figures, "Magnification",
      [&] { return magnification_figures(entry); });
  add(group.figures, "Adhesion", [&] { return adhesion_figures(entry); });
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
    groups.push_back(study_figures(entries[i], i, has_many));
  }
  FigureGroup cost{"Cost", "", {}};
  add(cost.figures, "Cost", [&] { return cost_figure(series); });
  groups.push_back(std::move(cost));
  std::erase_if(groups,
                [](const FigureGroup& group) { return group.figures.empty(); });
  return groups;
}

} // namespace asperity::reports
