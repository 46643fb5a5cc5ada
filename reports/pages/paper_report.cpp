#include "reports/pages/paper_report.hpp"

#include "base/atomic_file.hpp"
#include "base/json.hpp"
#include "base/shown_number.hpp"
#include "reports/analysis/claims.hpp"
#include "reports/analysis/judgement.hpp"
#include "reports/analysis/verdict.hpp"
#include "reports/figures/figures.hpp"
#include "reports/pages/page_data.hpp"
#include "reports/pages/published_json.hpp"
#include "reports/pages/readme_text.hpp"
#include "reports/report_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace asperity::reports {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

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

Json links_of(const Section& section, const fs::path& folder) {
  Json links = Json::array();
  for (const PaperPart* part : section.parts)
    links.push_back({{"name", part->name},
                     {"hash", part->entry.summary.case_hash.substr(0, 12)},
                     {"target", (fs::absolute(part->folder) / "report.html")
                                    .lexically_relative(fs::absolute(folder))
                                    .generic_string()}});
  return links;
}

Json problems_of(const Section& section) {
  Json list = Json::array();
  for (const PaperPart* part : section.parts) {
    if (part->entry.summary.status != "complete")
      list.push_back(part->name + " is not complete (status: " +
                     part->entry.summary.status + ").");
    for (const MethodSummary& method : part->entry.summary.methods)
      if (method.cost.failed_steps > 0)
        list.push_back(fmt::format(
            "{}, {}: {} of {} steps did not converge.", part->name, method.name,
            method.cost.failed_steps, method.cost.steps));
  }
  return list;
}

/// The figures of the paper: "Figures 15 and 16: pressure against ..."; "" if
/// the README does not say.
std::string shown_figures(const std::string& readme) {
  for (const char* word : {"Figures", "Figure"})
    if (const std::string shown = paragraph_on(readme, word); !shown.empty())
      return fmt::format("{} {}", word, shown);
  return "";
}

/// "Figures 15 and 16", or the name of the section.
std::string head_of(const PaperPart& part) {
  const std::string shown = shown_figures(part.readme);
  const std::size_t colon = shown.find(':');
  return colon == shown.npos ? section_of(part.name) : shown.substr(0, colon);
}

Json section_data(const Section& section, const fs::path& folder,
                  const DrawnGroup& group) {
  const PaperPart& first = *section.parts.front();
  return {{"name", section.name},
          {"head", head_of(first)},
          {"shown", shown_figures(first.readme)},
          {"title", first.entry.summary.case_title},
          {"claim", paragraph_on(first.readme, "Claim")},
          {"misses", paragraph_on(first.readme, "What does not come out")},
          {"problems", problems_of(section)},
          {"figures", group_data({&group, 1}).front()["figures"]},
          {"links", links_of(section, folder)}};
}

Json part_json(const PaperPart& part) {
  const Summary& summary = part.entry.summary;
  return {{"name", part.name},
          {"title", summary.case_title},
          {"case_hash", summary.case_hash},
          {"status", summary.status},
          {"all_ok", summary.all_ok()}};
}

/// How many published numbers have each verdict.
Json counts_of(const Json& published) {
  Json counts = {{"numbers", published.size()},
                 {"reproduced", 0},
                 {"inconclusive", 0},
                 {"differs", 0},
                 {"not_reproducible", 0},
                 {"input", 0},
                 {"missing", 0}};
  for (const Json& line : published) {
    Json& count = counts[line["verdict"].get<std::string>()];
    count = count.get<int>() + 1;
  }
  return counts;
}

std::string banner_of(const Json& counts) {
  const auto n = [&](const char* verdict) {
    return counts[verdict].get<int>();
  };
  return fmt::format(
      "Of {} published numbers and claims, each compared with the method that "
      "comes nearest: reproduced {}, inconclusive because our own interval is "
      "too wide {}, different by the amount stated {}, not reproducible for "
      "the reason stated {}, set by the case or fitted to it {}, without a "
      "computed value {}.",
      n("numbers"), n("reproduced"), n("inconclusive"), n("differs"),
      n("not_reproducible"), n("input"), n("missing"));
}

