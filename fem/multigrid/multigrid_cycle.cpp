#include "fem/multigrid/multigrid_cycle.hpp"

#include "fem/multigrid/chebyshev.hpp"
#include "fem/multigrid/lattice_levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace asperity::fem {
namespace {

/// Terms of the polynomial before and after each coarse correction.
constexpr int smoother_degree = 4;

/// A lattice with at most this many unknowns is solved exactly.
constexpr std::size_t most_exact_unknowns = 250;

std::size_t unknowns_of(const BoxLattice& lattice) {
  const NodeLayout layout(lattice);
  return 3 * layout.planes() * static_cast<std::size_t>(layout.nodes_x()) *
         static_cast<std::size_t>(layout.nodes_y());
}

/// The largest eigenvalue of diag(K)^-1 K: an estimate, unless that of a cell
/// is a smaller bound.
float largest_eigenvalue(const BoxLattice& lattice,
                         const LatticeOperator<float>& stiffness,
                         const std::vector<float>& diagonal) {
  const double estimate = eigenvalue_from(
      random_displacement(lattice, stiffness.slab()), diagonal,
      [&](float* from, float* to) { stiffness.apply(from, to); },
      stiffness.slab().ranks());
  return static_cast<float>(std::min(estimate, stiffness.jacobi_bound()));
}

} // namespace

bool MultigridCycle::has_levels(const BoxLattice& lattice) {
  return can_coarsen(lattice) && unknowns_of(lattice) > most_exact_unknowns;
}

struct MultigridCycle::Level : SmoothedVectors {
  Level(const BoxLattice& fine, const LatticeSlab& slab, const BoxLattice& next,
        const LatticeSlab& next_slab)
      : lattice(fine),
        stiffness(fine, slab),
        diagonal(stiffness.diagonal()),
        transfer(fine, slab, next, next_slab),
        face_transfer(fine, slab, next, next_slab),
        places(face_places(stiffness.layout())),
        product(diagonal.size()) {
    displacement = residual = direction = product;
    lattice.moduli.clear();
    eigenvalue = largest_eigenvalue(lattice, stiffness, diagonal);
    face_diagonal.reserve(places.size());
    for (const std::size_t place : places)
      face_diagonal.push_back(diagonal[place]);
    std::swap(diagonal, inverse);
    for (float& value : inverse)
      value = value > 0.0F ? 1.0F / (eigenvalue * value) : 0.0F;
    clear_far_boundary(lattice, stiffness.layout(), inverse.data());
  }

  void set_contact(const FaceContact& own);
  void apply();
  void smooth(bool is_first);
  void clear_held(std::vector<float>& vector) const;

  BoxLattice lattice; ///< without moduli
  LatticeOperator<float> stiffness;
  std::vector<float> diagonal; ///< only during construction
  LatticeTransfer transfer;
  FaceTransfer face_transfer;
  std::vector<std::size_t> places; ///< of the surface's nodes
  std::vector<float> product;
  std::vector<float> inverse; ///< of diagonal times eigenvalue; zero if held
  std::vector<float> face_diagonal;
  float eigenvalue = 0.0F;
  FaceContact contact;
  std::vector<std::size_t> held; ///< places
  /// Places of u_x and u_y among them, with the inverse where they are free.
  std::vector<std::pair<std::size_t, float>> held_lateral;
};

void MultigridCycle::Level::set_contact(const FaceContact& own) {
  contact = own;
  for (const auto& [place, value] : held_lateral)
    inverse[place] = value;
  held_lateral.clear();
  std::vector<double> sums(places.size(), 0.0);
  for (std::size_t node = 0; node < contact.springs.rows(); ++node)
    for (std::size_t i = contact.springs.start[node];
         i < contact.springs.start[node + 1]; ++i)
      sums[node] += std::abs(contact.springs.weight[i]);
  fold_face_row(stiffness.layout(), stiffness.slab(), sums);
  for (std::size_t node = 0; node < places.size(); ++node)
    if (face_diagonal[node] > 0.0F) // zero at images
      inverse[places[node]] = static_cast<float>(
          1.0 /
          (static_cast<double>(eigenvalue * face_diagonal[node]) + sums[node]));
  held = held_places(stiffness.layout(), contact);
  const std::size_t n_normal = static_cast<std::size_t>(
      std::count(contact.held.begin(), contact.held.end(), true));
  // The places of u_z come last.
  for (std::size_t i = 0; i + n_normal < held.size(); ++i)
    held_lateral.emplace_back(held[i], inverse[held[i]]);
  for (const std::size_t place : held)
    inverse[place] = 0.0F;
}

