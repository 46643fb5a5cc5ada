#include "fem/multigrid/lattice_multigrid.hpp"

#include "fem/multigrid/lattice_levels.hpp"
#include "fem/multigrid/lattice_operator.hpp"
#include "fem/multigrid/lattice_transfer.hpp"

#include <utility>

namespace asperity::fem {
namespace {

LatticeSlab slab_of(const BoxLattice& lattice, RankGroup* ranks) {
  require_lattice(lattice);
  return has_coarser(lattice) ? divided(lattice, ranks) : LatticeSlab(lattice);
}

MeshStiffness stiffness_of(const BoxLattice& lattice, const LatticeSlab& slab) {
  const MeshUnits units = units_of(lattice);
  const UnknownLayout unknowns = unknowns_of(lattice, slab);
  auto in_units = std::make_unique<LatticeOperator<float>>(
      scaled(lattice, units), slab, unknowns);
  MeshStiffness stiffness;
  stiffness.in_si =
      std::make_unique<LatticeOperator<double>>(lattice, slab, unknowns);
  stiffness.unit = units.stiffness();
  stiffness.diagonal = in_units->diagonal();
  stiffness.bound = in_units->jacobi_bound();
  stiffness.in_units = std::move(in_units);
  return stiffness;
}

} // namespace

LatticeMultigrid::LatticeMultigrid(const BoxLattice& lattice, RankGroup* ranks)
    : LatticeMultigrid(lattice, slab_of(lattice, ranks)) {}

LatticeMultigrid::LatticeMultigrid(const BoxLattice& lattice,
                                   const LatticeSlab& slab)
    : MeshMultigrid(stiffness_of(lattice, slab)),
      lattice_(lattice),
      slab_(slab) {
  lattice_.moduli.clear();
  const BoxLattice own = scaled(lattice, units_of(lattice));
  // A small lattice is its own coarsest one.
  const BoxLattice next = has_coarser(own) ? coarser(own) : own;
  const LatticeSlab rows = next_slab(own, slab, next);
  cycle_.add_lattices(std::make_unique<LatticeTransfer>(own, slab, next, rows),
                      next, rows);
  set_correction([this](const auto& residual, auto& displacement) {
    cycle_.add_correction(residual, displacement);
  });
  set_contact({});
}

void LatticeMultigrid::set_contact(MeshContact contact) {
  cycle_.set_contact(contact.in_units_of(unit()));
  MeshMultigrid::set_contact(std::move(contact));
}

std::size_t LatticeMultigrid::bytes() const {
  return MeshMultigrid::bytes() + cycle_.bytes() +
         unknowns().constraints->bytes();
}

} // namespace asperity::fem
