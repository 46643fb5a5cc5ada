// Reads the layers, inclusion and variation of [material], [mesh], and the keys
// of [fem] for the full block.
#include "cases/reader/read_parts.hpp"
#include "cases/reader/table_reader.hpp"
#include "input/expression.hpp"

#include <filesystem>
#include <stdexcept>

namespace asperity::cases {
namespace {

mechanics::BodyModuli read_moduli(TableReader& table) {
  return {table.number("youngs_modulus"), table.number("poisson_ratio")};
}

mechanics::MaterialLayer read_layer(const Node& node, TableReader& material,
                                    Mistakes& mistakes) {
  if (!node.is_table()) {
    material.refuse(node, "must be a table of thickness, youngs_modulus and "
                          "poisson_ratio");
    return {};
  }
  TableReader layer(node, vocabulary_table("material.layer"), mistakes);
  layer.refuse_unknown();
  return {layer.quantity("thickness"), read_moduli(layer)};
}

std::string read_path(TableReader& table, const std::string& folder) {
  const std::string file = table.text("file");
  return file.empty() ? file : (std::filesystem::path(folder) / file).string();
}

/// Returns the sub-table of that name, or null if there is none or if it is not
/// a table.
const Node* sub_table(TableReader& parent, const std::string& name) {
  const Node* const node = parent.node().find(name);
  if (node && !node->is_table())
    parent.refuse(*node, "must be a table: [" + node->path + "]");
  return node && node->is_table() ? node : nullptr;
}

mechanics::MaterialInclusion read_inclusion(const Node& node,
                                            Mistakes& mistakes) {
  TableReader table(node, vocabulary_table("material.inclusion"), mistakes);
  table.refuse_unknown();
  mechanics::MaterialInclusion inclusion{
      table.quantity("radius"), table.quantity("depth"), read_moduli(table)};
  if (inclusion.radius.reference == inclusion.depth.reference &&
      inclusion.depth.value > 0.0 &&
      inclusion.depth.value <= inclusion.radius.value)
    table.refuse(*node.find("depth"), "must be larger than the radius");
  return inclusion;
}

/// Returns the text of a formula after checking that it can be parsed.
std::string read_expression(TableReader& table, const std::string& key) {
  std::string text = table.text(key);
  try {
    if (!text.empty())
      input::Expression{text};
  } catch (const std::domain_error& error) {
    table.refuse(*table.node().find(key),
                 std::string("must be an expression of x, y and z: ") +
                     error.what());
  }
  return text;
}

mechanics::MaterialVariation read_variation(const Node& node,
                                            const std::string& folder,
                                            Mistakes& mistakes) {
  TableReader table(node, vocabulary_table("material.variation"), mistakes);
  table.refuse_unknown();
  mechanics::MaterialVariation variation;
  variation.kind = table.choice("kind", variation.kind);
  switch (variation.kind) {
  case mechanics::VariationKind::function:
    variation.factor = read_expression(table, "factor");
    break;
  case mechanics::VariationKind::random:
    variation.spread = table.number("spread");
    variation.seed = static_cast<std::uint64_t>(table.integer("seed"));
    if (table.node().find("edge"))
      variation.edge = table.quantity("edge");
    break;
  case mechanics::VariationKind::table:
    variation.file = read_path(table, folder);
    break;
  }
  return variation;
}

/// Returns the entry of `key` in a method, or the table of the method if the
/// key is not given.
const Node& said_by(TableReader& table, const std::string& key) {
  const Node* const found = table.node().find(key);
  return found ? *found : table.node();
}

} // namespace

void read_block(TableReader& material, const std::string& folder,
                mechanics::MaterialSpec& spec, Mistakes& mistakes) {
  if (const Node* const layers = material.node().find("layers")) {
    if (layers->type != NodeType::list || layers->list.empty())
      material.refuse(*layers, "must be a list of tables");
    for (const Node& layer : layers->list)
      spec.layers.push_back(read_layer(layer, material, mistakes));
  }
  if (const Node* const node = sub_table(material, "inclusion"))
    spec.inclusion = read_inclusion(*node, mistakes);
  if (const Node* const node = sub_table(material, "variation"))
    spec.variation = read_variation(*node, folder, mistakes);
}

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
  if (const Node* const counter = sub_table(table, "counter"))
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
  if (mesh.kind != mechanics::MeshKind::gmsh)
    return mesh;
  if (mesh.geometry == mechanics::MeshGeometry::file)
    mesh.file = read_path(table, folder);
  if (mesh.geometry == mechanics::MeshGeometry::layered &&
      read.material.layers.empty())
    table.refuse(*node.find("geometry"), "material.layers is missing");
  if (mesh.geometry == mechanics::MeshGeometry::inclusion &&
      !read.material.inclusion)
    table.refuse(*node.find("geometry"),
                 "the table [material.inclusion] is missing");
  return mesh;
}

