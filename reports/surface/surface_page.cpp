#include "reports/surface/surface_page.hpp"

#include "base/atomic_file.hpp"
#include "base/json.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/pages/page_data.hpp"
#include "reports/report_template.hpp"
#include "reports/surface/surface_figures.hpp"
#include "reports/surface/surface_quantities.hpp"

#include <fmt/format.h>

#include <utility>

namespace asperity::reports {
namespace {

using Json = nlohmann::ordered_json;

/// The tables of a map or line in their order, and a sentence about it.
Json part_of(Json part, const std::string& sentence) {
  part["sentence"] = sentence;
  part["is_map"] = part.contains("self_affine");
  part["parameters"] = items_of(part["parameters"]);
  if (part.contains("self_affine") && !part["self_affine"].is_null()) {
    part["fit"] = items_of(part["self_affine"]);
    std::erase_if(part["fit"].get_ref<Json::array_t&>(),
                  [](const Json& item) { return !item.contains("symbol"); });
  }
  return part;
}

Json parts_of(const SurfaceReport& report, const Json& json) {
  Json parts = Json::array();
  for (std::size_t i = 0; i < report.maps.size(); ++i) {
    const surfaces::MapAnalysis& map = report.maps[i];
    const Grid& grid = map.map.grid;
    parts.push_back(
        part_of(json["maps"][i],
                fmt::format("{} × {} points over {} × {}. {}", grid.points_x,
                            grid.points_y, quantity_text(grid.length_x, "m"),
                            quantity_text(grid.length_y, "m"), map.origin)));
    parts.back()["fitness"] = fitness_text(map);
  }
  for (std::size_t i = 0; i < report.lines.size(); ++i) {
    const surfaces::LineAnalysis& line = report.lines[i];
    parts.push_back(part_of(
        json["lines"][i],
        fmt::format("{} points over {}. {}", line.line.heights.size(),
                    quantity_text(line.line.length(), "m"), line.origin)));
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i]["anchor"] = fmt::format("part-{}", i + 1);
    parts[i]["label"] = report.parts() > 1 ? report.name_of(i) : "Parameters";
  }
  return parts;
}

std::vector<FigureGroup> figure_groups(const SurfaceReport& report) {
  std::vector<FigureGroup> groups;
  const bool has_many = report.parts() > 1;
  if (report.contact)
    groups.push_back(
        {"Contact by theory", "", contact_figures(*report.contact)});
  const auto add = [&](std::size_t part, std::vector<Figure> figures) {
    const std::string& name = report.name_of(part);
    groups.push_back(
        {has_many ? name : "Figures",
         has_many ? fmt::format("{}-{}", part + 1, file_word(name)) : "",
         std::move(figures)});
  };
  for (std::size_t i = 0; i < report.maps.size(); ++i)
    add(i, figures_of(report.maps[i]));
  for (std::size_t i = 0; i < report.lines.size(); ++i)
    add(report.maps.size() + i, figures_of(report.lines[i]));
  return groups;
}

/// Writes the spectrum of the only map or line. One that an earlier report left
/// in the folder is not of several.
void write_spectrum(const SurfaceReport& report,
                    const std::filesystem::path& file) {
  std::filesystem::remove(file);
  const auto write = [&](const auto& part) {
    write_file_atomically(file,
                          spectrum_text(reliable_rows(part),
                                        part.name + ": " + range_text(part)));
  };
  if (report.parts() > 1)
    return;
  if (report.maps.empty())
    write(report.lines.front());
  else
    write(report.maps.front());
}

} // namespace

std::vector<std::string>
write_surface_report(const SurfaceReport& report,
                     const std::filesystem::path& folder,
                     const ReportExtras& extras) {
  std::filesystem::create_directories(folder);
  Json page = surface_json(report);
  write_spectrum(report, folder / "spectrum.txt");
  write_file_atomically(folder / "surface.json", text_of_json(page, 1) + "\n");
  std::vector<std::string> problems;
  const std::vector<DrawnGroup> groups = drawn_groups_of(
      figure_groups(report), folder, "gnuplot", extras.journal, problems);
  page["page_title"] = report.title;
  page["parts"] = parts_of(report, page);
  page["is_one_of_many"] = report.parts() > 1;
  page["groups"] = group_data(groups);
  write_page(surface_template, page, groups, folder, extras.has_pdf, problems);
  return problems;
}

} // namespace asperity::reports
