// Reads [mesh] and [mesh.counter].
#include "input/reader/read_parts.hpp"

#include <string>

namespace asperity::cases {
namespace {

/// Reads [mesh.counter]. A sphere has the radius of [surface], which describes
/// the distance of its end from the block.
mechanics::CounterMeshSpec read_counter_mesh(TableReader table,
                                             const Case& read) {
  mechanics::CounterMeshSpec counter;
  table.read(counter);
  if (counter.shape != mechanics::CounterShape::sphere)
    return counter;
  const bool is_sphere = read.surface.kind == mechanics::SurfaceKind::sphere;
  if (table.has("shape") && !is_sphere && !read.surface.form_radius)
    table.refuse(table.said_by("shape"),
                 "needs the radius of the sphere in [surface]: kind = "
                 "\"sphere\" with radius, or a rough surface with form_radius");
  counter.radius = {is_sphere ? read.surface.radius
                              : read.surface.form_radius.value_or(0.0),
                    mechanics::ReferenceUnit::si};
  for (const char* key : {"radius", "offset_x", "offset_y"})
    if (table.has(key))
      table.refuse(table.said_by(key),
                   "does not apply to shape = \"sphere\", which has the radius "
                   "and the place of the sphere of [surface]");
  return counter;
}

} // namespace

mechanics::MeshSpec read_mesh(TableReader table, const Case& read) {
  mechanics::MeshSpec mesh;
  if (const Node* const counter = table.sub_table("counter"))
    mesh.counter =
        read_counter_mesh(table.part(*counter, "mesh.counter"), read);
  table.read(mesh);
  if (mesh.interface_halvings.value_or(0) > mesh.halvings)
    table.refuse(table.said_by("interface_halvings"),
                 "must not exceed mesh.halvings = " +
                     std::to_string(mesh.halvings));
  if (mesh.kind != mechanics::MeshKind::gmsh)
    return mesh;
  if (mesh.geometry == mechanics::MeshGeometry::layered &&
      read.material.layers.empty())
    table.refuse(table.said_by("geometry"), "material.layers is missing");
  if (mesh.geometry == mechanics::MeshGeometry::inclusion &&
      !read.material.inclusion)
    table.refuse(table.said_by("geometry"),
                 "the table [material.inclusion] is missing");
  return mesh;
}

} // namespace asperity::cases
