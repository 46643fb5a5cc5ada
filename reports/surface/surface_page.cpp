#include "reports/surface/surface_page.hpp"

#include "base/atomic_file.hpp"
#include "base/json.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/pages/page_data.hpp"
#include "reports/pages/pdf_page.hpp"
#include "reports/report_template.hpp"
#include "reports/surface/surface_figures.hpp"
#include "reports/surface/surface_json.hpp"
#include "reports/surface/surface_quantities.hpp"
#include "reports/surface/surface_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <kainjow/mustache.hpp>
#include <utility>

namespace asperity::reports {
namespace {

using Value = kainjow::mustache::data;
using List = kainjow::mustache::list;

List quantity_rows(const std::vector<SurfaceQuantity>& quantities) {
  List rows;
  for (const SurfaceQuantity& quantity : quantities) {
    Value row;
    row.set("symbol", quantity.symbol);
    row.set("meaning", quantity.meaning);
    row.set("nodes", quantity_text(quantity.by_nodes, quantity.unit));
    row.set("spectrum", std::isfinite(quantity.by_spectrum)
                            ? quantity_text(quantity.by_spectrum, quantity.unit)
                            : "");
    rows.push_back(row);
  }
  return rows;
}

std::string interval_text(const FittedQuantity& quantity) {
  const surfaces::FittedParameter& fitted = quantity.parameter;
  if (!std::isfinite(fitted.value))
    return fitted_text(quantity);
  if (!std::isfinite(fitted.low))
    return fitted.reason;
  return fmt::format(
      "{} to {}{}", quantity_text(fitted.low, quantity.unit),
      quantity_text(fitted.high, quantity.unit),
      fitted.reason.empty() ? "" : fmt::format(" ({})", fitted.reason));
}

List fit_data(const surfaces::SelfAffineFit& fit) {
  List rows;
  for (const FittedQuantity& quantity : quantities_of(fit)) {
    const surfaces::FittedParameter& fitted = quantity.parameter;
    const bool has_value = std::isfinite(fitted.value);
    Value row;
    row.set("symbol", quantity.symbol);
    row.set("meaning", quantity.meaning);
    row.set("value",
            has_value ? quantity_text(fitted.value, quantity.unit) : "–");
    row.set("interval", interval_text(quantity));
    // A wavevector is easier to imagine as a wavelength.
    row.set("wavelength",
            quantity.unit == "1/m" && has_value
                ? quantity_text(2.0 * std::acos(-1.0) / fitted.value, "m")
                : "");
    rows.push_back(row);
  }
  return rows;
}

Value part_data(const surfaces::MapAnalysis& map) {
  Value part;
  part.set("name", map.name);
  part.set("sentence",
           fmt::format("{} × {} points over {} × {}. {}", map.map.grid.points_x,
                       map.map.grid.points_y,
                       quantity_text(map.map.grid.length_x, "m"),
                       quantity_text(map.map.grid.length_y, "m"), map.origin));
  List warnings;
  for (const std::string& warning : map.warnings)
    warnings.push_back(text_item(warning));
  part.set("warnings", warnings);
  part.set("range", range_text(map));
  part.set("quantities", quantity_rows(quantities_of(map)));
  part.set("has_spectrum", true);
  part.set("has_fit", map.fit.has_value());
  if (map.fit) {
    part.set("fit", fit_data(*map.fit));
    part.set("dispersion", fmt::format("{:.2g}", map.fit->dispersion));
    part.set("scatter",
             map.fit->is_model
                 ? "where this exceeds 1, the 95 % intervals are widened by "
                   "its root"
                 : "the model allows for less, so that no intervals are "
                   "stated");
  }
  return part;
}

Value part_data(const surfaces::LineAnalysis& line) {
  Value part;
  part.set("name", line.name);
  part.set("sentence",
           fmt::format("{} points over {}. {}", line.line.heights.size(),
                       quantity_text(line.line.length(), "m"), line.origin));
  part.set("range", range_text(line));
  part.set("quantities", quantity_rows(quantities_of(line)));
  part.set("has_spectrum", false);
  part.set("has_fit", false);
  return part;
}

std::vector<FigureGroup> figure_groups(const SurfaceReport& report) {
  std::vector<FigureGroup> groups;
  const bool has_many = report.parts() > 1;
  if (has_many)
    groups.push_back({"All measurements", "", {stitched_figure(report)}});
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

std::string surface_page(const SurfaceReport& report,
                         const std::vector<DrawnGroup>& groups,
                         bool is_for_print) {
  Value page;
  page.set("title", report.title);
  page.set("page_title", report.title);
  List parts;
  for (const surfaces::MapAnalysis& map : report.maps)
    parts.push_back(part_data(map));
  for (const surfaces::LineAnalysis& line : report.lines)
    parts.push_back(part_data(line));
  const bool has_many = report.parts() > 1;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].set("anchor", fmt::format("part-{}", i + 1));
    parts[i].set("label", has_many ? report.name_of(i) : "Parameters");
  }
  page.set("parts", parts);
  page.set("is_one_of_many", has_many);
  List notes;
  for (const std::string& note : stitching_notes(report))
    notes.push_back(text_item(note));
  page.set("notes", notes);
  set_figures(page, groups, is_for_print);
  return rendered_page(surface_template, std::move(page));
}

} // namespace

std::vector<std::string>
write_surface_report(const SurfaceReport& report,
                     const std::filesystem::path& folder,
                     const ReportExtras& extras) {
  std::filesystem::create_directories(folder);
  write_file_atomically(folder / "spectrum.txt", spectrum_text(report));
  write_file_atomically(folder / "surface.json",
                        text_of_json(surface_json(report), 1) + "\n");
  std::vector<std::string> problems;
  const std::vector<DrawnGroup> groups = drawn_groups_of(
      figure_groups(report), folder, "gnuplot", extras.journal, problems);
  write_file_atomically(folder / "report.html",
                        surface_page(report, groups, false));
  if (extras.has_pdf)
    if (const std::string problem =
            print_report(surface_page(report, groups, true), folder);
        !problem.empty())
      problems.push_back(problem);
  return problems;
}

} // namespace asperity::reports
