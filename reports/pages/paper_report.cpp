#include "reports/pages/paper_report.hpp"

#include "base/atomic_file.hpp"
#include "reports/figures/figures.hpp"
#include "reports/pages/page_data.hpp"
#include "reports/pages/paper_table.hpp"
#include "reports/pages/pdf_page.hpp"
#include "reports/pages/readme_text.hpp"
#include "reports/report_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace asperity::reports {
namespace {

namespace fs = std::filesystem;
using Value = kainjow::mustache::data;
using List = kainjow::mustache::list;

/// The parts that form one section. Sections are in the order of their first
/// parts.
struct Section {
  std::string name;
  std::vector<const PaperPart*> parts;
};

std::vector<Section> sections_of(std::span<const PaperPart> parts) {
  std::vector<Section> sections;
  for (const PaperPart& part : parts) {
    const std::string name = section_of(part.name);
    const auto found =
        std::find_if(sections.begin(), sections.end(),
                     [&](const Section& s) { return s.name == name; });
    if (found == sections.end())
      sections.push_back({name, {&part}});
    else
      found->parts.push_back(&part);
  }
  return sections;
}

std::string text_of_picture(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

DrawnFigure already_drawn(const Figure& figure, const fs::path& folder) {
  DrawnFigure drawn{figure.name, figure.title, figure.caption,
                    text_of_picture(folder / (figure.name + ".svg")), ""};
  if (drawn.svg.empty())
    drawn.problem = "the report of the part does not contain this figure";
  else
    drawn.explore = explore_data(figure);
  return drawn;
}

// Draws the figures of a section that have this name, one for each result. The
// figure of a single part was drawn by its own report.
std::vector<DrawnFigure> figures_called(const std::string& name,
                                        const Section& section,
                                        std::span<const FigureGroup> groups,
                                        const fs::path& folder,
                                        const std::string& gnuplot) {
  const PaperPart& first = *section.parts.front();
  std::vector<DrawnFigure> drawn;
  for (const FigureGroup& group : groups)
    for (const Figure& figure : group.figures)
      if (figure.name == name)
        drawn.push_back(
            section.parts.size() == 1
                ? already_drawn(figure, first.folder / "figures" / group.folder)
                : draw(figure, folder / "figures" / section.name / group.folder,
                       gnuplot));
  if (drawn.empty())
    drawn.push_back({name, name, "", "", "this result has no such figure"});
  return drawn;
}

// Returns the figures that collection.toml names for the first part, in its
// order.
DrawnGroup drawn_figures(const Section& section, const fs::path& folder,
                         const std::string& gnuplot,
                         std::vector<std::string>& problems) {
  std::vector<ReportEntry> entries;
  for (const PaperPart* part : section.parts)
    entries.push_back(part->entry);
  const std::vector<FigureGroup> groups = figures_of(entries);
  DrawnGroup shown;
  for (const std::string& name : section.parts.front()->figures)
    for (DrawnFigure& figure :
         figures_called(name, section, groups, folder, gnuplot)) {
      if (!figure.problem.empty())
        problems.push_back(fmt::format("{}: {}", name, figure.problem));
      shown.figures.push_back(std::move(figure));
    }
  return shown;
}

List links_of(const Section& section, const fs::path& folder) {
  List links;
  for (const PaperPart* part : section.parts) {
    Value link;
    link.set("name", part->name);
    link.set("hash", part->entry.summary.case_hash.substr(0, 12));
    link.set("target", (fs::absolute(part->folder) / "report.html")
                           .lexically_relative(fs::absolute(folder))
                           .generic_string());
    links.push_back(link);
  }
  return links;
}

List problems_of(const Section& section) {
  List list;
  for (const PaperPart* part : section.parts) {
    if (part->entry.summary.status != "complete")
      list.push_back(text_item(part->name + " is not complete (status: " +
                               part->entry.summary.status + ")."));
    for (const MethodSummary& method : part->entry.summary.methods)
      if (method.cost.failed_steps > 0)
        list.push_back(text_item(fmt::format(
            "{}, {}: {} of {} steps did not converge.", part->name, method.name,
            method.cost.failed_steps, method.cost.steps)));
  }
  return list;
}

Value section_data(const Section& section, const fs::path& folder,
                   const DrawnGroup& group) {
  const PaperPart& first = *section.parts.front();
  Value value;
  value.set("name", section.name);
  value.set("title", first.entry.summary.case_title);
  value.set("claim", paragraph_on(first.readme, "Claim"));
  if (const std::string misses =
          paragraph_on(first.readme, "What does not come out");
      !misses.empty())
    value.set("misses", misses);
  value.set("problems", problems_of(section));
  const List groups = group_data({&group, 1});
  value.set("figures", *groups.front().get("figures"));
  value.set("links", links_of(section, folder));
  return value;
}

List notices_of(std::span<const PaperPart> parts) {
  List notices;
  const bool is_quick =
      std::any_of(parts.begin(), parts.end(), [](const PaperPart& part) {
        return part.entry.summary.case_title.ends_with(quick_mark);
      });
  if (is_quick)
    notices.push_back(text_item(
        "A quick run, with fewer points, loads or realisations than the cases "
        "specify. It only shows that everything works; quote the full run."));
  return notices;
}

List facts_of(std::span<const PaperPart> parts) {
  List facts;
  for (const auto& [key, fact] : parts.front().entry.summary.provenance)
    if (key != "seed" && key.find("time") == std::string::npos) {
      Value value;
      value.set("key", key);
      value.set("fact", fact);
      facts.push_back(value);
    }
  return facts;
}

} // namespace

std::string section_of(const std::string& part_name) {
  const std::size_t end = part_name.find_last_not_of("0123456789");
  const bool is_one_of_several = end != std::string::npos && end > 0 &&
                                 end + 1 < part_name.size() &&
                                 part_name[end] == '-';
  return is_one_of_several ? part_name.substr(0, end) : part_name;
}

std::vector<std::string> write_paper_report(std::span<const PaperPart> parts,
                                            const std::string& readme,
                                            const fs::path& folder,
                                            const ReportExtras& extras,
                                            const std::string& gnuplot) {
  if (parts.empty())
    return {};
  fs::create_directories(folder);
  std::vector<std::string> problems;
  const std::vector<std::string> paragraphs = plain_paragraphs(readme);
  Value page;
  const std::string title =
      paragraphs.empty() ? "A collection" : paragraphs.front();
  page.set("title", title);
  page.set("page_title", title);
  List lead;
  for (std::size_t i = 1; i < std::min<std::size_t>(paragraphs.size(), 2); ++i)
    lead.push_back(text_item(paragraphs[i]));
  page.set("lead", lead);
  page.set("notices", notices_of(parts));
  const PaperTable table = paper_table(parts);
  write_file_atomically(folder / "paper.json", paper_json(parts, table, title));
  page.set("banner", table.banner());
  List rows;
  for (const PaperRow& row : table.rows)
    rows.push_back(row_data(row));
  page.set("rows", rows);
  List sections;
  std::vector<DrawnGroup> groups;
  for (const Section& section : sections_of(parts)) {
    groups.push_back(drawn_figures(section, folder, gnuplot, problems));
    sections.push_back(section_data(section, folder, groups.back()));
  }
  page.set("sections", sections);
  page.set("facts", facts_of(parts));
  const auto text = [&](bool is_for_print) {
    set_scripts(page, groups, is_for_print);
    return rendered_page(paper_template, page);
  };
  write_file_atomically(folder / "report.html", text(false));
  if (extras.has_pdf)
    if (const std::string problem = print_report(text(true), folder);
        !problem.empty())
      problems.push_back(problem);
  return problems;
}

} // namespace asperity::reports