/// Returns paper.json (docs/reference/results.md): the parts, their published
/// numbers in the order of their reference.csv, each beside the computed ones,
/// and the counts by the best verdict of any method.
Json paper_json(std::span<const PaperPart> parts, const std::string& title) {
  Json json = {{"format", "asperity-paper"},
               {"format_version", 1},
               {"title", title},
               {"banner", ""},
               {"counts", Json::object()},
               {"parts", Json::array()},
               {"published", Json::array()}};
  for (const PaperPart& part : parts) {
    json["parts"].push_back(part_json(part));
    for (const PublishedValue& published : part.entry.summary.published) {
      Json line = {{"part", part.name}};
      line.update(published_json(published));
      line["meaning"] = meaning_of(published.reference.quantity);
      json["published"].push_back(line);
    }
  }
  json["counts"] = counts_of(json["published"]);
  json["banner"] = banner_of(json["counts"]);
  return json;
}

/// The rows of a published number, one for each method that computes it.
Json rows_of(const Json& line, const PublishedValue& published) {
  Json rows = line["ours"];
  const std::string& unit = published.reference.unit;
  for (Json& row : rows) {
    if (!row["value"].is_number() || std::isnan(row["value"].get<double>())) {
      if (row["verdict"] == "missing")
        row["remark"] = ""; // the verdict says it
    } else {
      const int realizations = row["realizations"];
      row["remark"] =
          realizations > 1 ? fmt::format("{} realisations", realizations) : "";
      if (unit != "1")
        row["value"] = uncertain_text(row["value"], row["half_width_95"], unit);
    }
  }
  if (rows.empty()) {
    Estimate none;
    none.remark = "no method of the case computes this";
    rows.push_back(
        {{"method", "–"},
         {"value", "–"},
         {"verdict", line["verdict"]},
         {"words", compare_with_published(published.reference, none).words}});
  }
  rows.front()["is_first"] = true;
  return rows;
}

/// Adds to the published numbers of paper.json what the table of the page shows
/// of them.
void add_rows(std::span<const PaperPart> parts, Json& lines) {
  std::size_t at = 0;
  for (const PaperPart& part : parts)
    for (const PublishedValue& published : part.entry.summary.published) {
      Json& line = lines[at++];
      line["published_text"] = published_text(published.reference);
      line["section"] = section_of(part.name);
      line["shown_in"] = head_of(part);
      line["rows"] = rows_of(line, published);
      line["n_methods"] = line["rows"].size();
    }
}

Json notices_of(std::span<const PaperPart> parts) {
  Json notices = Json::array();
  if (std::ranges::any_of(parts, [](const PaperPart& part) {
        return part.entry.summary.case_title.ends_with(quick_mark);
      }))
    notices.push_back(
        "A quick run, with fewer points, loads or realisations than the cases "
        "specify. It only shows that everything works; quote the full run.");
  return notices;
}

Json facts_of(std::span<const PaperPart> parts) {
  Json facts = Json::array();
  for (const auto& [key, fact] : parts.front().entry.summary.provenance)
    if (key != "seed" && key.find("time") == std::string::npos)
      facts.push_back({{"key", key}, {"value", fact}});
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
  const std::string title =
      paragraphs.empty() ? "A collection" : paragraphs.front();
  Json page = paper_json(parts, title);
  write_file_atomically(folder / "paper.json", text_of_json(page, 2) + "\n");
  page["page_title"] = title;
  page["lead"] = paragraphs.size() > 1 ? paragraphs[1] : "";
  page["notices"] = notices_of(parts);
  add_rows(parts, page["published"]);
  page["sections"] = Json::array();
  std::vector<DrawnGroup> groups;
  for (const Section& section : sections_of(parts)) {
    groups.push_back(drawn_figures(section, folder, gnuplot, problems));
    page["sections"].push_back(section_data(section, folder, groups.back()));
  }
  page["facts"] = facts_of(parts);
  write_page(paper_template, page, groups, folder, extras.has_pdf, problems);
  return problems;
}

} // namespace asperity::reports
