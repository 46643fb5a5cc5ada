#include "reports/figures/figures.hpp"
#include "reports/study_pages.hpp"

#include <algorithm>

namespace asperity::reports {
namespace {

std::vector<const ReportFigure*>& all_figures() {
  static std::vector<const ReportFigure*> all = {
      &figures::pressure_gap,
      &figures::gap_deviation,
      &figures::area_pressure,
      &figures::area_coefficient,
      &figures::area_theory,
      &figures::exact,
      &figures::surface,
      &figures::two_faces,
      &figures::spectrum,
      &figures::height_distribution,
      &figures::pressure_distribution,
      &figures::gap_distribution,
      &figures::plastic_area,
      &figures::maps,
      &figures::stress,
      &figures::adhesion_loop,
      &figures::pressure_difference,
      &figures::cost,
  };
  return all;
}

} // namespace

std::span<const ReportFigure* const> report_figures() {
  return all_figures();
}

RegisteredFigure::RegisteredFigure(const ReportFigure& figure) {
  all_figures().push_back(&figure);
}

RegisteredFigure::~RegisteredFigure() {
  all_figures().pop_back();
}

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (const ReportFigure* const figure : report_figures())
    for (const char* const name : figure->names)
      if (name != nullptr)
        names.emplace_back(name);
  for (const StudyPages* const study : study_pages())
    names.insert(names.end(), study->figure_names.begin(),
                 study->figure_names.end());
  return names;
}

bool is_figure_name(const std::string& name) {
  const std::vector<std::string> names = figure_names();
  return std::ranges::any_of(names, [&](const std::string& known) {
    return known.ends_with('-')
               ? name.size() > known.size() && name.starts_with(known)
               : name == known;
  });
}

} // namespace asperity::reports
