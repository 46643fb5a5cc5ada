#include "fem/multigrid/face_contact.hpp"

#include "fem/multigrid/lattice_levels.hpp"

#include <algorithm>

namespace asperity::fem {

bool FaceContact::is_free() const {
  return springs.is_empty() &&
         std::find(held.begin(), held.end(), true) == held.end();
}

FaceTransfer::FaceTransfer(const BoxLattice& fine, const BoxLattice& coarse) {
  const auto from = axes_of(coarse);
  const auto to = axes_of(fine);
  fine_nodes_x_ = to[0].nodes();
  coarse_size_ = from[0].nodes() * from[1].nodes();
  interpolation_ =
      tensor_product(interpolation(from[1], to[1]),
                     interpolation(from[0], to[0]), from[0].nodes());
  transposed_ = transposed(interpolation_, coarse_size_);
  for (std::size_t axis = 0; axis < 2; ++axis)
    nearest_[axis] = nearest_fine(from[axis], to[axis]);
}

FaceContact FaceTransfer::coarse(const FaceContact& fine) const {
  FaceContact result;
  if (!fine.springs.is_empty())
    result.springs = product(
        transposed_, product(fine.springs, interpolation_, coarse_size_),
        coarse_size_);
  result.is_sticking = fine.is_sticking;
  if (fine.held.empty())
    return result;
  for (const std::size_t y : nearest_[1])
    for (const std::size_t x : nearest_[0])
      result.held.push_back(fine.held[y * fine_nodes_x_ + x]);
  return result;
}

std::vector<std::size_t> face_places(const NodeLayout& layout, int component) {
  std::vector<std::size_t> places;
  for (int y = 0; y < layout.nodes_y(); ++y)
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
void add_spring_force(const SparseRows& springs,
                      const std::vector<std::size_t>& places,
                      const Number* displacement, Number* force) {
  for (std::size_t row = 0; row < springs.rows(); ++row) {
    double sum = 0.0;
    for (std::size_t i = springs.start[row]; i < springs.start[row + 1]; ++i)
      sum += springs.weight[i] *
             static_cast<double>(displacement[places[springs.column[i]]]);
    force[places[row]] += static_cast<Number>(sum);
  }
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

template void add_spring_force(const SparseRows&,
                               const std::vector<std::size_t>&, const float*,
                               float*);
template void add_spring_force(const SparseRows&,
                               const std::vector<std::size_t>&, const double*,
                               double*);
template void clear_far_boundary(const BoxLattice&, const NodeLayout&, float*);
template void clear_far_boundary(const BoxLattice&, const NodeLayout&, double*);

} // namespace asperity::fem
