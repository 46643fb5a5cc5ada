#include "reports/report.hpp"

#include "base/atomic_file.hpp"
#include "reports/figures.hpp"
#include "reports/html_report.hpp"
#include "reports/verdict.hpp"

#include <fmt/format.h>

namespace asperity::reports {

ReportEntry entry_of(const results::Result& result,
                     const cases::Case& contact_case) {
  return {&result, &contact_case, summarize(result, contact_case)};
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
    write_file_atomically(folder / "summary.json",
                          summary_json(entries.front().summary));
  write_file_atomically(folder / "report.html",
                        html_page(entries, drawn_groups));
  return problems;
}

} // namespace asperity::reports
