#include "studies/spots/spots.hpp"

#include "input/reader/bound_key.hpp"
#include "results/observables/clusters.hpp"
#include "studies/key_checks.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

namespace asperity::studies {
namespace {

using cases::between;
using cases::Case;
using cases::key;
using cases::TableReader;
using Spots = SpotsStudy;

/// Their numbers are of the user's map.
void evaluate_spots(const Step& step, results::CurvePoint& row) {
  const Grid& grid = step.grid;
  const results::SurfaceRecord& pressed = step.surface.record;
  const auto numbers_of = [&](const std::vector<std::uint8_t>& set) {
    return results::cluster_numbers(
        results::find_clusters(grid, set, step.method.border(),
                               pressed.map.on(pressed.grid, grid)),
        static_cast<std::size_t>(
            step.contact_case.study<SpotsStudy>()->smallest));
  };
  const results::ClusterNumbers spots = numbers_of(step.nodes.contact_set());
  const results::ClusterNumbers gaps = numbers_of(step.nodes.open_set());
  row[columns::spot_count] = spots.count;
  row[columns::largest_spot] = spots.largest;
  row[columns::spot_dimension] = spots.dimension;
  row[columns::spots_percolate.x] = spots.percolates_x ? 1.0 : 0.0;
  row[columns::spots_percolate.y] = spots.percolates_y ? 1.0 : 0.0;
  row[columns::spot_radii] = spots.radii / grid.area();
  row[columns::gap_count] = gaps.count;
  row[columns::largest_gap] = gaps.largest;
  row[columns::gap_dimension] = gaps.dimension;
  row[columns::gap_percolates.x] = gaps.percolates_x ? 1.0 : 0.0;
  row[columns::gap_percolates.y] = gaps.percolates_y ? 1.0 : 0.0;
}

cases::Table keys_of_spots() {
  return {
      .name = "spots",
      .when = "Optional; needs a method with a contact map.",
      .description =
          "The spots of contact of each load step, and the connected parts of "
          "its gap (docs/numerics/conductance.md): their number, the largest, "
          "whether they percolate, and the dimension by area and perimeter.",
      .keys = {
          key<&Spots::smallest>(
              "smallest", between(1, 1000000),
              "Nodes of the smallest cluster that counts in a dimension."),
      }};
}

void read_spots(TableReader table, Case& read) {
  SpotsStudy study;
  table.read(study);
  require_fields(table, read, "contact map");
  read.studies.ask(study);
}

std::string spots_key(const cases::Case& contact_case) {
  return fmt::format("\nspots {}", contact_case.study<SpotsStudy>()->smallest);
}

const cases::StudyKeys& spots_keys() {
  static const cases::StudyKeys keys{
      .tables = {keys_of_spots()},
      .read = read_spots,
      .is_asked = asks<SpotsStudy>,
      .questions = {{"[spots]",
                     {"spot_count", "largest_spot", "spots_percolate_x",
                      "spots_percolate_y", "spot_radii", "gap_count",
                      "largest_gap", "gap_percolates_x", "gap_percolates_y"},
                     asks<SpotsStudy>,
                     cases::no_map}},
      .step_key = spots_key};
  return keys;
}

} // namespace

const Study spots_study{.keys = spots_keys,
                        .pages = spots_pages,
                        .evaluate = evaluate_spots,
                        .memory = 150.0};

} // namespace asperity::studies
