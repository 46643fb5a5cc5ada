#include "mechanics/flow/reynolds.hpp"

#include "mechanics/flow/elimination.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>

namespace asperity::flow {
namespace {

/// The nodes of a map in rows along the flow: (along, across).
class Lines {
public:
  Lines(const Grid& grid, Direction direction, mechanics::Border border)
      : length(direction == Direction::x ? grid.points_x : grid.points_y),
        width(direction == Direction::x ? grid.points_y : grid.points_x),
        spacing_along(direction == Direction::x ? grid.spacing_x()
                                                : grid.spacing_y()),
        spacing_across(direction == Direction::x ? grid.spacing_y()
                                                 : grid.spacing_x()),
        stride_along_(direction == Direction::x ? 1 : grid.points_x),
        stride_across_(direction == Direction::x ? grid.points_x : 1),
        is_periodic_(border == mechanics::Border::periodic) {}

  std::size_t node(int along, int across) const {
    return static_cast<std::size_t>(along) *
               static_cast<std::size_t>(stride_along_) +
           static_cast<std::size_t>(across) *
               static_cast<std::size_t>(stride_across_);
  }

  int along(std::size_t node) const { return place(node, stride_along_); }

  int across(std::size_t node) const { return place(node, stride_across_); }

  /// Calls visit(neighbour, is_along) for the next node along the flow and for
  /// the next one across it.
  template <class Visit>
  void for_next(int along, int across, const Visit& visit) const {
    if (along + 1 < length)
      visit(node(along + 1, across), true);
    if (across + 1 < width || is_periodic_)
      visit(node(along, (across + 1) % width), false);
  }

  /// Calls visit(neighbour, is_along) for the neighbours of a node on the map.
  template <class Visit>
  void for_neighbours(int along, int across, const Visit& visit) const {
    if (along > 0)
      visit(node(along - 1, across), true);
    if (along + 1 < length)
      visit(node(along + 1, across), true);
    if (across > 0 || is_periodic_)
      visit(node(along, (across + width - 1) % width), false);
    if (across + 1 < width || is_periodic_)
      visit(node(along, (across + 1) % width), false);
  }

  int length, width;
  double spacing_along, spacing_across; ///< [m]

private:
  /// The strides are 1 and the number of points in x.
  int place(std::size_t node, int stride) const {
    const auto other =
        static_cast<std::size_t>(std::max(stride_along_, stride_across_));
    return static_cast<int>(stride == 1 ? node % other : node / other);
  }

  int stride_along_, stride_across_;
  bool is_periodic_; ///< across the flow
};

/// Sets of open nodes that are joined, and which reservoirs they reach.
class Clusters {
public:
  explicit Clusters(std::size_t nodes) : parent_(nodes), reaches_(nodes, 0) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }

  static constexpr std::uint8_t inlet = 1, outlet = 2, both = 3;

  void mark(std::size_t node, std::uint8_t reservoir) {
    std::uint8_t& flags = reaches_[root(node)];
    flags = static_cast<std::uint8_t>(flags | reservoir);
  }

  void join(std::size_t one, std::size_t other) {
    const std::uint32_t a = root(one), b = root(other);
    parent_[std::max(a, b)] = std::min(a, b);
    reaches_[std::min(a, b)] =
        static_cast<std::uint8_t>(reaches_[a] | reaches_[b]);
  }

  bool joins_reservoirs(std::size_t node) {
    return reaches_[root(node)] == both;
  }

private:
  std::uint32_t root(std::size_t node) {
    auto at = static_cast<std::uint32_t>(node);
    while (parent_[at] != at)
      at = parent_[at] = parent_[parent_[at]];
    return at;
  }

  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> reaches_;
};

/// The open nodes from the widest to the narrowest; of equal ones the first.
std::vector<std::uint32_t> by_descending_gap(std::span<const double> gap) {
  std::vector<std::uint32_t> open;
  for (std::size_t i = 0; i < gap.size(); ++i)
    if (gap[i] > 0.0)
      open.push_back(static_cast<std::uint32_t>(i));
  std::ranges::stable_sort(open, std::ranges::greater{},
                           [&](std::uint32_t node) { return gap[node]; });
  return open;
}

/// Joins the open nodes in descending order of their gap, so that the node that
/// first joins the reservoirs is the narrowest of the widest path.
/// @return  that node; gap.size() if none does
std::size_t join_open(const Lines& lines, std::span<const double> gap,
                      Clusters& clusters) {
  std::size_t critical = gap.size();
  std::vector<bool> is_joined(gap.size());
  for (const std::size_t node : by_descending_gap(gap)) {
    const int along = lines.along(node), across = lines.across(node);
    is_joined[node] = true;
    if (along == 0)
      clusters.mark(node, Clusters::inlet);
    if (along == lines.length - 1)
      clusters.mark(node, Clusters::outlet);
    lines.for_neighbours(along, across, [&](std::size_t beside, bool) {
      if (is_joined[beside])
        clusters.join(node, beside);
    });
    if (critical == gap.size() && clusters.joins_reservoirs(node))
      critical = node;
  }
  return critical;
}

/// The conductances of the faces of a map, in units of the cube of a gap.
class Conductances {
public:
  /// @param unit  [m], the gap whose conductance over a square is 1
  Conductances(const Lines& lines, std::span<const double> gap, double unit)
      : gap_(gap),
        unit_(unit),
        shape_along_(lines.spacing_across / lines.spacing_along),
        shape_across_(lines.spacing_along / lines.spacing_across) {}

