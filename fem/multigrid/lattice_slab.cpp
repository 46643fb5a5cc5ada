#include "fem/multigrid/lattice_slab.hpp"

#include "base/require.hpp"
#include "fem/multigrid/lattice_levels.hpp"

#include <algorithm>
#include <functional>
#include <random>
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

/// One row of every plane of a vector.
template <class Number>
std::vector<Number> row_of(const NodeLayout& layout, const Number* vector,
                           std::size_t row) {
  std::vector<Number> values;
  values.reserve(layout.planes() * layout.row_size());
  for (std::size_t plane = 0; plane < layout.planes(); ++plane) {
    const Number* const own =
        vector + plane * layout.plane_size() + row * layout.row_size();
    values.insert(values.end(), own, own + layout.row_size());
  }
  return values;
}

/// The first row becomes the image row of the previous rank.
template <class Number>
void write_shared_row(const NodeLayout& layout, const LatticeSlab& slab,
                      Number* displacement) {
  const std::vector<Number> own = row_of(layout, displacement, 0);
  std::vector<Number> next(own.size());
  slab.copy_to_previous(std::span(own), std::span(next));
  if (!layout.has_image_row())
    return;
  const std::size_t n = layout.row_size();
  for (std::size_t plane = 0; plane < layout.planes(); ++plane)
    std::copy_n(&next[plane * n], n,
                displacement + (plane + 1) * layout.plane_size() - n);
}

/// The forces on the image row are added by the next rank.
template <class Number>
void fold_shared_row(const NodeLayout& layout, const LatticeSlab& slab,
                     Number* force) {
  const std::vector<Number> own = row_of(layout, force, layout.rows() - 1);
  std::vector<Number> previous(own.size(), Number(0));
  slab.pass_to_next(std::span(own), std::span(previous));
  const std::size_t n = layout.row_size();
  for (std::size_t plane = 0; plane < layout.planes(); ++plane) {
    Number* const first = force + plane * layout.plane_size();
    for (std::size_t i = 0; i < n; ++i)
      first[i] += previous[plane * n + i];
    if (layout.has_image_row())
      std::fill_n(first + layout.plane_size() - n, n, Number(0));
  }
}

} // namespace

LatticeSlab::LatticeSlab(const BoxLattice& lattice)
    : bounds_{0, lattice.cells_y} {}

LatticeSlab::LatticeSlab(const BoxLattice& lattice, RankGroup& ranks,
                         std::vector<int> bounds)
    : ranks_(&ranks),
      bounds_(std::move(bounds)),
      own_(static_cast<std::size_t>(ranks.rank())) {
  if (bounds_.size() != static_cast<std::size_t>(ranks.size()) + 1)
    refuse_argument("bounds.size()", static_cast<double>(bounds_.size()),
                    "the number of ranks + 1");
  if (bounds_.front() != 0 || bounds_.back() != lattice.cells_y ||
      std::ranges::adjacent_find(bounds_, std::greater_equal<>()) !=
          bounds_.end())
    refuse_argument("the last of bounds", bounds_.back(),
                    "cells_y, after increasing values from 0");
  has_previous_ = lattice.is_periodic || own_ > 0;
  has_next_ = lattice.is_periodic || own_ + 2 < bounds_.size();
}

