// The figures and the answer of [spots].
#include "base/shown_number.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"
#include "results/observables/clusters.hpp"
#include "studies/answers.hpp"
#include "studies/spots/spots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace asperity::studies {

using namespace reports;

namespace {

/// The clusters of a saved map.
std::vector<results::Cluster> clusters_of(const ReportEntry& entry,
                                          const results::MethodRecord& method,
                                          const results::Fields& map,
                                          bool is_gap) {
  const mechanics::ContactCriterion criterion = contact_criterion_of(
      *entry.contact_case, method, method_scales(entry, method).rms_height);
  std::vector<std::uint8_t> set;
  set.reserve(map.grid.size());
  results::each_piece(
      std::array{map.pressure_map(), map.gap_map()},
      [&](std::size_t, const auto& values) {
        const mechanics::ContactNodes nodes(criterion, values[0], values[1]);
        std::ranges::copy(is_gap ? nodes.open_set() : nodes.contact_set(),
                          std::back_inserter(set));
      });
  const results::SurfaceRecord* const pressed =
      surface_of(*entry.result, method, 0);
  const bool has_images =
      pressed != nullptr && !pressed->map.is_whole(pressed->grid);
  return results::find_clusters(map.grid, set,
                                has_images
                                    ? results::Border::free
                                    : border_of(*entry.contact_case, method));
}

/// Adds how many clusters have at least an area, one row for each area.
void add_sizes(std::vector<results::Cluster> clusters, const std::string& label,
               CurveStyle style, ChartPanel& panel, CsvTable& table) {
  if (clusters.empty())
    return;
  std::ranges::sort(clusters, std::ranges::greater{}, &results::Cluster::area);
  const std::size_t index = panel.curves.size();
  for (std::size_t i = 0; i < clusters.size(); ++i)
    if (i + 1 == clusters.size() || clusters[i + 1].area < clusters[i].area)
      table.add(label, {static_cast<double>(index), clusters[i].area * 1e12,
                        static_cast<double>(i + 1)});
  panel.add(label, std::move(style), index, 3, 4);
}

std::vector<Figure> spot_figures(const ReportEntry& entry) {
  std::vector<Figure> figures;
  if (!asks<SpotsStudy>(*entry.contact_case))
    return figures;
  for (const results::MethodRecord* method : methods_with_maps(*entry.result)) {
    Figure figure;
    figure.name = "spots-" + file_word(method->name);
    figure.title = "Sizes of the spots of contact, " + method->name;
    figure.caption =
        "Number of clusters of at least this area, of nodes that are joined by "
        "their four neighbours, on saved maps of the first realisation: solid "
        "lines, spots of contact; dashed lines, parts of the gap.";
    CsvTable table({"clusters", "index", "area [um^2]", "number [1]"});
    ChartPanel panel;
    const std::vector<results::Fields> maps = shown_maps(*method);
    const FigureScales scales = method_scales(entry, *method);
    std::size_t load = 0;
    for (const std::size_t i : three_of(maps.size())) {
      const std::string words = load_text(scales, maps[i].nominal_pressure);
      add_sizes(clusters_of(entry, *method, maps[i], false),
                "contact, " + words, line(load_color(load), 1.6), panel, table);
      add_sizes(clusters_of(entry, *method, maps[i], true), "gap, " + words,
                line(load_color(load), 1.2, 2), panel, table);
      ++load;
    }
    if (panel.curves.empty())
      continue;
    panel.x = {.label = "area  [µm^2]", .is_log = true, .has_powers = true};
    panel.y = {.label = "number of at least this area", .is_log = true};
    figure.panels = {std::move(panel)};
    figure.data = table.text();
    figures.push_back(std::move(figure));
  }
  return figures;
}

std::string spots_answer(const ReportEntry& entry) {
  const AnsweredLoad answer = answered_load(entry, columns::spot_count);
  if (answer.method == nullptr)
    return "";
  const double count = answer.median(columns::spot_count);
  return fmt::format(
      "The contact consists of {} spot{} {}; the largest has "
      "{}.",
      digits_text(count, 7), count == 1.0 ? "" : "s", answer.place(entry),
      quantity_text(answer.median(columns::largest_spot), "m^2", 3));
}

std::vector<AnswerColumn> spot_counts(const cases::Case&) {
  return {{&columns::spot_count, "Number of spots of contact"}};
}

} // namespace

const StudyPages& spots_pages() {
  static const StudyPages pages{.name = "spots",
                                .figure_names = {"spots-"},
                                .figures = drawn_by<spot_figures>,
                                .answer = spots_answer,
                                .answer_columns = spot_counts};
  return pages;
}

} // namespace asperity::studies