  double between(std::size_t one, std::size_t other, bool is_along) const {
    const double a = cube(one), b = cube(other);
    return (is_along ? shape_along_ : shape_across_) * 2.0 * a * b / (a + b);
  }

  /// Of the half cell between a node and a reservoir.
  double to_reservoir(std::size_t node) const {
    return 2.0 * shape_along_ * cube(node);
  }

private:
  double cube(std::size_t node) const {
    const double ratio = gap_[node] / unit_;
    return ratio * ratio * ratio;
  }

  std::span<const double> gap_;
  double unit_, shape_along_, shape_across_;
};

/// The nodes that join the reservoirs, in the order of the map.
struct Path {
  std::vector<std::uint32_t> nodes; ///< of the map
  std::vector<int> row;             ///< of each node of the map; -1: none
};

Path path_of(std::size_t nodes, std::span<const double> gap,
             Clusters& clusters) {
  Path path{{}, std::vector<int>(nodes, -1)};
  for (std::size_t i = 0; i < nodes; ++i) {
    if (!(gap[i] > 0.0) || !clusters.joins_reservoirs(i))
      continue;
    path.row[i] = static_cast<int>(path.nodes.size());
    path.nodes.push_back(static_cast<std::uint32_t>(i));
  }
  return path;
}

Network network_of(const Lines& lines, const Path& path,
                   const Conductances& conductances) {
  Network network;
  network.columns.reserve(5 * path.nodes.size());
  network.values.reserve(5 * path.nodes.size());
  network.right_side.reserve(path.nodes.size());
  network.row_sizes.reserve(path.nodes.size());
  network.start.reserve(path.nodes.size());
  for (const std::size_t node : path.nodes) {
    const int along = lines.along(node), across = lines.across(node);
    const std::size_t begin = network.columns.size();
    network.columns.push_back(path.row[node]);
    network.values.push_back(0.0);
    double diagonal = 0.0, supplied = 0.0;
    if (along == 0) {
      supplied = conductances.to_reservoir(node); // P = 1 at the inlet
      diagonal += supplied;
    }
    if (along == lines.length - 1)
      diagonal += conductances.to_reservoir(node);
    lines.for_neighbours(along, across, [&](std::size_t beside, bool is_along) {
      if (path.row[beside] < 0)
        return;
      const double conductance = conductances.between(node, beside, is_along);
      diagonal += conductance;
      network.columns.push_back(path.row[beside]);
      network.values.push_back(-conductance);
    });
    network.values[begin] = diagonal;
    network.row_sizes.push_back(
        static_cast<int>(network.columns.size() - begin));
    network.right_side.push_back(supplied);
    network.start.push_back(1.0 - (along + 0.5) / lines.length);
  }
  return network;
}

/// The flow by the dissipation, and through each section.
struct Flux {
  double dissipated = 0.0;
  std::vector<double> through; ///< length + 1 sections
};

Flux flux_of(const Lines& lines, const Path& path,
             const Conductances& conductances,
             std::span<const double> potential) {
  Flux flux{0.0,
            std::vector<double>(static_cast<std::size_t>(lines.length) + 1)};
  const auto add = [&](double conductance, double drop, std::size_t section) {
    flux.dissipated += conductance * drop * drop;
    flux.through[section] += conductance * drop;
  };
  for (std::size_t i = 0; i < path.nodes.size(); ++i) {
    const std::size_t node = path.nodes[i];
    const int along = lines.along(node);
    const auto section = static_cast<std::size_t>(along);
    if (along == 0)
      add(conductances.to_reservoir(node), 1.0 - potential[i], 0);
    if (along == lines.length - 1)
      add(conductances.to_reservoir(node), potential[i], section + 1);
    lines.for_next(
        along, lines.across(node), [&](std::size_t next, bool is_along) {
          if (path.row[next] < 0)
            return;
          const double drop =
              potential[i] -
              potential[static_cast<std::size_t>(path.row[next])];
          const double conductance = conductances.between(node, next, is_along);
          if (is_along)
            add(conductance, drop, section + 1);
          else
            flux.dissipated += conductance * drop * drop;
        });
  }
  return flux;
}

/// |q| of the nodes of a path over the mean flow per width: each component is
/// the mean of the flows through the two faces of the cell.
/// @param dissipated  the flow
std::vector<double> node_flux(const Lines& lines, const Path& path,
                              const Conductances& conductances,
                              std::span<const double> potential,
                              double dissipated) {
  std::vector<double> along(path.row.size()), across(path.row.size());
  for (std::size_t i = 0; i < path.nodes.size(); ++i) {
    const std::size_t node = path.nodes[i];
    const int place = lines.along(node);
    if (place == 0)
      along[node] +=
          0.5 * conductances.to_reservoir(node) * (1.0 - potential[i]);
    if (place == lines.length - 1)
      along[node] += 0.5 * conductances.to_reservoir(node) * potential[i];
    lines.for_next(place, lines.across(node),
                   [&](std::size_t next, bool is_along) {
                     if (path.row[next] < 0)
                       return;
                     const double half =
                         0.5 * conductances.between(node, next, is_along) *
                         (potential[i] -
                          potential[static_cast<std::size_t>(path.row[next])]);
                     std::vector<double>& component = is_along ? along : across;
                     component[node] += half;
                     component[next] += half;
                   });
  }
  // Q/W over the widths of the faces.
  const double mean = dissipated / (lines.width * lines.spacing_across);
  for (const std::size_t node : path.nodes)
    along[node] = std::hypot(along[node] / lines.spacing_across,
                             across[node] / lines.spacing_along) /
                  mean;
  return along;
}

GapFlow flow_of_path(const Lines& lines, std::span<const double> gap,
                     const Path& path, const SolveNetwork& solve,
                     bool has_flux) {
  const double mean = std::accumulate(gap.begin(), gap.end(), 0.0) /
                      static_cast<double>(gap.size());
  const Conductances conductances(lines, gap, mean);
  const NetworkSolution solution =
      solved_by_elimination(network_of(lines, path, conductances), solve);
  if (!solution.converged)
    throw std::runtime_error("the flow through the gap was not found to its "
                             "tolerance");
  const Flux flux = flux_of(lines, path, conductances, solution.potential);
  const auto [least, most] = std::ranges::minmax(flux.through);
  GapFlow flow;
  flow.percolates = true;
  flow.conductance = flux.dissipated * mean * mean * mean;
  flow.flow_factor = flux.dissipated * lines.length * lines.spacing_along /
                     (lines.width * lines.spacing_across);
  flow.imbalance = (most - least) / flux.dissipated;
  flow.iterations = solution.iterations;
  if (has_flux)
    flow.flux = node_flux(lines, path, conductances, solution.potential,
                          flux.dissipated);
  return flow;
}

} // namespace

GapFlow flow_through(const Grid& grid, std::span<const double> gap,
                     Direction direction, mechanics::Border border,
                     const SolveNetwork& solve, bool has_flux) {
  if (gap.size() != grid.size())
    throw std::domain_error("flow_through: the gap does not have the size of "
                            "the grid");
  if (grid.points_x < 3 || grid.points_y < 3)
    throw std::domain_error("flow_through: a grid has at least 3 points per "
                            "side");
  const Lines lines(grid, direction, border);
  Clusters clusters(gap.size());
  const std::size_t critical = join_open(lines, gap, clusters);
  if (critical == gap.size())
    return {};
  GapFlow flow = flow_of_path(lines, gap, path_of(gap.size(), gap, clusters),
                              solve, has_flux);
  const auto width = static_cast<std::size_t>(grid.points_x);
  flow.critical_gap = gap[critical];
  flow.critical_x = static_cast<int>(critical % width);
  flow.critical_y = static_cast<int>(critical / width);
  return flow;
}

} // namespace asperity::flow
