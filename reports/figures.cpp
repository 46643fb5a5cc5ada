#include "reports/figures.hpp"

#include "reports/height_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
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
  if (has_rough) {
    group.figures.push_back(pressure_gap_figure(entries, series));
    append(group.figures, gap_deviation_figure(series));
    group.figures.push_back(area_figure(series));
    group.figures.push_back(area_coefficient_figure(series));
    append(group.figures, area_theory_figure(series));
  }
  return group;
}

FigureGroup figures_of_one(const ReportEntry& entry, std::size_t index,
                           bool is_one_of_many) {
  FigureGroup group{"Surface and contact", "", {}};
  if (is_one_of_many) {
    group.heading += ": " + entry.summary.case_name;
    group.folder = folder_name(index, entry.summary.case_name);
  }
  if (is_exact_shape(*entry.contact_case))
    group.figures = exact_figures(entry);
  append(group.figures, surface_figure(entry));
  append(group.figures, two_faces_figure(entry));
  append(group.figures, spectrum_figure(entry));
  append(group.figures, height_figure(entry));
  if (!is_exact_shape(*entry.contact_case)) {
    append(group.figures, pressure_distribution_figures(entry));
    append(group.figures, gap_distribution_figures(entry));
  }
  append(group.figures, map_figures(entry));
  append(group.figures, stress_figures(entry));
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
  append(group.figures, magnification_figures(entry));
  append(group.figures, adhesion_figures(entry));
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
  append(cost.figures, cost_figure(series));
  groups.push_back(std::move(cost));
  std::erase_if(groups,
                [](const FigureGroup& group) { return group.figures.empty(); });
  return groups;
}

} // namespace asperity::reports
