#include "studies/spots/spots.hpp"

#include "results/observables/clusters.hpp"
#include "studies/spots/spots_study.hpp"

#include <cstdint>
#include <vector>

namespace asperity::studies {
namespace {

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
  row[columns::spots_percolate_x] = spots.percolates_x ? 1.0 : 0.0;
  row[columns::spots_percolate_y] = spots.percolates_y ? 1.0 : 0.0;
  row[columns::spot_radii] = spots.radii / grid.area();
  row[columns::gap_count] = gaps.count;
  row[columns::largest_gap] = gaps.largest;
  row[columns::gap_dimension] = gaps.dimension;
  row[columns::gap_percolates_x] = gaps.percolates_x ? 1.0 : 0.0;
  row[columns::gap_percolates_y] = gaps.percolates_y ? 1.0 : 0.0;
}

} // namespace

const Study spots_study{.keys = spots_keys,
                        .pages = spots_pages,
                        .evaluate = evaluate_spots,
                        .memory = 150.0};

} // namespace asperity::studies
