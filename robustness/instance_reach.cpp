// Restricts an instance to what its family accepts and solves within seconds.
#include "robustness/instance.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::robustness {
namespace {

/// Lattice spacing of the block of atoms in Sec. 4 of Yang and Persson (2008)
/// [m].
constexpr double atom_spacing = 2.6e-10;

/// Restricts a full 3-D model on a counter-body to what a case accepts, and to
/// prescribed loads: only a part of its points can touch, and no pressure may
/// close the mean gap of all. A cell fits into the fine region of a ball, which
/// has at most 0.4 R, and the surface on it is a paraboloid of its radius R:
/// over a square of side L, the rms of the slope r/R is L/(sqrt(6) R).
Instance with_counter_settings(Instance instance) {
  if (mechanics::traits_of(instance.law).block_solver ==
      mechanics::BlockSolver::wall)
    instance.law = mechanics::ContactLaw::augmented;
  if (instance.far_boundary == mechanics::FarBoundary::pressure)
    instance.far_boundary = mechanics::FarBoundary::sliding;
  if (instance.mesh == mechanics::MeshKind::adaptive)
    instance.mesh = mechanics::MeshKind::hanging;
  if (instance.control == mechanics::Control::mean_gap)
    instance.load = std::max(std::abs(instance.load), 1e-3);
  instance.control = mechanics::Control::nominal_pressure;
  if (instance.counter == CounterBody::sphere) {
    if (instance.mesh == mechanics::MeshKind::gmsh)
      instance.degree = 1;
    else if (instance.degree == 2)
      instance.points = 16;
    const double edge = 1.0 * instance.degree / instance.points;
    instance.counter_radius = std::max(instance.counter_radius, 2.75 * edge);
    instance.shape = Shape::paraboloid;
    instance.rms_slope = 1.0 / (std::sqrt(6.0) * instance.counter_radius);
  }
  return instance;
}

/// Restricts the settings of a full 3-D model to combinations that it accepts;
/// other families, and models that go through the program, have none of them.
Instance with_block_settings(Instance instance) {
  using mechanics::LinearSolver;
  const bool is_compared =
      instance.family == Family::full_block && instance.path == Path::library;
  if (is_compared) {
    instance.relation = MetamorphicRelation::direct_solver;
  } else {
    if (instance.relation == MetamorphicRelation::direct_solver)
      instance.relation = MetamorphicRelation::none;
    instance.has_free_sides = false;
    instance.linear_solver = LinearSolver::automatic;
    instance.modulus_ratio = 1.0;
    instance.mesh = mechanics::MeshKind::layers;
    instance.counter = CounterBody::none;
  }
  if (instance.counter != CounterBody::none)
    instance = with_counter_settings(instance);
  if (instance.far_boundary == mechanics::FarBoundary::pressure)
    instance.has_free_sides = false;
  // Its iterations grow beyond the cost of a direct solver, which `auto`
  // chooses instead (docs/numerics/full-block.md).
  if (instance.linear_solver == LinearSolver::multigrid)
    instance.poisson_ratio = std::min(instance.poisson_ratio, 0.49);
  return instance;
}

/// Restricts a full 3-D model to what its mesh accepts and a direct solver of
/// it can do within a minute. Cells of gmsh are at most a quarter of the
/// thickness, and second-order ones have some ten times as many unknowns as
/// graded layers. An adaptive block is solved some ten times per load, and
/// where moduli vary all of its cells are the finest: it has half of the cells.
Instance with_block_thickness(Instance instance) {
  using mechanics::MeshKind;
  if (instance.mesh == MeshKind::gmsh && instance.degree == 2)
    instance.points = 8;
  double thinnest = 0.1;
  double thickest = instance.points == 8 ? 2.0 : 0.5;
  if (instance.mesh == MeshKind::gmsh)
    thinnest = 4.0 / instance.points;
  if (instance.mesh == MeshKind::gmsh && instance.degree == 2)
    thickest = 0.6;
  if (instance.mesh == MeshKind::adaptive)
    thickest *= 0.5;
  instance.thickness = std::clamp(instance.thickness, thinnest, thickest);
  return instance;
}

/// Restricts an instance to what a case file accepts: surfaces that are not
/// flat, and positive mean gaps.
Instance within_reach_of_a_case(Instance instance) {
  if (instance.shape == Shape::flat)
    instance.shape = Shape::wave;
  if (instance.control == mechanics::Control::mean_gap)
    instance.load = std::max(instance.load, 1e-3);
  return instance;
}

/// Restricts adhesion to what has a solver for it, in the library: half-spaces,
/// slabs and condensed blocks of first order, at a positive mean gap or a load
/// that presses first.
Instance with_adhesion_settings(Instance instance) {
  if (!mechanics::is_adhesive(instance.law))
    return instance;
  if (instance.family != Family::halfspace && instance.family != Family::slab &&
      instance.family != Family::condensed_q1)
    instance.law = mechanics::ContactLaw::hard;
  if (!mechanics::is_adhesive(instance.law))
    return instance;
  instance.path = Path::library;
  if (instance.relation == MetamorphicRelation::decimal_units)
    instance.relation = MetamorphicRelation::none; // bits decide on jumps
  if (instance.control == mechanics::Control::mean_gap)
    instance.load = std::max(instance.load, 1e-3);
  return instance;
}

} // namespace

Instance within_reach(Instance instance) {
  const bool is_full = instance.family == Family::full_block;
  instance = with_adhesion_settings(instance);
  if (!mechanics::is_adhesive(instance.law) ||
      instance.control != mechanics::Control::mean_gap)
    instance.spring = std::numeric_limits<double>::infinity();
  if (instance.family != Family::halfspace ||
      instance.control == mechanics::Control::mean_gap)
    instance.has_free_boundaries = false;
  if (is_full || instance.family == Family::atoms) {
    instance.points = instance.points <= 48 ? 8 : 16;
    instance.relation = MetamorphicRelation::none;
  }
  instance = with_block_settings(instance);
  if (is_full) {
    instance = with_block_thickness(instance);
    instance.growth = std::max(instance.growth, 1.5);
  }
  if (instance.family == Family::atoms) {
    instance.law =
        mechanics::ContactLaw::penalty; // the soft potential of the atoms
    instance.control = mechanics::Control::nominal_pressure;
    instance.program = Program::increments;
    instance.load = std::clamp(instance.load, 1e-3, 0.3);
    instance.rms_slope = std::clamp(instance.rms_slope, 1e-3, 0.2);
    instance.length = instance.points * atom_spacing;
    instance.contact_modulus = std::clamp(instance.contact_modulus, 1e10, 1e11);
    instance.poisson_ratio = std::min(instance.poisson_ratio, 0.49);
    instance.shape = Shape::rough;
    instance.shortest_wave = std::max(instance.shortest_wave, 4.0);
  }
  if (instance.path == Path::two_ranks && !is_full)
    instance.path = Path::library;
  if (instance.path != Path::library)
    instance = within_reach_of_a_case(instance);
  // At least two periods of the shortest wave fit into the roll-off length.
  instance.roll_off = std::min(instance.roll_off,
                               0.5 * instance.points / instance.shortest_wave);
  instance.roll_off = std::max(instance.roll_off, 1.0);
  instance.shortest_wave =
      std::min(instance.shortest_wave, 0.5 * instance.points);
  return instance;
}

} // namespace asperity::robustness
