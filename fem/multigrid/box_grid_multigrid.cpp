#include "fem/multigrid/box_grid_multigrid.hpp"

#include "fem/multigrid/box_grid_levels.hpp"
#include "fem/multigrid/box_grid_operator.hpp"
#include "fem/multigrid/box_grid_transfer.hpp"

#include <utility>

namespace asperity::fem {
namespace {

BoxGridSlab slab_of(const BoxGrid& box_grid, RankGroup* ranks) {
  require_box_grid(box_grid);
  return has_coarser(box_grid) ? divided(box_grid, ranks)
                               : BoxGridSlab(box_grid);
}

MeshStiffness stiffness_of(const BoxGrid& box_grid, const BoxGridSlab& slab) {
  const MeshUnits units = units_of(box_grid);
  const UnknownLayout unknowns = unknowns_of(box_grid, slab);
  auto in_units = std::make_unique<BoxGridOperator<float>>(
      scaled(box_grid, units), slab, unknowns);
  MeshStiffness stiffness;
  stiffness.in_si =
      std::make_unique<BoxGridOperator<double>>(box_grid, slab, unknowns);
  stiffness.unit = units.stiffness();
  stiffness.diagonal = in_units->diagonal();
  stiffness.bound = in_units->jacobi_bound();
  stiffness.in_units = std::move(in_units);
  return stiffness;
}

} // namespace

BoxGridMultigrid::BoxGridMultigrid(const BoxGrid& box_grid, RankGroup* ranks)
    : BoxGridMultigrid(box_grid, slab_of(box_grid, ranks)) {}

BoxGridMultigrid::BoxGridMultigrid(const BoxGrid& box_grid,
                                   const BoxGridSlab& slab)
    : MeshMultigrid(stiffness_of(box_grid, slab)),
      box_grid_(box_grid),
      slab_(slab) {
  box_grid_.moduli.clear();
  const BoxGrid own = scaled(box_grid, units_of(box_grid));
  // A small grid of boxes is its own coarsest one.
  const BoxGrid next = has_coarser(own) ? coarser(own) : own;
  const BoxGridSlab rows = next_slab(own, slab, next);
  cycle_.add_box_grids(std::make_unique<BoxGridTransfer>(own, slab, next, rows),
                       next, rows);
  set_correction([this](const auto& residual, auto& displacement) {
    cycle_.add_correction(residual, displacement);
  });
  set_contact({});
}

void BoxGridMultigrid::set_contact(MeshContact contact) {
  cycle_.set_contact(contact.in_units_of(unit()));
  MeshMultigrid::set_contact(std::move(contact));
}

std::size_t BoxGridMultigrid::bytes() const {
  return MeshMultigrid::bytes() + cycle_.bytes() +
         unknowns().constraints->bytes();
}

} // namespace asperity::fem
