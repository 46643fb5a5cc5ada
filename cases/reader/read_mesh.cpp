// Reads [mesh] and [mesh.counter].
#include "cases/reader/read_parts.hpp"
#include "cases/reader/table_reader.hpp"

#include <string>

namespace asperity::cases {
namespace {

/// Reads [mesh.counter]. A sphere has the radius of [surface], which describes
/// the distance of its end from the block.
mechanics::CounterMeshSpec read_counter_mesh(const Node& node, const Case& read,
                                             Mistakes& mistakes) {
  TableReader table(node, vocabulary_table("mesh.counter"), mistakes);
  table.refuse_unknown();
  mechanics::CounterMeshSpec counter;
  counter.shape = table.choice("shape", counter.shape);
  if (table.has("height"))
    counter.height = table.quantity("height");
  if (table.has("size_at_contact"))
    counter.size_at_contact = table.quantity("size_at_contact");
  counter.size_far = table.quantity("size_far");
  if (table.has("fine_radius"))
    counter.fine_radius = table.quantity("fine_radius");
  counter.offset_x = table.quantity("offset_x");
  counter.offset_y = table.quantity("offset_y");
  if (counter.shape != mechanics::CounterShape::sphere) {
    counter.radius = table.quantity("radius");
    return counter;
  }
  const bool is_sphere = read.surface.kind == mechanics::SurfaceKind::sphere;
  const Node* const shape = node.find("shape"); // missed above if there is none
  if (shape != nullptr && !is_sphere && !read.surface.form_radius)
    table.refuse(*shape,
                 "needs the radius of the sphere in [surface]: kind = "
                 "\"sphere\" with radius, or a rough surface with form_radius");
  counter.radius = {is_sphere ? read.surface.radius
                              : read.surface.form_radius.value_or(0.0),
                    mechanics::ReferenceUnit::si};
  for (const char* key : {"radius", "offset_x", "offset_y"})
    if (table.has(key))
      table.refuse(*node.find(key),
                   "does not apply to shape = \"sphere\", which has the radius "
                   "and the place of the sphere of [surface]");
  return counter;
}

} // namespace

mechanics::MeshSpec read_mesh(const Node& node, const std::string& folder,
                              const Case& read, Mistakes& mistakes) {
  TableReader table(node, vocabulary_table("mesh"), mistakes);
  table.refuse_unknown({"counter"});
  mechanics::MeshSpec mesh;
  if (const Node* const counter = table.sub_table("counter"))
    mesh.counter = read_counter_mesh(*counter, read, mistakes);
  mesh.kind = table.choice("kind", mesh.kind);
  mesh.cells_a_level = table.integer("cells_a_level");
  mesh.halvings = table.integer("halvings");
  mesh.moduli_ratio = table.number("moduli_ratio");
  if (const Node* const own = table.node().find("interface_halvings")) {
    mesh.interface_halvings = table.integer("interface_halvings");
    if (*mesh.interface_halvings > mesh.halvings)
      table.refuse(*own, "must not exceed mesh.halvings = " +
                             std::to_string(mesh.halvings));
  }
  mesh.geometry = table.choice("geometry", mesh.geometry);
  mesh.cells = table.choice("cells", mesh.cells);
  mesh.size_at_contact = table.quantity("size_at_contact");
  mesh.size_far = table.quantity("size_far");
  mesh.fine_radius = table.quantity("fine_radius");
  mesh.file_unit = table.number("file_unit");
  mesh.allow_commands = table.boolean("allow_commands");
  if (mesh.kind != mechanics::MeshKind::gmsh)
    return mesh;
  if (mesh.geometry == mechanics::MeshGeometry::file)
    mesh.file = table.path("file", folder);
  if (mesh.geometry == mechanics::MeshGeometry::layered &&
      read.material.layers.empty())
    table.refuse(*node.find("geometry"), "material.layers is missing");
  if (mesh.geometry == mechanics::MeshGeometry::inclusion &&
      !read.material.inclusion)
    table.refuse(*node.find("geometry"),
                 "the table [material.inclusion] is missing");
  return mesh;
}

} // namespace asperity::cases
