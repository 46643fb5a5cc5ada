#include "fem/refined/refined_cycle.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace asperity::fem {

/// A mesh that is smoothed.
struct RefinedCycle::Level {
  explicit Level(std::unique_ptr<BoxLevel> own)
      : mesh(std::move(own)), smoothed(mesh->mesh) {
    mesh->release_cells();
  }

  std::unique_ptr<BoxLevel> mesh;
  SmoothedLevel<BoxOperator> smoothed;
};

namespace {

/// The lattice with the moduli of the cells, all of which are its own.
BoxLattice with_moduli(BoxLattice lattice, const HalvedBoxes& boxes) {
  const auto rows = static_cast<std::size_t>(lattice.cells_y);
  const auto columns = static_cast<std::size_t>(lattice.cells_x);
  lattice.moduli.resize(boxes.cells.size());
  for (std::size_t i = 0; i < boxes.cells.size(); ++i) {
    const auto& at = boxes.cells[i].place;
    lattice.moduli[(static_cast<std::size_t>(at[2]) * rows +
                    static_cast<std::size_t>(at[1])) *
                       columns +
                   static_cast<std::size_t>(at[0])] = boxes.moduli[i];
  }
  return lattice;
}

} // namespace

/// The lattice of the coarsest cells. Its nodes have the order of BoxLevel, and
/// places in the vectors of its cycle.
struct RefinedCycle::Coarsest {
  Coarsest(const BoxLattice& lattice, std::unique_ptr<BoxLevel> own)
      : mesh(std::move(own)),
        cycle(with_moduli(lattice, mesh->boxes)),
        force(mesh->mesh.unknowns),
        displacement(force.size()) {
    mesh->release_cells();
    const NodeLayout layout(lattice);
    places.reserve(force.size());
    for (int plane = 0; plane < static_cast<int>(layout.planes()); ++plane)
      for (int y = 0; y < layout.nodes_y(); ++y)
        for (int x = 0; x < layout.nodes_x(); ++x)
          for (int c = 0; c < 3; ++c)
            places.push_back(layout.index(x, y, plane, c));
    nodes_in_plane = static_cast<std::size_t>(layout.nodes_x()) *
                     static_cast<std::size_t>(layout.nodes_y());
  }

  void set_contact(const MeshContact& contact, bool is_sticking);
  void run();

  std::unique_ptr<BoxLevel> mesh;
  MultigridCycle cycle;
  std::vector<float> force, displacement;
  std::vector<std::size_t> places; ///< of each unknown in vectors of the cycle
  std::size_t nodes_in_plane = 0;
  std::vector<std::size_t> held;
};

void RefinedCycle::Coarsest::set_contact(const MeshContact& contact,
                                         bool is_sticking) {
  held = contact.held;
  FaceContact face;
  face.is_sticking = is_sticking;
  if (!held.empty())
    face.held.assign(nodes_in_plane, false);
  for (const std::size_t unknown : held)
    if (unknown % 3 == 2)
      face.held[unknown / 3] = true;
  if (!contact.springs.is_empty()) {
    std::vector<std::size_t> row_of(nodes_in_plane, contact.springs.rows());
    for (std::size_t row = 0; row < contact.unknowns.size(); ++row)
      row_of[contact.unknowns[row] / 3] = row;
    for (const std::size_t row : row_of) {
      if (row < contact.springs.rows())
        for (std::size_t k = contact.springs.start[row];
             k < contact.springs.start[row + 1]; ++k) {
          face.springs.column.push_back(
              contact.unknowns[contact.springs.column[k]] / 3);
          face.springs.weight.push_back(contact.springs.weight[k]);
        }
      face.springs.start.push_back(face.springs.column.size());
    }
  }
  cycle.set_contact(face);
}

void RefinedCycle::Coarsest::run() {
  const UnknownConstraints& constraints = *mesh->mesh.constraints;
  constraints.visit([&](std::size_t unknown) { force[unknown] = 0.0F; });
  for (const std::size_t unknown : held)
    force[unknown] = 0.0F;
  std::vector<float>& to = cycle.force();
  std::ranges::fill(to, 0.0F);
  for (std::size_t i = 0; i < places.size(); ++i)
    to[places[i]] = force[i];
  cycle.run();
  for (std::size_t i = 0; i < places.size(); ++i)
    displacement[i] = cycle.displacement()[places[i]];
  constraints.visit([&](std::size_t unknown) { displacement[unknown] = 0.0F; });
  for (const std::size_t unknown : held)
    displacement[unknown] = 0.0F;
}

