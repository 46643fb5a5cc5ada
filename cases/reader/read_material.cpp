#include "cases/reader/read_parts.hpp"
#include "cases/reader/table_reader.hpp"

namespace asperity::cases {
namespace {

/// Returns E / (1 - nu^2) [Pa]; 0 if a value is missing or wrong.
double plane_strain_modulus(TableReader& body) {
  const double youngs_modulus = body.number("youngs_modulus");
  const double poisson_ratio = body.number("poisson_ratio");
  return youngs_modulus / (1.0 - poisson_ratio * poisson_ratio);
}

void read_counter(const Node& node, TableReader& material,
                  mechanics::MaterialSpec& spec, Mistakes& mistakes) {
  TableReader counter(node, vocabulary_table("material.counter"), mistakes);
  counter.refuse_unknown();
  const double modulus = plane_strain_modulus(counter);
  spec.counter = {counter.number("youngs_modulus"),
                  counter.number("poisson_ratio")};
  if (material.has("contact_modulus"))
    material.complain(node, "cannot be combined with material.contact_modulus, "
                            "which is that of both bodies together");
  else if (modulus > 0.0 && spec.contact_modulus > 0.0)
    spec.contact_modulus = 1.0 / (1.0 / spec.contact_modulus + 1.0 / modulus);
}

} // namespace

mechanics::MaterialSpec read_material(const Node& table,
                                      const std::string& folder,
                                      bool is_poisson_needed,
                                      Mistakes& mistakes) {
  TableReader material(table, vocabulary_table("material"), mistakes);
  material.refuse_unknown({"counter", "inclusion", "variation"});
  mechanics::MaterialSpec spec;
  if (material.has("contact_modulus")) {
    spec.contact_modulus = material.number("contact_modulus");
    if (material.has("youngs_modulus"))
      material.refuse_both("contact_modulus", "youngs_modulus");
  } else if (material.has("youngs_modulus")) {
    spec.contact_modulus = plane_strain_modulus(material);
  } else {
    material.complain_missing("youngs_modulus", " (or contact_modulus)");
  }
  if (material.has("poisson_ratio"))
    spec.poisson_ratio = material.number("poisson_ratio");
  else if (is_poisson_needed && !material.has("youngs_modulus"))
    material.complain_missing("poisson_ratio",
                              ", which a block of finite depth needs");
  if (const Node* const node = material.sub_table("counter"))
    read_counter(*node, material, spec, mistakes);
  read_block(material, folder, spec, mistakes);
  return spec;
}

} // namespace asperity::cases
