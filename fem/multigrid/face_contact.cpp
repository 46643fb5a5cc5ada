#include "fem/multigrid/face_contact.hpp"

#include "fem/multigrid/lattice_levels.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "ranks/value_exchange.hpp"

namespace asperity::fem {

bool FaceContact::is_free() const {
  return springs.is_empty() &&
         std::find(held.begin(), held.end(), true) == held.end();
}

template <class Number>
void FaceSprings::add_force(std::size_t first, std::size_t end,
                            const Number* displacement, Number* force) const {
  end = std::min(end, nodes());
  for (std::size_t row = first; row < end; ++row) {
    double sum = 0.0;
    for (std::size_t i = matrix->start[row]; i < matrix->start[row + 1]; ++i)
      sum += matrix->weight[i] *
             static_cast<double>(displacement[(*places)[matrix->column[i]]]);
    force[(*places)[row]] += static_cast<Number>(factor * sum);
  }
}

FaceTransfer::FaceTransfer(const BoxLattice& fine, const LatticeSlab& fine_slab,
                           const BoxLattice& coarse,
                           const LatticeSlab& coarse_slab) {
  const LatticeAxis from_x = axes_of(coarse)[0], to_x = axes_of(fine)[0];
  const auto own_rows =
      static_cast<std::size_t>(fine_slab.layout(fine).face_rows());
  const bool is_gathered = fine_slab.is_shared() && !coarse_slab.is_shared();
  const LatticeAxis from_y = coarse_slab.axis_y(coarse);
  const LatticeAxis to_y =
      is_gathered ? axes_of(fine)[1] : fine_slab.axis_y(fine);
  const std::size_t first =
      is_gathered ? to_y.degree * static_cast<std::size_t>(fine_slab.first())
                  : 0;
  if (is_gathered)
    ranks_ = fine_slab.ranks();
  fine_nodes_x_ = to_x.nodes();
  coarse_size_ = from_x.nodes() * from_y.nodes();
  interpolation_ =
      tensor_product(some_rows(interpolation(from_y, to_y), first, own_rows),
                     interpolation(from_x, to_x), from_x.nodes());
  transposed_ = transposed(interpolation_, coarse_size_);
  for (const std::size_t node : nearest_fine(from_x, to_x))
    nearest_[0].emplace_back(node);
  for (const std::size_t node : nearest_fine(from_y, to_y)) {
    auto& own = nearest_[1].emplace_back();
    if (node >= first && node < first + own_rows)
      own = node - first;
  }
}

FaceContact FaceTransfer::coarse(const FaceContact& fine) const {
  FaceContact result;
  if (!fine.springs.is_empty())
    result.springs = product(
        transposed_, product(fine.springs, interpolation_, coarse_size_),
        coarse_size_);
  result.is_sticking = fine.is_sticking;
  if (!fine.held.empty())
    for (const auto& y : nearest_[1])
      for (const auto& x : nearest_[0])
        result.held.push_back(y && fine.held[*y * fine_nodes_x_ + *x]);
  if (ranks_ != nullptr)
    gather(result);
  return result;
}

/// Adds the springs of all ranks and holds what any of them holds.
void FaceTransfer::gather(FaceContact& contact) const {
  struct Entry {
    std::uint64_t row, column;
    double weight;
  };

  std::vector<Entry> own;
  for (std::size_t row = 0; row < contact.springs.rows(); ++row)
    for (std::size_t i = contact.springs.start[row];
         i < contact.springs.start[row + 1]; ++i)
      own.push_back(
          {row, contact.springs.column[i], contact.springs.weight[i]});
  const ValueExchange entries(*ranks_, own.size());
  std::vector<Entry> all = entries.sent(std::span<const Entry>(own));
  std::ranges::stable_sort(all, {}, [](const Entry& entry) {
    return std::pair(entry.row, entry.column);
  });
  contact.springs = {};
  SparseRows& sum = contact.springs;
  for (const Entry& entry : all) {
    while (sum.rows() <= entry.row)
      sum.start.push_back(sum.column.size());
    const bool is_new = sum.start.back() == sum.start[sum.rows() - 1] ||
                        sum.column.back() != entry.column;
    if (is_new) {
      sum.column.push_back(entry.column);
      sum.weight.push_back(0.0);
      ++sum.start.back();
    }
    sum.weight.back() += entry.weight;
  }
  while (!all.empty() && sum.rows() < coarse_size_)
    sum.start.push_back(sum.column.size());
  if (contact.held.empty())
    return;
  std::vector<std::uint8_t> flags(contact.held.begin(), contact.held.end());
  const ValueExchange held(*ranks_, flags.size());
  flags = held.sent(std::span<const std::uint8_t>(flags));
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i] != 0)
      contact.held[i % coarse_size_] = true;
}