namespace {

/// Refuses the stiffness of the contact for blocks that do not find it.
void refuse_stiffness(TableReader& table, const mechanics::FemSettings& fem) {
  const auto refuse_if = [&](bool is_refused, const std::string& key,
                             const std::string& needed) {
    if (fem.full.has_stiffness && is_refused)
      table.refuse(said_by(table, "stiffness"),
                   "cannot be combined with " + key + "; it needs " + needed);
  };
  refuse_if(fem.full.contact_at == mechanics::ContactPoints::gauss,
            "contact_at = \"gauss\"", "contact_at = \"nodes\"");
  refuse_if(fem.full.bodies == 2, "bodies = 2", "bodies = 1");
  refuse_if(fem.block.far_boundary != mechanics::FarBoundary::clamped,
            "this far boundary (top)", "top = \"clamped\"");
}

} // namespace

void read_full_block(TableReader& table, bool has_mesh,
                     mechanics::FemSettings& fem) {
  fem.full.sides = table.choice("sides", fem.full.sides);
  fem.full.linear_solver =
      table.choice("linear_solver", fem.full.linear_solver);
  fem.full.contact_at = table.choice("contact_at", fem.full.contact_at);
  fem.full.height_interpolation =
      table.choice("height_interpolation", fem.full.height_interpolation);
  fem.full.bodies = table.integer("bodies");
  fem.full.has_stiffness = table.boolean("stiffness");
  const bool is_full = fem.solver == mechanics::FemSolver::full;
  fem.full.uses_case_mesh = is_full && has_mesh;
  if (table.has("mesh"))
    fem.full.uses_case_mesh = table.word("mesh").value_or(0) == 1;
  const auto only_full = [&](bool is_asked, const std::string& key) {
    if (is_asked && !is_full)
      table.refuse(said_by(table, key), "needs solver = \"full\"");
  };
  only_full(fem.full.uses_case_mesh, "mesh");
  only_full(fem.full.sides == mechanics::BlockSides::free, "sides");
  only_full(fem.full.linear_solver != mechanics::LinearSolver::automatic,
            "linear_solver");
  only_full(fem.full.contact_at == mechanics::ContactPoints::gauss,
            "contact_at");
  only_full(fem.full.height_interpolation !=
                mechanics::HeightInterpolation::bicubic,
            "height_interpolation");
  only_full(fem.full.bodies == 2, "bodies");
  only_full(fem.full.has_stiffness, "stiffness");
  refuse_stiffness(table, fem);
  if (fem.full.uses_case_mesh && !has_mesh)
    table.refuse(said_by(table, "mesh"), "the table [mesh] is missing");
  if (fem.full.contact_at == mechanics::ContactPoints::gauss &&
      fem.contact.law == mechanics::ContactLaw::hard)
    table.refuse(
        said_by(table, "contact_at"),
        "hard (unilateral) contact at more points than the contact surface has "
        "nodes is overconstrained; use contact = \"augmented\" or \"penalty\"");
}

/// Checks what layers need besides their own values.
void check_layers(const Node& file, const Case& read, Mistakes& mistakes) {
  if (read.material.layers.empty())
    return;
  if (!read.material.poisson_ratio)
    mistakes.add(entry_of(file, "material", "layers").place,
                 "material.layers needs material.poisson_ratio, which is "
                 "missing");
  if (!read.material.counter)
    return;
  for (const MethodSpec& method : read.methods) {
    const auto* const fem =
        std::get_if<mechanics::FemSettings>(&method.settings);
    if (std::holds_alternative<mechanics::HalfspaceSettings>(method.settings) ||
        (fem != nullptr && fem->full.bodies == 1))
      mistakes.add(entry_of(file, "material", "layers").place,
                   method.name + ": no single block represents a layered body "
                                 "and [material.counter]; use [fem] with "
                                 "solver = \"full\" and bodies = 2");
  }
}

