#include "results/observables/clusters.hpp"

#include "results/types/map_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asperity::results {
namespace {

/// A node, and how many periods its place on the cluster is from the map.
struct Place {
  int x = 0, y = 0;
  std::array<std::int32_t, 2> periods{};
};

/// Follows clusters from node to node.
class Search {
public:
  Search(const Grid& grid, std::span<const std::uint8_t> is_inside,
         Border border, const MapInCell& map)
      : grid_(grid),
        map_(map.grid(grid)),
        is_inside_(is_inside),
        is_periodic_(border == Border::periodic),
        is_found_(grid.size()),
        periods_(is_periodic_ ? grid.size() : 0) {}

  std::vector<Cluster> all() {
    std::vector<Cluster> clusters;
    for (int iy = 0; iy < grid_.points_y; ++iy)
      for (int ix = 0; ix < grid_.points_x; ++ix)
        if (const std::size_t i = grid_.index(ix, iy);
            is_inside_[i] != 0 && !is_found_[i])
          clusters.push_back(from({ix, iy, {}}));
    return clusters;
  }

private:
  Cluster from(const Place& first) {
    Cluster cluster;
    std::size_t on_map = 0;
    join(first);
    while (!open_.empty()) {
      const Place at = open_.back();
      open_.pop_back();
      ++cluster.nodes;
      on_map += at.x < map_.points_x && at.y < map_.points_y ? 1 : 0;
      touch_sides(at);
      visit({at.x - 1, at.y, at.periods}, grid_.spacing_y(), cluster);
      visit({at.x + 1, at.y, at.periods}, grid_.spacing_y(), cluster);
      visit({at.x, at.y - 1, at.periods}, grid_.spacing_x(), cluster);
      visit({at.x, at.y + 1, at.periods}, grid_.spacing_x(), cluster);
    }
    cluster.area = static_cast<double>(cluster.nodes) * grid_.cell_area();
    cluster.map_area = static_cast<double>(on_map) * grid_.cell_area();
    cluster.spans_x |= sides_[0] && sides_[1];
    cluster.spans_y |= sides_[2] && sides_[3];
    sides_ = {};
    return cluster;
  }

  void touch_sides(const Place& at) {
    if (is_periodic_)
      return;
    sides_[0] |= at.x == 0;
    sides_[1] |= at.x + 1 == grid_.points_x;
    sides_[2] |= at.y == 0;
    sides_[3] |= at.y + 1 == grid_.points_y;
  }

  /// Joins a neighbour, or counts the edge towards it.
  void visit(Place place, double edge, Cluster& cluster) {
    if (!is_on_map(place)) {
      cluster.perimeter += edge;
      return;
    }
    const std::size_t i = grid_.index(place.x, place.y);
    if (is_inside_[i] == 0) {
      cluster.perimeter += edge;
    } else if (!is_found_[i]) {
      join(place);
    } else if (is_periodic_) {
      cluster.spans_x |= periods_[i][0] != place.periods[0];
      cluster.spans_y |= periods_[i][1] != place.periods[1];
    }
  }

  void join(const Place& place) {
    const std::size_t i = grid_.index(place.x, place.y);
    is_found_[i] = true;
    if (is_periodic_)
      periods_[i] = place.periods;
    open_.push_back(place);
  }

  /// Brings a place across a periodic border back to the map.
  bool is_on_map(Place& place) const {
    const int around_x = place.x < 0 ? -1 : place.x >= grid_.points_x ? 1 : 0;
    const int around_y = place.y < 0 ? -1 : place.y >= grid_.points_y ? 1 : 0;
    place.x -= around_x * grid_.points_x;
    place.y -= around_y * grid_.points_y;
    place.periods[0] += around_x;
    place.periods[1] += around_y;
    return is_periodic_ || (around_x == 0 && around_y == 0);
  }

  const Grid& grid_;
  Grid map_; ///< of the user's map
  std::span<const std::uint8_t> is_inside_;
  bool is_periodic_;
  std::vector<bool> is_found_;
  std::vector<std::array<std::int32_t, 2>> periods_;
  std::vector<Place> open_; ///< joined, whose neighbours are not visited yet
  std::array<bool, 4> sides_{};
};

/// Twice the slope of ln perimeter over ln area.
double dimension_of(std::span<const Cluster> clusters, std::size_t smallest) {
  constexpr double fewest = 10.0;
  const auto counts = [&](const Cluster& cluster) {
    return cluster.nodes >= smallest && !cluster.spans_x && !cluster.spans_y;
  };
  double n = 0.0, x_sum = 0.0, y_sum = 0.0;
  for (const Cluster& cluster : clusters)
    if (counts(cluster)) {
      n += 1.0;
      x_sum += std::log(cluster.area);
      y_sum += std::log(cluster.perimeter);
    }
  double xx = 0.0, xy = 0.0;
  for (const Cluster& cluster : clusters)
    if (counts(cluster)) {
      const double x = std::log(cluster.area) - x_sum / n;
      xx += x * x;
      xy += x * (std::log(cluster.perimeter) - y_sum / n);
    }
  constexpr double least_spread = 1e-12; // of ln area: roundoff
  return n < fewest || xx < least_spread ? Observed::none : 2.0 * xy / xx;
}

} // namespace

std::vector<Cluster> find_clusters(const Grid& grid,
                                   std::span<const std::uint8_t> is_inside,
                                   Border border, const MapInCell& map) {
  require_size("is_inside", is_inside.size(), grid.size());
  return Search(grid, is_inside, border, map).all();
}

ClusterNumbers cluster_numbers(std::span<const Cluster> clusters,
                               std::size_t smallest) {
  ClusterNumbers numbers;
  for (const Cluster& cluster : clusters) {
    numbers.count += cluster.map_area > 0.0 ? 1.0 : 0.0;
    numbers.largest = std::max(numbers.largest, cluster.map_area);
    numbers.percolates_x |= cluster.spans_x;
    numbers.percolates_y |= cluster.spans_y;
    numbers.radii += std::sqrt(cluster.area / std::numbers::pi);
  }
  numbers.dimension = dimension_of(clusters, smallest);
  return numbers;
}

} // namespace asperity::results
