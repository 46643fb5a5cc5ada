// Reads the layers, inclusion and variation of [material], and the keys of
// [fem] for the full block.
#include "cases/reader/read_parts.hpp"
#include "cases/reader/table_reader.hpp"
#include "input/expression.hpp"

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
    variation.file = table.path("file", folder);
    break;
  }
  return variation;
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
  if (const Node* const node = material.sub_table("inclusion"))
    spec.inclusion = read_inclusion(*node, mistakes);
  if (const Node* const node = material.sub_table("variation"))
    spec.variation = read_variation(*node, folder, mistakes);
}

namespace {

/// Refuses the stiffness of the contact for blocks that do not find it.
void refuse_stiffness(TableReader& table, const mechanics::FemSettings& fem) {
  const auto refuse_if = [&](bool is_refused, const std::string& key,
                             const std::string& needed) {
    if (fem.full.has_stiffness && is_refused)
      table.refuse(table.said_by("stiffness"),
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
      table.refuse(table.said_by(key), "needs solver = \"full\"");
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
    table.refuse(table.said_by("mesh"), "the table [mesh] is missing");
  if (fem.full.contact_at == mechanics::ContactPoints::gauss &&
      fem.contact.law == mechanics::ContactLaw::hard)
    table.refuse(
        table.said_by("contact_at"),
        "hard (unilateral) contact at more points than the contact surface has "
        "nodes is overconstrained; use contact = \"augmented\" or \"penalty\"");
}

} // namespace asperity::cases
