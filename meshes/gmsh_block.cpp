#include "meshes/gmsh_block.hpp"

#include "base/require.hpp"
#include "meshes/facets.hpp"
#include "meshes/gmsh_geometries.hpp"
#include "meshes/gmsh_session.hpp"
#include "meshes/valid_mesh.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace asperity::meshes {
namespace {

using mechanics::MeshGeometry;

/// The exact coordinate of the plane within 1e-8 of a coordinate, which is
/// gmsh's own accuracy; otherwise the coordinate in metres.
double snapped(double value, const std::vector<double>& planes,
               const std::vector<double>& exact, double unit) {
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (std::abs(value - planes[i]) < 1e-8)
      return exact[i];
  return value * unit;
}

/// Converts the mesh to metres and places the vertices of the planes exactly on
/// them.
void scale(BlockMesh& mesh, const GmshBlock& block, double unit) {
  const GmshBlock scaled = in_units_of(block, unit);
  const std::array<std::vector<double>, 3> planes = {
      {{0.0, scaled.length_x}, {0.0, scaled.length_y}, depths_of(scaled)}};
  const std::array<std::vector<double>, 3> exact = {
      {{0.0, block.length_x}, {0.0, block.length_y}, depths_of(block)}};
  for (Place& vertex : mesh.vertices)
    for (std::size_t d = 0; d < 3; ++d)
      vertex[d] = snapped(vertex[d], planes[d], exact[d], unit);
  mesh.length_x = block.length_x;
  mesh.length_y = block.length_y;
  mesh.depth = block.depth;
}

FaceGroup side_of(const BlockMesh& mesh, const Facet& facet) {
  if (lies_on_plane(mesh, facet, 2, 0.0))
    return FaceGroup::contact;
  if (lies_on_plane(mesh, facet, 2, mesh.depth))
    return FaceGroup::far_boundary;
  if (const auto side = lateral_side_of(mesh, facet, 0.0))
    return *side;
  throw std::domain_error(
      fmt::format("gmsh: the mesh has a hole at {}",
                  place_text(centre_of_facet(mesh, facet.vertices))));
}

} // namespace

std::vector<std::string> group_names_of(const GmshBlock& block) {
  if (block.geometry == MeshGeometry::inclusion)
    return {"block", "inclusion"};
  if (block.geometry != MeshGeometry::layered)
    return {"block"};
  std::vector<std::string> names;
  for (std::size_t i = 0; i <= block.interfaces.size(); ++i)
    names.push_back(fmt::format("layer {}", i + 1));
  return names;
}

BlockMesh gmsh_block(const GmshBlock& block) {
  require_gmsh_block(block);
  const double unit = largest_extent(block);
  const GmshBlock scaled = in_units_of(block, unit);
  BlockMesh mesh;
  in_gmsh([&] {
    mesh = mesh_by_gmsh(hexahedra_of(scaled), group_names_of(scaled));
  });
  scale(mesh, block, unit);
  for (const Facet& facet : boundary_facets(mesh))
    mesh.faces.push_back({facet.vertices, side_of(mesh, facet)});
  require_positive_cells(mesh);
  return mesh;
}

} // namespace asperity::meshes