NodeLayout LatticeSlab::layout(const BoxLattice& lattice) const {
  return is_shared() ? NodeLayout(lattice, count(), has_next_)
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

int LatticeSlab::rank_of(int node_row, int degree) const {
  const auto after = std::upper_bound(bounds_.begin() + 1, bounds_.end() - 1,
                                      node_row / degree);
  return static_cast<int>(after - bounds_.begin()) - 1;
}

void LatticeSlab::sum(std::span<double> own) const {
  if (!is_shared())
    return;
  const auto n = static_cast<std::size_t>(ranks_->size());
  const std::vector<std::size_t> counts(n, own.size_bytes());
  std::vector<double> all(n * own.size());
  ranks_->gather_to_all(std::as_bytes(own), counts,
                        std::as_writable_bytes(std::span(all)));
  std::fill(own.begin(), own.end(), 0.0);
  for (std::size_t i = 0; i < all.size(); ++i)
    own[i % own.size()] += all[i];
}

SlabPlaces::SlabPlaces(const BoxLattice& lattice, const LatticeSlab& slab)
    : whole_(lattice),
      own_(slab.layout(lattice)),
      first_(lattice.degree * slab.first()) {}

int SlabPlaces::row_of(std::size_t node) const {
  return static_cast<int>(node % whole_.plane_size() / whole_.row_size());
}

std::size_t SlabPlaces::of(std::size_t node) const {
  const int row = row_of(node) - first_;
  if (row < 0 || row >= own_.nodes_y())
    return nowhere;
  return node / whole_.plane_size() * own_.plane_size() +
         static_cast<std::size_t>(row) * own_.row_size() +
         node % whole_.row_size();
}

std::size_t SlabPlaces::on_face(std::size_t node) const {
  const int rows = whole_.nodes_y();
  const int row = (row_of(node) - first_ + rows) % rows;
  if (row >= own_.face_rows())
    return nowhere;
  const std::size_t in_row = node % whole_.row_size();
  const std::size_t x = in_row % whole_.stride() * whole_.degree() +
                        in_row / whole_.stride() % whole_.degree();
  return static_cast<std::size_t>(row) *
             static_cast<std::size_t>(own_.nodes_x()) +
         x;
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

template <class Number>
void write_images(const NodeLayout& layout, const LatticeSlab& slab,
                  Number* displacement) {
  const std::size_t line = layout.degree() * layout.stride();
  const std::size_t last = layout.stride() - 1;
  if (layout.has_image_column())
    for (std::size_t plane = 0; plane < layout.planes(); ++plane) {
      Number* const first_row = displacement + plane * layout.plane_size();
      Number* const last_row =
          first_row + layout.plane_size() - layout.row_size();
      for (Number* row = first_row; row != last_row; row += line)
        row[last] = row[0];
      if (!slab.is_shared())
        std::copy_n(first_row, layout.row_size(), last_row);
    }
  if (slab.is_shared())
    write_shared_row(layout, slab, displacement);
}

template <class Number>
void fold_images(const NodeLayout& layout, const LatticeSlab& slab,
                 Number* force) {
  if (slab.is_shared())
    fold_shared_row(layout, slab, force);
  if (!layout.has_image_column())
    return;
  const std::size_t line = layout.degree() * layout.stride();
  const std::size_t last = layout.stride() - 1;
  for (std::size_t plane = 0; plane < layout.planes(); ++plane) {
    Number* const first_row = force + plane * layout.plane_size();
    Number* const last_row =
        first_row + layout.plane_size() - layout.row_size();
    if (!slab.is_shared()) {
      for (std::size_t i = 0; i < layout.row_size(); ++i)
        first_row[i] += last_row[i];
      std::fill_n(last_row, layout.row_size(), Number(0));
    }
    for (Number* row = first_row; row != last_row; row += line) {
      row[0] += row[last];
      row[last] = 0;
    }
  }
}

std::vector<float> random_displacement(const BoxLattice& lattice,
                                       const LatticeSlab& slab) {
  const NodeLayout own = slab.layout(lattice);
  const NodeLayout whole(lattice);
  const auto first = static_cast<std::size_t>(slab.first()) * own.degree();
  const auto nodes_x = static_cast<std::size_t>(own.nodes_x());
  const auto rows = static_cast<std::size_t>(own.nodes_y());
  const auto skipped = static_cast<std::size_t>(whole.nodes_y()) - rows;
  std::mt19937 engine(1);
  engine.discard(3 * nodes_x * first);
  std::vector<float> vector(own.size(), 0.0F);
  for (std::size_t plane = 0; plane < own.planes(); ++plane) {
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t line = 0; line < 3 * own.degree(); ++line) {
        // Nodes with this remainder of x / degree.
        const std::size_t nodes =
            (nodes_x + own.degree() - 1 - line % own.degree()) / own.degree();
        float* const to = &vector[plane * own.plane_size() +
                                  row * own.row_size() + line * own.stride()];
        for (std::size_t x = 0; x < nodes; ++x)
          to[x] = static_cast<float>(engine()) * 0x1p-32F - 0.5F;
      }
    engine.discard(3 * nodes_x * skipped);
  }
  return vector;
}

template void write_images(const NodeLayout&, const LatticeSlab&, float*);
template void write_images(const NodeLayout&, const LatticeSlab&, double*);
template void fold_images(const NodeLayout&, const LatticeSlab&, float*);
template void fold_images(const NodeLayout&, const LatticeSlab&, double*);

} // namespace asperity::fem
