// What the plan knows of a block before it is meshed.
#include "fem/full_request.hpp"
#include "meshes/counter_body.hpp"
#include "meshes/gmsh_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "meshes/layers/graded_layers.hpp"

#include <algorithm>

namespace asperity::fem {
namespace {

using mechanics::MeshKind;

/// Part of the nodes of a mesh with hanging nodes that one which follows the
/// contact has. With 1 to 7 % of the surface in contact it was between a
/// twelfth and two fifths. Moduli that vary may need about all of them.
constexpr double share_of_adaptive = 0.18;

MeshKind kind_of(const FullRequest& request) {
  return request.full.uses_case_mesh ? request.mesh.kind : MeshKind::layers;
}

double nodes_of_layers(const FullRequest& request, const Grid& cells,
                       double depth) {
  const auto layers = static_cast<double>(
      meshes::layers_of_block(
          request.block,
          meshes::interfaces_of(request.material.layers, request.scales),
          request.grid.spacing_x(), depth)
          .size());
  const double degree = degree_of(request.block.element);
  return (degree * cells.points_x + 1.0) * (degree * cells.points_y + 1.0) *
         (degree * layers + 1.0);
}

double nodes_by_gmsh(const FullRequest& request, double depth) {
  const int degree = degree_of(request.block.element);
  if (request.file_mesh)
    return static_cast<double>(request.file_mesh->vertices.size()) * degree *
           degree * degree;
  return meshes::gmsh_nodes(
      meshes::gmsh_parameters(request.mesh, request.material, depth,
                              request.grid, request.scales),
      degree);
}

double nodes_of_block(const FullRequest& request) {
  const mechanics::MaterialSpec& material = request.material;
  const int degree = degree_of(request.block.element);
  const double depth = request.block.depth.in_si(request.scales);
  const Grid cells{request.grid.points_x / degree,
                   request.grid.points_y / degree, request.grid.length_x,
                   request.grid.length_y};
  const bool is_uniform =
      material.layers.empty() && !material.inclusion && !material.variation;
  switch (kind_of(request)) {
  case MeshKind::layers:
    return nodes_of_layers(request, cells, depth);
  case MeshKind::hanging:
    return meshes::hanging_nodes(cells, depth, request.mesh.cells_a_level,
                                 degree);
  case MeshKind::adaptive:
    return (is_uniform ? share_of_adaptive : 1.0) *
           meshes::hanging_nodes(cells, depth, 4, degree);
  case MeshKind::gmsh:
    break;
  }
  return nodes_by_gmsh(request, depth);
}

double nodes_of_counter(const FullRequest& request, double own) {
  if (request.full.bodies == 1)
    return 0.0;
  if (!request.mesh.counter)
    return own;
  const int degree = degree_of(request.block.element);
  const double edge = kind_of(request) == MeshKind::gmsh
                          ? request.mesh.size_at_contact.in_si(request.scales)
                          : degree * request.grid.spacing_x();
  return meshes::counter_nodes(
      mechanics::counter_body_of(*request.mesh.counter, request.scales,
                                 {request.grid.length_x, request.grid.length_y,
                                  request.full.sides, edge}),
      degree);
}

MeshStructure structure_of(const FullRequest& request) {
  const MeshKind kind = kind_of(request);
  const bool is_one = request.full.bodies == 1;
  if (is_one && kind == MeshKind::layers)
    return MeshStructure::box_grid;
  if (is_one && kind != MeshKind::gmsh)
    return MeshStructure::halved;
  const bool has_hexahedra =
      !request.file_mesh ||
      request.file_mesh->shape == meshes::CellShape::hexahedron;
  return has_hexahedra && degree_of(request.block.element) == 2 &&
                 (is_one || request.mesh.counter)
             ? MeshStructure::hexahedra
             : MeshStructure::other;
}

/// Whether every material of the bodies is compressible. A variation changes
/// Young's modulus only.
bool has_compressible_cells(const FullRequest& request) {
  const mechanics::MaterialSpec& material = request.material;
  std::vector<mechanics::BodyModuli> all{
      own_moduli(material, request.full.bodies)};
  for (const mechanics::MaterialLayer& layer : material.layers)
    all.push_back(layer.moduli);
  if (material.inclusion)
    all.push_back(material.inclusion->moduli);
  if (request.full.bodies == 2)
    all.push_back(*material.counter);
  return std::ranges::all_of(all, [](const mechanics::BodyModuli& body) {
    return is_compressible(moduli(body));
  });
}

} // namespace

BlockTraits expected_block(const FullRequest& request, int ranks) {
  const double own = nodes_of_block(request);
  return {.requested = request.full.linear_solver,
          .unknowns = 3.0 * (own + nodes_of_counter(request, own)),
          .ranks = ranks,
          .structure = structure_of(request),
          .is_compressible = has_compressible_cells(request),
          .is_nonlinear = request.full.yield_stress.has_value()};
}

} // namespace asperity::fem
