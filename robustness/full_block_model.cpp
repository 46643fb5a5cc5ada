// Builds the full 3-D model of an instance: its mesh, the moduli of its bodies
// and its settings.
#include "robustness/kinds.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::robustness {
namespace {

mechanics::CounterShape shape_of(CounterBody counter) {
  switch (counter) {
  case CounterBody::cylinder:
    return mechanics::CounterShape::cylinder;
  case CounterBody::cuboid:
    return mechanics::CounterShape::cuboid;
  default:
    return mechanics::CounterShape::sphere;
  }
}

/// The mesh of an instance. Cells of gmsh have one spacing at the contact
/// surface, and an adaptive mesh has two coarsest cells per side, or four
/// first-order ones.
mechanics::MeshSpec mesh_of(const Instance& instance) {
  using mechanics::ReferenceUnit;
  mechanics::MeshSpec mesh;
  mesh.kind = instance.mesh;
  mesh.halvings = instance.points == 8 ? 1 : 2;
  mesh.size_far = {2.0, ReferenceUnit::spacing};
  if (instance.counter != CounterBody::none) {
    mechanics::CounterMeshSpec& counter = mesh.counter.emplace();
    counter.shape = shape_of(instance.counter);
    counter.radius = {instance.counter_radius, ReferenceUnit::length};
    counter.size_far = {2.0, ReferenceUnit::spacing};
    // Cells are so coarse that only the widest fine region of a ball has two.
    if (instance.counter == CounterBody::sphere)
      counter.fine_radius = {0.399 * instance.counter_radius,
                             ReferenceUnit::length};
  }
  return mesh;
}

/// The moduli of the block, or of block and counter-body, whose E* is that of
/// the pair.
mechanics::MaterialSpec material_of(const Instance& instance) {
  mechanics::MaterialSpec material;
  material.contact_modulus = instance.contact_modulus;
  material.poisson_ratio = instance.poisson_ratio;
  if (instance.counter == CounterBody::none)
    return material;
  constexpr double ratio = 0.3;
  const double stiffness = instance.counter_stiffness;
  material.contact_modulus *= stiffness / (1.0 + stiffness);
  material.counter = mechanics::BodyModuli{
      stiffness * instance.contact_modulus * (1.0 - ratio * ratio), ratio};
  return material;
}

} // namespace

std::unique_ptr<fem::FullBlock> full_block_of(const Instance& instance,
                                              const Grid& grid,
                                              mechanics::LinearSolver solver) {
  const fem::BlockRequest uniform =
      block_request(instance, grid, instance.degree, 1);
  fem::FullRequest request;
  request.grid = grid;
  request.block = uniform.settings;
  request.full.linear_solver = solver;
  request.full.uses_case_mesh = instance.mesh != mechanics::MeshKind::layers;
  request.mesh = mesh_of(instance);
  if (instance.has_free_sides)
    request.full.sides = mechanics::BlockSides::free;
  request.material = material_of(instance);
  request.full.bodies = request.material.counter ? 2 : 1;
  request.material.layers = uniform.layers;
  request.scales = uniform.scales;
  // A wave much shorter than a cell is as good as random numbers.
  if (instance.modulus_ratio != 1.0)
    request.material.variation.emplace().factor =
        fmt::format("exp({:.17g} * sin(997 * x + 1317 * y + 733 * z + {}))",
                    std::log(instance.modulus_ratio), instance.index);
  return fem::load_fem_module().full(request);
}

} // namespace asperity::robustness
