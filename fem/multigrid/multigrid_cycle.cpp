#include "fem/multigrid/multigrid_cycle.hpp"

#include "fem/multigrid/lattice_levels.hpp"
#include "fem/multigrid/lattice_operator.hpp"
#include "fem/multigrid/lattice_transfer.hpp"

#include <utility>

namespace asperity::fem {

void MultigridCycle::add_level(std::unique_ptr<LevelTransfer> transfer,
                               std::unique_ptr<SmoothedLevel> level) {
  transfers_.push_back(std::move(transfer));
  levels_.push_back(std::move(level));
}

void MultigridCycle::add_lattices(std::unique_ptr<LevelTransfer> transfer,
                                  BoxLattice lattice, LatticeSlab slab) {
  while (has_coarser(lattice)) {
    auto stiffness = std::make_unique<LatticeOperator<float>>(
        lattice, slab, unknowns_of(lattice, slab));
    const std::vector<double> diagonal = stiffness->diagonal();
    const double bound = stiffness->jacobi_bound();
    add_level(std::move(transfer), std::make_unique<SmoothedLevel>(
                                       std::move(stiffness), diagonal, bound));
    BoxLattice next = coarser(lattice);
    LatticeSlab rows = next_slab(lattice, slab, next);
    transfer = std::make_unique<LatticeTransfer>(lattice, slab, next, rows);
    lattice = std::move(next);
    slab = std::move(rows);
  }
  transfers_.push_back(std::move(transfer));
  coarsest_ = std::make_unique<CoarsestLattice>(lattice);
}

void MultigridCycle::set_contact(const MeshContact& contact) {
  MeshContact own = transfers_.front()->coarse(contact);
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    MeshContact next = transfers_[i + 1]->coarse(own);
    levels_[i]->set_contact(std::move(own));
    own = std::move(next);
  }
  coarsest_->set_contact(own);
}

void MultigridCycle::add_correction(std::size_t level,
                                    const std::vector<float>& residual,
                                    std::vector<float>& displacement) {
  LevelTransfer& transfer = *transfers_[level];
  if (level == levels_.size()) {
    transfer.restrict_force(residual, coarsest_->force);
    coarsest_->solve();
    transfer.add_interpolated(coarsest_->displacement, displacement);
    return;
  }
  transfer.restrict_force(residual, levels_[level]->residual);
  run(level);
  transfer.add_interpolated(levels_[level]->displacement, displacement);
}

void MultigridCycle::run(std::size_t level) {
  SmoothedLevel& own = *levels_[level];
  const UnknownLayout& layout = own.layout();
  layout.constraints->condense(own.residual.data());
  layout.collect(own.residual.data());
  own.clear_held(own.residual);
  own.smooth_before();
  own.add_correction([&](const auto& residual, auto& displacement) {
    add_correction(level + 1, residual, displacement);
  });
  own.smooth_after();
  layout.complete(own.displacement.data());
}

std::size_t MultigridCycle::bytes() const {
  std::size_t bytes = coarsest_->bytes();
  for (const auto& transfer : transfers_)
    bytes += transfer->bytes();
  for (const auto& level : levels_)
    bytes += level->bytes() + level->layout().constraints->bytes();
  return bytes;
}

LatticeSlab next_slab(const BoxLattice& lattice, const LatticeSlab& slab,
                      const BoxLattice& next) {
  return has_coarser(next) ? coarser(lattice, slab, next) : LatticeSlab(next);
}

} // namespace asperity::fem