void MultigridCycle::Level::clear_held(std::vector<float>& vector) const {
  clear_far_boundary(lattice, stiffness.layout(), vector.data());
  for (const std::size_t place : held)
    vector[place] = 0.0F;
}

/// Subtracts (K + S) direction from the residual.
void MultigridCycle::Level::apply() {
  stiffness.apply(direction.data(), product.data(),
                  {&contact.springs, &places});
  for (std::size_t i = 0; i < residual.size(); ++i)
    residual[i] -= product[i];
}

/// The last product is left out after the coarse correction, where nobody needs
/// it.
void MultigridCycle::Level::smooth(bool is_first) {
  if (is_first)
    std::fill(displacement.begin(), displacement.end(), 0.0F);
  smooth_by_chebyshev(*this, inverse, smoother_degree, !is_first,
                      [this] { apply(); });
}

MultigridCycle::MultigridCycle(const BoxLattice& lattice, LatticeSlab slab) {
  BoxLattice own = lattice;
  while (has_levels(own)) {
    BoxLattice next = coarser(own);
    // The coarsest lattice is solved by every rank.
    LatticeSlab next_slab =
        has_levels(next) ? coarser(own, slab, next) : LatticeSlab(next);
    levels_.push_back(std::make_unique<Level>(own, slab, next, next_slab));
    own = std::move(next);
    slab = std::move(next_slab);
  }
  coarsest_ = std::make_unique<CoarsestLattice>(own);
}

MultigridCycle::~MultigridCycle() = default;

void MultigridCycle::set_contact(const FaceContact& contact) {
  FaceContact own = contact;
  for (const auto& level : levels_) {
    level->set_contact(own);
    own = level->face_transfer.coarse(own);
  }
  coarsest_->set_contact(own);
}

std::vector<float>& MultigridCycle::force() {
  return levels_.empty() ? coarsest_->force : levels_.front()->residual;
}

const std::vector<float>& MultigridCycle::displacement() const {
  return levels_.empty() ? coarsest_->displacement
                         : levels_.front()->displacement;
}

void MultigridCycle::descend(std::size_t level) {
  if (level == levels_.size()) {
    coarsest_->solve();
    return;
  }
  Level& own = *levels_[level];
  const bool is_last = level + 1 == levels_.size();
  own.smooth(true);
  own.clear_held(own.residual);
  own.transfer.restrict_force(
      own.residual, is_last ? coarsest_->force : levels_[level + 1]->residual);
  descend(level + 1);
  own.transfer.interpolate(is_last ? coarsest_->displacement
                                   : levels_[level + 1]->displacement,
                           own.direction);
  own.clear_held(own.direction);
  for (std::size_t i = 0; i < own.displacement.size(); ++i)
    own.displacement[i] += own.direction[i];
  own.apply();
  own.smooth(false);
}

void MultigridCycle::run() {
  descend(0);
}

std::size_t MultigridCycle::bytes() const {
  std::size_t bytes = coarsest_->bytes();
  for (const auto& level : levels_)
    bytes += 5 * level->inverse.size() * sizeof(float) +
             level->places.size() * (sizeof(std::size_t) + sizeof(float)) +
             level->stiffness.bytes() + level->transfer.bytes() +
             level->face_transfer.bytes() + level->contact.springs.bytes();
  return bytes;
}

} // namespace asperity::fem
