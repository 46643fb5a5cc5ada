#include "fem/case_problem.hpp"

#include "base/require.hpp"
#include "cases/reader/read_case.hpp"
#include "meshes/gmsh_block.hpp"
#include "meshes/graded_layers.hpp"
#include "meshes/hanging_mesh.hpp"
#include "meshes/layered_mesh.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/mesh_quality.hpp"
#include "meshes/valid_mesh.hpp"

#include <algorithm>
#include <stdexcept>

namespace asperity::fem {
namespace {

int degree_of(const cases::FemSettings& settings) {
  return settings.element == cases::Element::q1 ? 1 : 2;
}

/// The grid with one point per cell instead of one point per node.
Grid cells_of(const Grid& nodes, int degree) {
  return {nodes.points_x / degree, nodes.points_y / degree, nodes.length_x,
          nodes.length_y};
}

/// Depths of the interfaces between the material's layers [m].
std::vector<double>
interfaces_of(const std::vector<cases::MaterialLayer>& layers,
              const cases::Scales& scales) {
  std::vector<double> interfaces;
  interfaces.reserve(layers.size());
  double depth = 0.0;
  for (const cases::MaterialLayer& layer : layers)
    interfaces.push_back(depth += layer.thickness.in_si(scales));
  return interfaces;
}

LinearSolver linear_solver_of(cases::LinearSolverChoice choice) {
  switch (choice) {
  case cases::LinearSolverChoice::direct:
    return LinearSolver::direct;
  case cases::LinearSolverChoice::multigrid:
    return LinearSolver::multigrid;
  case cases::LinearSolverChoice::fourier:
    return LinearSolver::fourier;
  case cases::LinearSolverChoice::automatic:
    break;
  }
  return LinearSolver::automatic;
}

meshes::GmshBlock gmsh_parameters(const cases::Case& contact_case,
                                  const cases::FemSettings& settings,
                                  const Grid& grid,
                                  const cases::Scales& scales) {
  const cases::MeshSpec& spec = contact_case.mesh;
  meshes::GmshBlock block;
  block.geometry = spec.geometry;
  block.cells = spec.cells;
  block.length_x = grid.length_x;
  block.length_y = grid.length_y;
  block.depth = settings.depth.in_si(scales);
  block.size_at_contact = spec.size_at_contact.in_si(scales);
  block.size_far = spec.size_far.in_si(scales);
  block.is_periodic = settings.sides == cases::BlockSides::periodic;
  block.fine_radius = spec.fine_radius.in_si(scales);
  if (spec.geometry == cases::MeshGeometry::layered)
    block.interfaces = interfaces_of(contact_case.material.layers, scales);
  if (const auto& inclusion = contact_case.material.inclusion) {
    block.inclusion_radius = inclusion->radius.in_si(scales);
    block.inclusion_depth = inclusion->depth.in_si(scales);
  }
  return block;
}

meshes::BlockMesh mesh_of(const cases::Case& contact_case,
                          const cases::FemSettings& settings, const Grid& grid,
                          const cases::Scales& scales) {
  const cases::MeshSpec& spec = contact_case.mesh;
  if (spec.kind == cases::MeshKind::hanging)
    return meshes::hanging_mesh(cells_of(grid, degree_of(settings)),
                                settings.depth.in_si(scales),
                                spec.cells_a_level);
  if (spec.geometry == cases::MeshGeometry::file)
    return meshes::read_mesh_file(spec.file, spec.file_unit, settings.sides);
  return meshes::gmsh_block(
      gmsh_parameters(contact_case, settings, grid, scales));
}

std::vector<double> thicknesses_of(const LayeredBlock& block) {
  std::vector<double> thicknesses;
  for (const ElasticLayer& layer : block.layers)
    thicknesses.push_back(layer.thickness);
  return thicknesses;
}

/// The moduli of the meshed body: the first of two bodies, or the single one
/// that represents both.
cases::BodyModuli own_moduli(const cases::MaterialSpec& material, int bodies) {
  return bodies == 2 ? material.first_body()
                     : cases::BodyModuli{material.block_youngs_modulus(),
                                         *material.poisson_ratio};
}

} // namespace

LayeredBlock layered_block(const cases::FemSettings& settings,
                           const std::vector<cases::MaterialLayer>& layers,
                           const cases::BodyModuli& own, const Grid& grid,
                           const cases::Scales& scales) {
  // surface_cell_depth is measured in node spacings: the node planes next to
  // the contact surface are that far apart, so 1 gives a cubic cell for Q1 and
  // Q2 alike.
  const double surface_cell =
      settings.surface_cell_depth * degree_of(settings) * grid.spacing_x();
  const std::vector<double> interfaces = interfaces_of(layers, scales);
  std::vector<cases::BodyModuli> moduli;
  moduli.reserve(layers.size() + 1);
  for (const cases::MaterialLayer& layer : layers)
    moduli.push_back(layer.moduli);
  moduli.push_back(own);
  return bonded_block(meshes::graded_layers_with_interfaces(
                          surface_cell, settings.growth, interfaces,
                          settings.depth.in_si(scales)),
                      interfaces, moduli, settings.top);
}

BlockProblem problem_of_case(const FullRequest& request,
                             std::optional<meshes::BlockMesh> mesh) {
  const cases::Case contact_case =
      cases::read_case_text(request.case_text, request.case_path);
  const auto method = std::ranges::find(contact_case.methods, request.method,
                                        &cases::MethodSpec::name);
  if (method == contact_case.methods.end())
    throw std::domain_error("the case has no method " + request.method);
  const auto& settings = std::get<cases::FemSettings>(method->settings);
  const Grid& grid = request.grid;
  const cases::BodyModuli own =
      own_moduli(contact_case.material, settings.bodies);
  const bool is_layered = !settings.uses_case_mesh ||
                          contact_case.mesh.kind == cases::MeshKind::layers;

  // The moduli are computed before the aggregate that they are moved into: if
  // the initialiser of a later member throws, GCC 12 destroys earlier members
  // that were never constructed.
  ModuliField moduli = moduli_field(contact_case.material, request.scales, own,
                                    grid, settings.depth.in_si(request.scales));
  BlockProblem problem{grid, {}, degree_of(settings), std::move(moduli)};
  if (is_layered) {
    const LayeredBlock layers = layered_block(
        settings, contact_case.material.layers, own, grid, request.scales);
    if (!mesh)
      mesh = meshes::layered_mesh(cells_of(grid, problem.degree),
                                  thicknesses_of(layers));
    if (settings.sides == cases::BlockSides::periodic && settings.bodies == 1)
      problem.lattice = layers;
  }
  if (!mesh)
    mesh = mesh_of(contact_case, settings, grid, request.scales);
  problem.mesh = std::move(*mesh);
  meshes::require_valid_mesh(problem.mesh, settings.sides);
  problem.quality = meshes::quality_text(meshes::mesh_quality(problem.mesh));
  problem.top = settings.top;
  problem.sides = settings.sides;
  problem.contact_at = settings.contact_at;
  problem.linear_solver = linear_solver_of(settings.linear_solver);
  if (settings.bodies == 2)
    problem.counter = contact_case.material.counter;
  return problem;
}

} // namespace asperity::fem