void fold_face_row(const NodeLayout& layout, const LatticeSlab& slab,
                   std::vector<double>& nodes) {
  if (!slab.is_shared())
    return;
  const auto n = static_cast<std::size_t>(layout.nodes_x());
  std::vector<double> previous(n, 0.0);
  slab.pass_to_next(std::span<const double>(nodes).last(n),
                    std::span(previous));
  for (std::size_t i = 0; i < n; ++i)
    nodes[i] += previous[i];
}

void share_held(const NodeLayout& layout, const LatticeSlab& slab,
                FaceContact& contact) {
  if (!slab.is_shared())
    return;
  if (slab.sum(contact.held.empty() ? 0.0 : 1.0) == 0.0)
    return;
  const auto n = static_cast<std::size_t>(layout.nodes_x());
  contact.held.resize(n * static_cast<std::size_t>(layout.face_rows()), false);
  std::vector<std::uint8_t> own(contact.held.begin(),
                                contact.held.begin() +
                                    static_cast<std::ptrdiff_t>(n));
  std::vector<std::uint8_t> next(n, 0);
  slab.copy_to_previous(std::span<const std::uint8_t>(own), std::span(next));
  if (layout.has_image_row())
    for (std::size_t i = 0; i < n; ++i)
      contact.held[contact.held.size() - n + i] = next[i] != 0;
}

std::vector<std::size_t> face_places(const NodeLayout& layout, int component) {
  std::vector<std::size_t> places;
  for (int y = 0; y < layout.face_rows(); ++y)
    for (int x = 0; x < layout.nodes_x(); ++x)
      places.push_back(layout.index(x, y, 0, component));
  return places;
}

std::vector<std::size_t> held_places(const NodeLayout& layout,
                                     const FaceContact& contact) {
  std::vector<std::size_t> held;
  for (int component = contact.is_sticking ? 0 : 2; component < 3;
       ++component) {
    const std::vector<std::size_t> places = face_places(layout, component);
    for (std::size_t node = 0; node < contact.held.size(); ++node)
      if (contact.held[node])
        held.push_back(places[node]);
  }
  return held;
}

template <class Number>
void clear_far_boundary(const BoxLattice& lattice, const NodeLayout& layout,
                        Number* vector) {
  const std::size_t line = layout.degree() * layout.stride();
  Number* const far = vector + layout.used() - layout.plane_size();
  for (std::size_t y = 0; y < layout.rows(); ++y)
    for (std::size_t c = 0; c < 3; ++c)
      if (c == 2 ? lattice.holds_normal : lattice.holds_lateral)
        std::fill_n(far + y * layout.row_size() + c * line, line, Number(0));
}

template void FaceSprings::add_force(std::size_t, std::size_t, const float*,
                                     float*) const;
template void FaceSprings::add_force(std::size_t, std::size_t, const double*,
                                     double*) const;
template void clear_far_boundary(const BoxLattice&, const NodeLayout&, float*);
template void clear_far_boundary(const BoxLattice&, const NodeLayout&, double*);

} // namespace asperity::fem
