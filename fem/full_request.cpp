#include "fem/full_request.hpp"

#include "base/require.hpp"
#include "fem/material/j2_plasticity.hpp"
#include "fem/parallel/mpi_group.hpp"
#include "fem/parallel/ranks.hpp"
#include "meshes/counter_body.hpp"
#include "meshes/gmsh_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "meshes/layered_mesh.hpp"
#include "meshes/layers/graded_layers.hpp"
#include "meshes/mesh_bytes.hpp"
#include "meshes/mesh_quality.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace asperity::fem {
namespace {

/// The grid with one point per cell instead of one point per node.
Grid cells_of(const Grid& nodes, int degree) {
  return {nodes.points_x / degree, nodes.points_y / degree, nodes.length_x,
          nodes.length_y};
}

/// The coarsest cells of an adaptive mesh.
meshes::BlockMesh coarsest_mesh_of(const FullRequest& request) {
  const auto& variation = request.material.variation;
  if (variation && variation->kind == mechanics::VariationKind::random &&
      !variation->edge)
    throw std::domain_error(
        "an adaptive mesh with random moduli needs material.variation.edge, "
        "because the factor of a cell would change when the cell is halved");
  return meshes::halvable_boxes(
      request.grid, degree_of(request.block.element), request.mesh.halvings,
      meshes::interfaces_of(request.material.layers, request.scales),
      request.block.depth.in_si(request.scales));
}

meshes::BlockMesh mesh_of(const FullRequest& request) {
  const mechanics::MeshSpec& spec = request.mesh;
  if (spec.kind == mechanics::MeshKind::adaptive)
    return coarsest_mesh_of(request);
  if (spec.kind == mechanics::MeshKind::hanging)
    return meshes::hanging_mesh(
        cells_of(request.grid, degree_of(request.block.element)),
        request.block.depth.in_si(request.scales), spec.cells_a_level);
  if (spec.geometry == mechanics::MeshGeometry::file)
    return request.file_mesh.value();
  return meshes::gmsh_block(meshes::gmsh_parameters(
      spec, request.material, request.block.depth.in_si(request.scales),
      request.grid, request.scales));
}

/// Adds the mesh of a counter-body of its own and what the report says of it.
void add_counter_mesh(const FullRequest& request, BlockProblem& problem) {
  const mechanics::OpposedBlock block{
      request.grid.length_x, request.grid.length_y, request.full.sides,
      meshes::mesh_quality(problem.mesh).contact_edges.smallest};
  const mechanics::CounterBody body =
      mechanics::counter_body_of(*request.mesh.counter, request.scales, block);
  if (const auto mistake = mechanics::mistake_in(body, block))
    refuse_argument("mesh.counter." + mistake->key, mistake->value,
                    mistake->rule);
  problem.counter_mesh = meshes::counter_body(body);
  problem.quality +=
      "\ncounter-body: " +
      meshes::quality_text(meshes::mesh_quality(*problem.counter_mesh));
}

std::vector<double> thicknesses_of(const LayeredBlock& block) {
  std::vector<double> thicknesses;
  for (const ElasticLayer& layer : block.layers)
    thicknesses.push_back(layer.thickness);
  return thicknesses;
}

} // namespace

LayeredBlock layered_block(const mechanics::BlockSettings& settings,
                           const std::vector<mechanics::MaterialLayer>& layers,
                           const mechanics::BodyModuli& own, const Grid& grid,
                           const mechanics::Scales& scales) {
  const std::vector<double> interfaces = meshes::interfaces_of(layers, scales);
  std::vector<mechanics::BodyModuli> moduli;
  moduli.reserve(layers.size() + 1);
  for (const mechanics::MaterialLayer& layer : layers)
    moduli.push_back(layer.moduli);
  moduli.push_back(own);
  return bonded_block(meshes::layers_of_block(settings, interfaces,
                                              grid.spacing_x(),
                                              settings.depth.in_si(scales)),
                      interfaces, moduli, settings.far_boundary);
}

BlockProblem problem_of(const FullRequest& request,
                        std::optional<meshes::BlockMesh> mesh) {
  const auto& [grid, block, full, material, mesh_spec, scales, file_mesh] =
      request;
  const int degree = degree_of(block.element);
  const mechanics::BodyModuli own = own_moduli(material, full.bodies);
  const bool is_layered =
      !full.uses_case_mesh || mesh_spec.kind == mechanics::MeshKind::layers;

  // The moduli are computed before the aggregate that they are moved into: if
  // the initialiser of a later member throws, GCC 12 destroys earlier members
  // that were never constructed.
  ModuliField moduli =
      moduli_field(material, scales, own, grid, block.depth.in_si(scales));
  BlockProblem problem{grid, {}, degree, std::move(moduli)};
  if (is_layered) {
    const LayeredBlock layers =
        layered_block(block, material.layers, own, grid, scales);
    if (!mesh)
      mesh =
          meshes::layered_mesh(cells_of(grid, degree), thicknesses_of(layers));
  }
  if (!mesh)
    mesh = mesh_of(request);
  if (full.uses_case_mesh && mesh_spec.kind == mechanics::MeshKind::adaptive)
    problem.adaptive = AdaptiveMesh{mesh_spec.halvings, mesh_spec.moduli_ratio,
                                    mesh_spec.interface_halvings};
  problem.mesh = std::move(*mesh);
  problem.quality = meshes::quality_text(meshes::mesh_quality(problem.mesh));
  if (full.yield_stress)
    problem.law = j2_plasticity(
        full.yield_stress->in_si(scales),
        full.hardening_modulus ? full.hardening_modulus->in_si(scales) : 0.0);
  problem.far_boundary = block.far_boundary;
  problem.sides = full.sides;
  problem.linear_solver = full.linear_solver;
  if (full.bodies == 2)
    problem.counter = material.counter;
  if (full.bodies == 2 && mesh_spec.counter)
    add_counter_mesh(request, problem);
  return problem;
}

BlockProblem problem_on_ranks(const FullRequest& request) {
  if (n_ranks() == 1)
    return problem_of(request);
  RootWork root(&mpi_group());
  std::optional<BlockProblem> problem;
  const std::string mesh = root.value([&] {
    problem = problem_of(request);
    return meshes::bytes_of(problem->mesh);
  });
  return problem ? std::move(*problem)
                 : problem_of(request, meshes::mesh_of_bytes(mesh));
}

} // namespace asperity::fem
