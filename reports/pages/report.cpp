#include "reports/pages/report.hpp"

#include "base/atomic_file.hpp"
#include "base/json.hpp"
#include "input/input_error.hpp"
#include "input/reader/read_case.hpp"
#include "reports/analysis/measured_curve.hpp"
#include "reports/analysis/verdict.hpp"
#include "reports/analysis/warnings.hpp"
#include "reports/figures/figures.hpp"
#include "reports/pages/answers.hpp"
#include "reports/pages/entry_names.hpp"
#include "reports/pages/methods_text.hpp"
#include "reports/pages/page_data.hpp"
#include "reports/report_template.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::reports {
namespace {

/// Returns the case of a result without a case text: it has no analytical
/// spectrum and no expectations, and its surface is known by its map only.
cases::Case case_without_text(const results::Result& result) {
  cases::Case contact_case;
  contact_case.path = result.path;
  contact_case.name = result.case_name;
  contact_case.title = result.case_title;
  contact_case.surface.kind = mechanics::SurfaceKind::measured;
  contact_case.material.contact_modulus = result.contact_modulus;
  return contact_case;
}

void write_comparison(std::span<const ReportEntry> entries,
                      const std::filesystem::path& folder) {
  const std::vector<Series> series = series_of(entries);
  const std::vector<Agreement> agreements = agreements_of(entries, series);
  write_file_atomically(folder / "comparison.json",
                        text_of_json(agreement_json(agreements), 2) + "\n");
  write_file_atomically(folder / "comparison.csv", agreement_csv(agreements));
}

/// Requires the numbers that both a result and its case state to be the same.
/// @throws input::InputError  naming both
void require_case_of(const results::Result& result,
                     const cases::Case& contact_case) {
  const auto require = [&](const std::string& place, double found,
                           const char* key, double stated, const char* unit) {
    constexpr double tolerance = 1e-6; // of printed numbers
    if (!(std::abs(found - stated) <= tolerance * std::abs(stated)))
      throw input::InputError(
          fmt::format("{}: {} = {}, but its case states {} = {} [{}]",
                      result.path, place, found, key, stated, unit));
  };
  // That of a layered block may be the modulus below the layers.
  if (contact_case.material.layers.empty())
    require("/contact_modulus", result.contact_modulus, "E*",
            contact_case.material.contact_modulus, "Pa");
  const mechanics::SurfaceSpec& surface = contact_case.surface;
  if (surface.kind == mechanics::SurfaceKind::measured || !surface.length ||
      !surface.points)
    return;
  for (std::size_t r = 0; r < result.surfaces.size(); ++r) {
    const Grid& grid = result.surfaces[r].grid;
    if (grid.size() == 0)
      continue;
    const std::string place = fmt::format("/surfaces/{}/", r);
    require(place + "length_x", grid.length_x, "surface.length",
            *surface.length, "m");
    require(place + "length_y", grid.length_y, "surface.length",
            *surface.length, "m");
    require(place + "points_x", grid.points_x, "surface.points",
            *surface.points, "1");
    require(place + "points_y", grid.points_y, "surface.points",
            *surface.points, "1");
  }
}

} // namespace

ReportEntry entry_of(const results::Result& result,
                     const cases::Case& contact_case) {
  ReportEntry entry{&result, &contact_case, summarize(result, contact_case)};
  entry.summary.answers = answers_of(entry);
  entry.summary.interval_parts = interval_parts(entry);
  return entry;
}

cases::Case case_of(const results::Result& result) {
  if (result.case_text.empty())
    return case_without_text(result);
  cases::Case contact_case =
      cases::read_case_text(result.case_text, result.path);
  contact_case.name = result.case_name;
  require_case_of(result, contact_case);
  return contact_case;
}

std::vector<std::string> write_report(std::span<const results::Result> results,
                                      const std::filesystem::path& folder,
                                      const std::string& gnuplot,
                                      const ReportExtras& extras) {
  std::vector<cases::Case> contact_cases;
  for (const results::Result& result : results)
    contact_cases.push_back(case_of(result));
  std::vector<ReportEntry> entries;
  for (std::size_t i = 0; i < results.size(); ++i)
    entries.push_back(entry_of(results[i], contact_cases[i]));
  name_entries(entries, extras.labels);
  for (ReportEntry& entry : entries)
    if (!entry.result->methods.empty() &&
        entry.result->methods.front().kind == measured_kind)
      entry.summary.answers = curve_answers(entry, entries.front());
  return write_report(entries, folder, gnuplot, extras);
}

namespace {

/// The figures whose names begin with one of the words.
std::vector<FigureGroup> chosen(std::vector<FigureGroup> groups,
                                const std::vector<std::string>& words) {
  const auto begins = [](const std::string& word) {
    return
        [&word](const Figure& figure) { return figure.name.starts_with(word); };
  };
  std::vector<std::string> names;
  for (const FigureGroup& group : groups)
    for (const Figure& figure : group.figures)
      names.push_back(figure.name);
  for (const std::string& word : words)
    if (std::ranges::none_of(groups, [&](const FigureGroup& group) {
          return std::ranges::any_of(group.figures, begins(word));
        }))
      throw input::InputError(
          fmt::format("--only {}: no figure of this report begins so; it has: "
                      "{}",
                      word, fmt::join(names, ", ")));
  if (words.empty())
    return groups;
  for (FigureGroup& group : groups)
    std::erase_if(group.figures, [&](const Figure& figure) {
      return std::ranges::none_of(
          words, [&](const std::string& word) { return begins(word)(figure); });
    });
  return groups;
}

void write_methods_text(std::span<const ReportEntry> entries,
                        const std::filesystem::path& folder) {
  const MethodsText text = methods_text(entries);
  write_file_atomically(
      folder / "methods.txt",
      fmt::format("{}\n", fmt::join(text.paragraphs, "\n\n")));
  write_file_atomically(folder / "methods.bib", text.literature);
}

} // namespace

std::vector<std::string> write_report(std::span<const ReportEntry> entries,
                                      const std::filesystem::path& folder,
                                      const std::string& gnuplot,
                                      const ReportExtras& extras) {
  if (entries.empty())
    return {};
  const std::vector<FigureGroup> figures =
      chosen(figures_of(entries), extras.only);
  std::filesystem::create_directories(folder);
  write_methods_text(entries, folder);
  std::vector<std::string> problems;
  const std::vector<DrawnGroup> drawn_groups =
      drawn_groups_of(figures, folder, gnuplot, extras.journal, problems);
  std::vector<nlohmann::ordered_json> summaries;
  for (const ReportEntry& entry : entries)
    summaries.push_back(page_summary(entry));
  if (entries.size() == 1)
    write_file_atomically(folder / "summary.json",
                          text_of_json(summaries.front(), 2) + "\n");
  else
    write_comparison(entries, folder);
  write_page(report_template, report_page(entries, summaries, drawn_groups),
             drawn_groups, folder, extras.has_pdf, problems);
  return problems;
}

} // namespace asperity::reports
