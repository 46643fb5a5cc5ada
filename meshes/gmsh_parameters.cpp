// The parameters of a block that gmsh meshes, and the number of its nodes. They
// are apart from gmsh_block.cpp, because the program examines them without
// gmsh.
#include "base/refused_argument.hpp"
#include "base/require.hpp"
#include "meshes/gmsh_geometries.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asperity::meshes {
namespace {

using mechanics::MeshGeometry;

void check_geometry(const GmshBlock& block) {
  const double half = 0.5 * std::min(block.length_x, block.length_y);
  if (block.geometry == MeshGeometry::file)
    throw std::domain_error("gmsh_block: the geometry is that of a file");
  if (block.geometry == MeshGeometry::indentation)
    require_between(Argument{"fine_radius", "mesh.fine_radius"},
                    block.fine_radius, block.size_at_contact,
                    0.8 * std::min(half, block.depth), "m");
  if (block.geometry == MeshGeometry::layered) {
    double above = 0.0;
    for (const double interface : block.interfaces) {
      require_between(Argument{"depth of an interface", "material.layers"},
                      interface, above + 1e-6 * block.depth,
                      block.depth * (1.0 - 1e-6), "m");
      above = interface;
    }
  }
  if (block.geometry == MeshGeometry::inclusion) {
    require_positive(Argument{"inclusion_radius", "material.inclusion.radius"},
                     block.inclusion_radius, "m");
    const double radius = block.inclusion_radius * (1.0 + 1e-3);
    require_between(Argument{"inclusion_radius", "material.inclusion.radius"},
                    block.inclusion_radius, 0.0, half / (1.0 + 1e-3), "m");
    require_between(Argument{"inclusion_depth", "material.inclusion.depth"},
                    block.inclusion_depth, radius, block.depth - radius, "m");
  }
}

} // namespace

std::vector<double>
interfaces_of(const std::vector<mechanics::MaterialLayer>& layers,
              const mechanics::Scales& scales) {
  std::vector<double> interfaces;
  interfaces.reserve(layers.size());
  double depth = 0.0;
  for (const mechanics::MaterialLayer& layer : layers)
    interfaces.push_back(depth += layer.thickness.in_si(scales));
  return interfaces;
}

GmshBlock gmsh_parameters(const mechanics::MeshSpec& spec,
                          const mechanics::MaterialSpec& material, double depth,
                          const Grid& grid, const mechanics::Scales& scales) {
  GmshBlock block;
  block.geometry = spec.geometry;
  block.length_x = grid.length_x;
  block.length_y = grid.length_y;
  block.depth = depth;
  block.size_at_contact = spec.size_at_contact.in_si(scales);
  block.size_far = spec.size_far.in_si(scales);
  block.fine_radius = spec.fine_radius.in_si(scales);
  if (spec.geometry == MeshGeometry::layered)
    block.interfaces = interfaces_of(material.layers, scales);
  if (const auto& inclusion = material.inclusion) {
    block.inclusion_radius = inclusion->radius.in_si(scales);
    block.inclusion_depth = inclusion->depth.in_si(scales);
  }
  return block;
}

void require_gmsh_block(const GmshBlock& block) {
  require_positive("length_x", block.length_x, "m");
  require_positive("length_y", block.length_y, "m");
  require_positive("depth", block.depth, "m");
  const double least = std::min({block.length_x, block.length_y, block.depth});
  require_positive(Argument{"size_at_contact", "mesh.size_at_contact"},
                   block.size_at_contact, "m");
  require_between(Argument{"size_at_contact", "mesh.size_at_contact"},
                  block.size_at_contact, 1e-4 * least, 0.25 * least, "m");
  require_positive(Argument{"size_far", "mesh.size_far"}, block.size_far, "m");
  require_between(Argument{"size_far", "mesh.size_far"}, block.size_far,
                  block.size_at_contact,
                  std::max({block.length_x, block.length_y, block.depth}), "m");
  check_geometry(block);
}

double gmsh_nodes(const GmshBlock& block, int degree) {
  return hexahedra_of(in_units_of(block, largest_extent(block))).nodes(degree);
}

double largest_extent(const GmshBlock& block) {
  return std::max({block.length_x, block.length_y, block.depth});
}

GmshBlock in_units_of(GmshBlock block, double unit) {
  for (double* length :
       {&block.length_x, &block.length_y, &block.depth, &block.size_at_contact,
        &block.size_far, &block.fine_radius, &block.inclusion_radius,
        &block.inclusion_depth})
    *length /= unit;
  for (double& interface : block.interfaces)
    interface /= unit;
  return block;
}

std::vector<double> depths_of(const GmshBlock& block) {
  std::vector<double> depths = {0.0};
  if (block.geometry == MeshGeometry::layered)
    depths.insert(depths.end(), block.interfaces.begin(),
                  block.interfaces.end());
  depths.push_back(block.depth);
  return depths;
}

double size_at_depth(const GmshBlock& block, double z) {
  return std::lerp(block.size_at_contact, block.size_far, z / block.depth);
}

} // namespace asperity::meshes