RefinedCycle::RefinedCycle(const BoxLattice& lattice, HalvedBoxes boxes,
                           const NodesOfCells& own, std::size_t first,
                           std::vector<bool> is_wanted, bool is_second_order) {
  std::vector<std::uint32_t> coarse_of;
  HalvedBoxes next;
  if (is_second_order || boxes.is_lattice()) {
    coarse_of.resize(boxes.cells.size());
    std::iota(coarse_of.begin(), coarse_of.end(), 0U);
    next = std::move(boxes);
  } else {
    next = merged(lattice, boxes, coarse_of);
  }
  auto mesh = std::make_unique<BoxLevel>(lattice, std::move(next));
  finest_ = mesh.get();
  interpolations_.emplace_back(
      own, *mesh, std::span(coarse_of).subspan(first, own.cells.size()),
      std::move(is_wanted));
  while (!mesh->boxes.is_lattice()) {
    auto coarser = std::make_unique<BoxLevel>(
        lattice, merged(lattice, mesh->boxes, coarse_of));
    std::vector<bool> is_free(mesh->mesh.unknowns / 3, true);
    mesh->mesh.constraints->visit([&](std::size_t unknown) {
      if (unknown % 3 == 2 && mesh->is_constrained(unknown - 1))
        is_free[unknown / 3] = false;
    });
    interpolations_.emplace_back(
        NodesOfCells{*mesh->mesh.nodes, 2, mesh->boxes.cells}, *coarser,
        coarse_of, std::move(is_free));
    levels_.push_back(std::make_unique<Level>(std::move(mesh)));
    mesh = std::move(coarser);
  }
  coarsest_ = std::make_unique<Coarsest>(lattice, std::move(mesh));
}

RefinedCycle::~RefinedCycle() = default;

std::size_t RefinedCycle::levels() const {
  return levels_.size() + coarsest_->cycle.levels();
}

void RefinedCycle::set_contact(MeshContact contact, bool is_sticking) {
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    const BoxLevel& next =
        i + 1 < levels_.size() ? *levels_[i + 1]->mesh : *coarsest_->mesh;
    MeshContact coarse = interpolations_[i + 1].coarse(contact, next);
    levels_[i]->smoothed.set_contact(std::move(contact));
    contact = std::move(coarse);
  }
  coarsest_->set_contact(contact, is_sticking);
}

std::vector<float>& RefinedCycle::force_of(std::size_t level) {
  return level < levels_.size() ? levels_[level]->smoothed.residual
                                : coarsest_->force;
}

std::vector<float>& RefinedCycle::force() {
  return force_of(0);
}

const std::vector<float>& RefinedCycle::displacement() const {
  return levels_.empty() ? coarsest_->displacement
                         : levels_.front()->smoothed.displacement;
}

void RefinedCycle::descend(std::size_t level) {
  if (level == levels_.size()) {
    coarsest_->run();
    return;
  }
  SmoothedLevel<BoxOperator>& own = levels_[level]->smoothed;
  const UnknownConstraints& constraints =
      *levels_[level]->mesh->mesh.constraints;
  constraints.condense(own.residual.data());
  own.clear_held(own.residual);
  own.smooth_before();
  own.add_correction([&](const auto& residual, auto& displacement) {
    std::vector<float>& next = force_of(level + 1);
    std::ranges::fill(next, 0.0F);
    interpolations_[level + 1].restrict_force(residual, 1.0F, next);
    descend(level + 1);
    interpolations_[level + 1].interpolate(
        level + 1 < levels_.size() ? levels_[level + 1]->smoothed.displacement
                                   : coarsest_->displacement,
        displacement);
  });
  own.smooth_after();
  constraints.distribute(own.displacement.data());
}

std::size_t RefinedCycle::bytes() const {
  std::size_t bytes = coarsest_->cycle.bytes() +
                      2 * coarsest_->force.size() * sizeof(float) +
                      coarsest_->places.size() * sizeof(std::size_t);
  for (const auto& level : levels_)
    bytes += level->smoothed.bytes() + level->mesh->mesh.constraints->bytes();
  for (const NodeInterpolation& own : interpolations_)
    bytes += own.bytes();
  return bytes;
}

} // namespace asperity::fem
