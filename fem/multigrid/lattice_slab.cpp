#include "fem/multigrid/lattice_slab.hpp"

#include "fem/multigrid/lattice_levels.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace asperity::fem {
namespace {

/// With fewer rows a rank would exchange nearly as many nodes as it holds.
constexpr int fewest_rows = 4;

/// The largest share of the rows, over the mean, that is accepted for
/// boundaries that coarser lattices have as well.
constexpr double most_uneven = 1.15;

int fewest_of(const std::vector<int>& bounds) {
  int fewest = bounds.back();
  for (std::size_t r = 0; r + 1 < bounds.size(); ++r)
    fewest = std::min(fewest, bounds[r + 1] - bounds[r]);
  return fewest;
}

Grid cell_columns(const BoxLattice& lattice) {
  return {lattice.cells_x, lattice.cells_y, lattice.length_x, lattice.length_y};
}

} // namespace

LatticeSlab::LatticeSlab(const BoxLattice& lattice)
    : SharedRows(cell_columns(lattice)) {}

LatticeSlab::LatticeSlab(const BoxLattice& lattice, RankGroup& ranks,
                         std::vector<int> bounds)
    : SharedRows(cell_columns(lattice), ranks, std::move(bounds)) {}

NodeLayout LatticeSlab::layout(const BoxLattice& lattice) const {
  const bool has_next =
      lattice.is_periodic || first() + count() < lattice.cells_y;
  return is_shared() ? NodeLayout(lattice, count(), has_next)
                     : NodeLayout(lattice);
}

LatticeAxis LatticeSlab::axis_y(const BoxLattice& lattice) const {
  if (!is_shared())
    return axes_of(lattice)[1];
  LatticeAxis axis{lattice.degree, false, {}};
  for (int i = 0; i <= count(); ++i)
    axis.sides.push_back(lattice.length_y * i / lattice.cells_y);
  return axis;
}

int LatticeSlab::rank_of(int slice, int degree) const {
  const auto after = std::upper_bound(bounds().begin() + 1, bounds().end() - 1,
                                      slice / degree);
  return static_cast<int>(after - bounds().begin()) - 1;
}

namespace {

/// Images at periodic sides have their nodes as masters; supported unknowns of
/// the far boundary have none.
UnknownConstraints constraints_of(const BoxLattice& lattice,
                                  const LatticeSlab& slab) {
  const NodeLayout layout = slab.layout(lattice);
  const int degree = lattice.degree, planes = static_cast<int>(layout.planes());
  UnknownConstraints found;
  const auto add = [&](int x, int y, int plane, int component) {
    const bool is_far = plane + 1 == planes;
    const bool is_held = is_far && (component == 2 ? lattice.holds_normal
                                                   : lattice.holds_lateral);
    const bool is_image = layout.has_image_column() && x == layout.nodes_x();
    // The image slice of a shared lattice is that of another rank.
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
  const int last = degree * lattice.cells_x;
  for (int y = 0; y < static_cast<int>(layout.slices()); ++y)
    for (int plane = 0; plane < planes; ++plane)
      for (int component = 0; component < 3; ++component)
        for (int line = 0; line < degree; ++line)
          for (int x = line; x <= last; x += degree)
            add(x, y, plane, component);
  return found;
}

} // namespace

UnknownLayout unknowns_of(const BoxLattice& lattice, const LatticeSlab& slab) {
  const NodeLayout layout = slab.layout(lattice);
  UnknownLayout unknowns{
      layout.size(), layout.step(),
      std::make_shared<const UnknownConstraints>(constraints_of(lattice, slab)),
      nullptr};
  if (!slab.is_shared())
    return unknowns;
  std::vector<std::size_t> ghosts;
  if (layout.has_image_slice())
    ghosts.push_back(static_cast<std::size_t>(lattice.degree *
                                              (slab.first() + slab.count()) %
                                              NodeLayout(lattice).nodes_y()));
  unknowns.ghosts = std::make_shared<const GhostValues>(
      *slab.ranks(), static_cast<std::size_t>(layout.nodes_y()), ghosts,
      layout.slice_size());
  return unknowns;
}

SlabPlaces::SlabPlaces(const BoxLattice& lattice, const LatticeSlab& slab)
    : whole_(lattice),
      own_(slab.layout(lattice)),
      first_(lattice.degree * slab.first()),
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

LatticeSlab divided(const BoxLattice& lattice, RankGroup* ranks) {
  if (ranks == nullptr || ranks->size() == 1 ||
      lattice.cells_y / ranks->size() < fewest_rows)
    return LatticeSlab(lattice);
  const int n = ranks->size();
  const int rows = lattice.cells_y;
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
  return {lattice, *ranks, bounds};
}

LatticeSlab coarser(const BoxLattice& lattice, const LatticeSlab& slab,
                    const BoxLattice& coarse) {
  if (!slab.is_shared())
    return LatticeSlab(coarse);
  if (coarse.cells_y == lattice.cells_y)
    return slab;
  std::vector<int> bounds = slab.bounds();
  for (int& bound : bounds) {
    if (bound % 2 != 0)
      return LatticeSlab(coarse);
    bound /= 2;
  }
  if (fewest_of(bounds) < fewest_rows)
    return LatticeSlab(coarse);
  return {coarse, *slab.ranks(), bounds};
}

} // namespace asperity::fem
