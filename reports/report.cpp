#include "reports/report.hpp"

#include "base/atomic_file.hpp"
#include "cases/read_case.hpp"
#include "reports/figures.hpp"
#include "reports/html_report.hpp"
#include "reports/verdict.hpp"
#include "reports/warnings.hpp"

#include <fmt/format.h>

namespace asperity::reports {

ReportEntry entry_of(const results::Result& result,
                     const cases::Case& contact_case) {
  return {&result, &contact_case, summarize(result, contact_case)};
}

cases::Case case_of(const results::Result& result) {
  cases::Case contact_case =
      cases::read_case_text(result.case_text, result.path);
  contact_case.name = result.case_name;
  return contact_case;
}

std::vector<std::string> write_report(std::span<const results::Result> results,
                                      const std::filesystem::path& folder,
                                      const std::string& gnuplot) {
  std::vector<cases::Case> contact_cases;
  for (const results::Result& result : results)
    contact_cases.push_back(case_of(result));
  std::vector<ReportEntry> entries;
  for (std::size_t i = 0; i < results.size(); ++i)
    entries.push_back(entry_of(results[i], contact_cases[i]));
  return write_report(entries, folder, gnuplot);
}

std::vector<std::string> write_report(std::span<const ReportEntry> entries,
                                      const std::filesystem::path& folder,
                                      const std::string& gnuplot) {
  if (entries.empty())
    return {};
  std::filesystem::create_directories(folder);
  std::vector<std::string> problems;
  std::vector<DrawnGroup> drawn_groups;
  for (const FigureGroup& group : figures_of(entries)) {
    DrawnGroup drawn{group.heading, {}};
    for (const Figure& figure : group.figures) {
      drawn.figures.push_back(
          draw(figure, folder / "figures" / group.folder, gnuplot));
      if (!drawn.figures.back().problem.empty())
        problems.push_back(
            fmt::format("{}: {}", figure.name, drawn.figures.back().problem));
    }
    drawn_groups.push_back(std::move(drawn));
  }
  if (entries.size() == 1)
    write_file_atomically(
        folder / "summary.json",
        summary_json(entries.front().summary,
                     warnings_of(*entries.front().result,
                                 *entries.front().contact_case)));
  write_file_atomically(folder / "report.html",
                        html_page(entries, drawn_groups));
  return problems;
}

} // namespace asperity::reports
