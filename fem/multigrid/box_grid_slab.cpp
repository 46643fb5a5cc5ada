#include "fem/multigrid/box_grid_slab.hpp"

#include "fem/multigrid/box_grid_levels.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace asperity::fem {
namespace {

/// With fewer rows a rank would exchange nearly as many nodes as it holds.
constexpr int fewest_rows = 4;

/// The largest share of the rows, over the mean, that is accepted for
/// boundaries that coarser grids of boxes have as well.
constexpr double most_uneven = 1.15;

int fewest_of(const std::vector<int>& bounds) {
  int fewest = bounds.back();
  for (std::size_t r = 0; r + 1 < bounds.size(); ++r)
    fewest = std::min(fewest, bounds[r + 1] - bounds[r]);
  return fewest;
}

Grid cell_columns(const BoxGrid& box_grid) {
  return {box_grid.cells_x, box_grid.cells_y, box_grid.length_x,
          box_grid.length_y};
}

} // namespace

BoxGridSlab::BoxGridSlab(const BoxGrid& box_grid)
    : SharedRows(cell_columns(box_grid)) {}

BoxGridSlab::BoxGridSlab(const BoxGrid& box_grid, RankGroup& ranks,
                         std::vector<int> bounds)
    : SharedRows(cell_columns(box_grid), ranks, std::move(bounds)) {}

NodeLayout BoxGridSlab::layout(const BoxGrid& box_grid) const {
  const bool has_next =
      box_grid.is_periodic || first() + count() < box_grid.cells_y;
  return is_shared() ? NodeLayout(box_grid, count(), has_next)
                     : NodeLayout(box_grid);
}

BoxGridAxis BoxGridSlab::axis_y(const BoxGrid& box_grid) const {
  if (!is_shared())
    return axes_of(box_grid)[1];
  BoxGridAxis axis{box_grid.degree, false, {}};
  for (int i = 0; i <= count(); ++i)
    axis.sides.push_back(box_grid.length_y * i / box_grid.cells_y);
  return axis;
}

int BoxGridSlab::rank_of(int slice, int degree) const {
  const auto after = std::upper_bound(bounds().begin() + 1, bounds().end() - 1,
                                      slice / degree);
  return static_cast<int>(after - bounds().begin()) - 1;
}

namespace {

/// Images at periodic sides have their nodes as masters; supported unknowns of
/// the far boundary have none.
UnknownConstraints constraints_of(const BoxGrid& box_grid,
                                  const BoxGridSlab& slab) {
  const NodeLayout layout = slab.layout(box_grid);
  const int degree = box_grid.degree,
            planes = static_cast<int>(layout.planes());
  UnknownConstraints found;
  const auto add = [&](int x, int y, int plane, int component) {
    const bool is_far = plane + 1 == planes;
    const bool is_held = is_far && (component == 2 ? box_grid.holds_normal
                                                   : box_grid.holds_lateral);
    const bool is_image = layout.has_image_column() && x == layout.nodes_x();
    // The image slice of a shared grid of boxes is that of another rank.
    const bool is_in_image =
        !slab.is_shared() && layout.has_image_slice() && y == layout.nodes_y();
    if (!is_held && !is_image && !is_in_image)
      return;
    if (!is_held)
      found.add_master(
          layout.index(is_image ? 0 : x, is_in_image ? 0 : y, plane, component),
          1.0);
    found.add(layout.index(x, y, plane, component));
  };
  const int last = degree * box_grid.cells_x;
  for (int y = 0; y < static_cast<int>(layout.slices()); ++y)
    for (int plane = 0; plane < planes; ++plane)
      for (int component = 0; component < 3; ++component)
        for (int line = 0; line < degree; ++line)
          for (int x = line; x <= last; x += degree)
            add(x, y, plane, component);
  return found;
}

} // namespace

UnknownLayout unknowns_of(const BoxGrid& box_grid, const BoxGridSlab& slab) {
  const NodeLayout layout = slab.layout(box_grid);
  UnknownLayout unknowns{layout.size(), layout.step(),
                         std::make_shared<const UnknownConstraints>(
                             constraints_of(box_grid, slab)),
                         nullptr};
  if (!slab.is_shared())
    return unknowns;
  std::vector<std::size_t> ghosts;
  if (layout.has_image_slice())
    ghosts.push_back(static_cast<std::size_t>(box_grid.degree *
                                              (slab.first() + slab.count()) %
                                              NodeLayout(box_grid).nodes_y()));
  unknowns.ghosts = std::make_shared<const GhostValues>(
      *slab.ranks(), static_cast<std::size_t>(layout.nodes_y()), ghosts,
      layout.slice_size());
  return unknowns;
}

SlabPlaces::SlabPlaces(const BoxGrid& box_grid, const BoxGridSlab& slab)
    : whole_(box_grid),
      own_(slab.layout(box_grid)),
      first_(box_grid.degree * slab.first()),
      is_shared_(slab.is_shared()) {}

std::size_t SlabPlaces::of(std::size_t node) const {
  const int slice = slice_of(node) - first_;
  if (slice < 0 || slice >= own_.nodes_y())
    return nowhere;
  return static_cast<std::size_t>(slice) * own_.slice_size() +
         node % whole_.slice_size();
}

std::size_t SlabPlaces::with_images(std::size_t node) const {
  const int all = whole_.nodes_y();
  const int slice = (slice_of(node) - first_ + all) % all;
  if (slice >= (is_shared_ ? static_cast<int>(own_.slices()) : all))
    return nowhere;
  return static_cast<std::size_t>(slice) * own_.slice_size() +
         node % whole_.slice_size();
}

BoxGridSlab divided(const BoxGrid& box_grid, RankGroup* ranks) {
  if (ranks == nullptr || ranks->size() == 1 ||
      box_grid.cells_y / ranks->size() < fewest_rows)
    return BoxGridSlab(box_grid);
  const int n = ranks->size();
  const int rows = box_grid.cells_y;
  const auto is_even = [&](int unit) {
    const int most = (rows / unit + n - 1) / n * unit;
    return rows % unit == 0 && most * n <= most_uneven * rows;
  };
  int unit = 1;
  while (is_even(2 * unit))
    unit *= 2;
  std::vector<int> bounds;
  for (std::int64_t r = 0; r <= n; ++r)
    bounds.push_back(unit * static_cast<int>(r * (rows / unit) / n));
  return {box_grid, *ranks, bounds};
}

BoxGridSlab coarser(const BoxGrid& box_grid, const BoxGridSlab& slab,
                    const BoxGrid& coarse) {
  if (!slab.is_shared())
    return BoxGridSlab(coarse);
  if (coarse.cells_y == box_grid.cells_y)
    return slab;
  std::vector<int> bounds = slab.bounds();
  for (int& bound : bounds) {
    if (bound % 2 != 0)
      return BoxGridSlab(coarse);
    bound /= 2;
  }
  if (fewest_of(bounds) < fewest_rows)
    return BoxGridSlab(coarse);
  return {coarse, *slab.ranks(), bounds};
}

} // namespace asperity::fem
