// Reads [material] with its layers, inclusion and variation.
#include "input/expression.hpp"
#include "input/reader/read_parts.hpp"

#include <stdexcept>

namespace asperity::cases {
namespace {

/// Returns E / (1 - nu^2) [Pa]; 0 if a value is missing or wrong.
double plane_strain_modulus(const mechanics::BodyModuli& body) {
  return body.youngs_modulus / (1.0 - body.poisson_ratio * body.poisson_ratio);
}

void read_moduli(TableReader& material, bool is_poisson_needed,
                 mechanics::MaterialSpec& spec) {
  material.read(spec);
  if (material.has("contact_modulus")) {
    if (material.has("youngs_modulus"))
      material.refuse_both("contact_modulus", "youngs_modulus");
  } else if (material.has("youngs_modulus")) {
    mechanics::BodyModuli own;
    material.read(own);
    own.poisson_ratio = spec.poisson_ratio.value_or(0.0);
    spec.contact_modulus = plane_strain_modulus(own);
    material.require("poisson_ratio");
  } else {
    material.complain_missing("youngs_modulus", " (or contact_modulus)");
  }
  if (is_poisson_needed && !material.has("youngs_modulus"))
    material.require("poisson_ratio", ", which a block of finite depth needs");
}

void read_counter(const Node& node, TableReader& material,
                  mechanics::MaterialSpec& spec) {
  spec.counter.emplace();
  material.part(node, "material.counter").read(*spec.counter);
  const double modulus = plane_strain_modulus(*spec.counter);
  if (material.has("contact_modulus"))
    material.complain(node, "cannot be combined with material.contact_modulus, "
                            "which is that of both bodies together");
  else if (modulus > 0.0 && spec.contact_modulus > 0.0)
    spec.contact_modulus = 1.0 / (1.0 / spec.contact_modulus + 1.0 / modulus);
}

void read_layers(const Node& layers, TableReader& material,
                 mechanics::MaterialSpec& spec) {
  if (layers.type != NodeType::list || layers.list.empty())
    material.refuse(layers, "must be a list of tables");
  for (const Node& node : layers.list) {
    mechanics::MaterialLayer& layer = spec.layers.emplace_back();
    if (!node.is_table()) {
      material.refuse(node, "must be a table of thickness, youngs_modulus and "
                            "poisson_ratio");
      continue;
    }
    TableReader table = material.part(node, "material.layer");
    table.read(layer);
    table.read(layer.moduli);
  }
}

mechanics::MaterialInclusion read_inclusion(TableReader table) {
  mechanics::MaterialInclusion inclusion;
  table.read(inclusion);
  table.read(inclusion.moduli);
  if (inclusion.radius.reference == inclusion.depth.reference &&
      inclusion.depth.value > 0.0 &&
      inclusion.depth.value <= inclusion.radius.value)
    table.refuse(table.said_by("depth"), "must be larger than the radius");
  return inclusion;
}

mechanics::MaterialVariation read_variation(TableReader table) {
  mechanics::MaterialVariation variation;
  table.read(variation);
  try {
    if (!variation.factor.empty())
      input::Expression{variation.factor};
  } catch (const std::domain_error& error) {
    table.refuse(table.said_by("factor"),
                 std::string("must be an expression of x, y and z: ") +
                     error.what());
  }
  return variation;
}

} // namespace

mechanics::MaterialSpec read_material(TableReader material,
                                      bool is_poisson_needed) {
  mechanics::MaterialSpec spec;
  read_moduli(material, is_poisson_needed, spec);
  if (const Node* const node = material.sub_table("counter"))
    read_counter(*node, material, spec);
  if (const Node* const node = material.node().find("layers"))
    read_layers(*node, material, spec);
  if (const Node* const node = material.sub_table("inclusion"))
    spec.inclusion = read_inclusion(material.part(*node, "material.inclusion"));
  if (const Node* const node = material.sub_table("variation"))
    spec.variation = read_variation(material.part(*node, "material.variation"));
  return spec;
}

} // namespace asperity::cases