/// Checks what an adaptive mesh needs.
void check_adaptive(const Node& file, const Case& read,
                    const MethodSpec& method, const mechanics::FemSettings& fem,
                    Mistakes& mistakes) {
  const Node& kind = entry_of(file, "mesh", "kind");
  if (fem.full.bodies == 2)
    mistakes.add(kind.place,
                 "mesh.kind = \"adaptive\" cannot be combined with " +
                     method.name + ".bodies = 2; use another kind of mesh");
  const auto& variation = read.material.variation;
  if (variation && variation->kind == mechanics::VariationKind::random &&
      !variation->edge)
    mistakes.add(kind.place,
                 "mesh.kind = \"adaptive\" needs material.variation.edge, "
                 "because the factor of a cell would change when the cell is "
                 "halved");
  if (!read.surface.points)
    return;
  const int step = degree_of(fem.block.element) << read.mesh.halvings;
  if (*read.surface.points % step != 0 || *read.surface.points / step < 2)
    mistakes.add(
        entry_of(file, "mesh", "halvings").place,
        "mesh.halvings = " + std::to_string(read.mesh.halvings) + " halves " +
            "cells of " + std::to_string(step) + " node spacings, but " +
            method.name + " has " + std::to_string(*read.surface.points) +
            " points per side; they must be a multiple of that, and at least "
            "twice as many");
}

/// Checks what a counter-body of its own mesh needs.
void check_counter_mesh(const Node& file, const Case& read,
                        Mistakes& mistakes) {
  const Node& place = entry_of(file, "mesh", "counter");
  bool is_used = false;
  for (const MethodSpec& method : read.methods) {
    const auto* const fem =
        std::get_if<mechanics::FemSettings>(&method.settings);
    if (fem == nullptr || fem->full.bodies != 2)
      continue;
    is_used = true;
    if (fem->block.far_boundary == mechanics::FarBoundary::pressure)
      mistakes.add(place.place,
                   "mesh.counter cannot be combined with " + method.name +
                       ".top = \"pressure\": a body of finite size would tilt; "
                       "use top = \"clamped\" or \"sliding\"");
    if (fem->full.uses_case_mesh &&
        read.mesh.cells == mechanics::MeshCells::tetrahedra)
      mistakes.add(place.place,
                   "mesh.counter consists of hexahedra and cannot be combined "
                   "with mesh.cells = \"tetrahedra\"");
  }
  if (!is_used)
    mistakes.add(place.place,
                 "mesh.counter describes a second meshed body, but "
                 "no method has solver = \"full\" and bodies = 2");
}

/// A rough surface on a form is not nominally flat.
void check_form(const Node& file, const Case& read, Mistakes& mistakes) {
  for (const MethodSpec& method : read.methods)
    if (std::holds_alternative<mechanics::TheorySettings>(method.settings))
      mistakes.add(entry_of(file, "surface", "form_radius").place,
                   "surface.form_radius cannot be combined with " +
                       method.name +
                       ", which assumes a nominally flat surface");
}

void check_block(const Node& file, const Case& read, Mistakes& mistakes) {
  check_layers(file, read, mistakes);
  if (read.mesh.counter)
    check_counter_mesh(file, read, mistakes);
  if (read.surface.form_radius)
    check_form(file, read, mistakes);
  for (const MethodSpec& method : read.methods) {
    const auto* const fem =
        std::get_if<mechanics::FemSettings>(&method.settings);
    if (!fem)
      continue;
    const Node& place = entry_of(file, method.name, "solver");
    const bool is_full = fem->solver == mechanics::FemSolver::full;
    if (!is_full && (read.material.inclusion || read.material.variation))
      mistakes.add(place.place,
                   method.name + ": a block with [material." +
                       (read.material.inclusion ? "inclusion" : "variation") +
                       "] is not laterally uniform; it needs solver = "
                       "\"full\"");
    if (fem->full.bodies == 2 && !read.material.counter)
      mistakes.add(entry_of(file, method.name, "bodies").place,
                   method.name + ".bodies = 2, but the table "
                                 "[material.counter] is missing");
    if (fem->full.bodies == 2 &&
        fem->contact.law == mechanics::ContactLaw::hard)
      mistakes.add(entry_of(file, method.name, "bodies").place,
                   method.name +
                       ".bodies = 2 cannot be combined with hard (unilateral) "
                       "contact; use contact = \"augmented\" or \"penalty\"");
    if (fem->full.uses_case_mesh &&
        read.mesh.kind == mechanics::MeshKind::adaptive)
      check_adaptive(file, read, method, *fem, mistakes);
    const bool is_lattice =
        fem->full.sides == mechanics::BlockSides::periodic &&
        (!fem->full.uses_case_mesh ||
         read.mesh.kind == mechanics::MeshKind::layers);
    if (fem->full.linear_solver == mechanics::LinearSolver::fourier &&
        (!is_lattice || fem->full.bodies == 2))
      mistakes.add(entry_of(file, method.name, "linear_solver").place,
                   method.name + ".linear_solver = \"fourier\" needs one "
                                 "periodic block of graded layers");
  }
}

} // namespace asperity::cases
