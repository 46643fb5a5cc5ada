// Checks the conditions of full blocks that concern several tables of a case.
#include "input/reader/read_parts.hpp"

#include <string>
#include <variant>

namespace asperity::cases {
namespace {

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
    const auto* const fem = method.as<mechanics::FemSettings>();
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
    const auto* const fem = method.as<mechanics::FemSettings>();
    if (fem == nullptr || fem->full.bodies != 2)
      continue;
    is_used = true;
    if (fem->block.far_boundary == mechanics::FarBoundary::pressure)
      mistakes.add(place.place,
                   "mesh.counter cannot be combined with " + method.name +
                       ".top = \"pressure\": a body of finite size would tilt; "
                       "use top = \"clamped\" or \"sliding\"");
    if (read.surface.length && read.surface.points)
      check_counter_body(file, read, *fem,
                         {*read.surface.points, *read.surface.points,
                          *read.surface.length, *read.surface.length},
                         mistakes);
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

/// What a block that flows cannot combine.
void check_flow(const Node& file, const Case& read, const MethodSpec& method,
                const mechanics::FemSettings& fem, Mistakes& mistakes) {
  const auto refuse_if = [&](bool is_refused, const std::string& why) {
    if (is_refused)
      mistakes.add(entry_of(file, method.name, "yield_stress").place,
                   method.name + ".yield_stress " + why);
  };
  refuse_if(read.load.control == mechanics::Control::mean_gap,
            "needs loads by nominal_pressure, not by mean_gap");
  refuse_if(read.material.counter.has_value(),
            "cannot be combined with [material.counter]: of two bodies that "
            "one block represents, it is not known which one flows");
  refuse_if(
      fem.full.uses_case_mesh &&
          read.mesh.kind == mechanics::MeshKind::adaptive,
      "cannot be combined with mesh.kind = \"adaptive\"; use \"hanging\"");
  refuse_if(fem.block.element == mechanics::Element::q1 &&
                fem.full.uses_case_mesh &&
                read.mesh.kind == mechanics::MeshKind::gmsh,
            "needs element = \"Q2\" on this mesh: first-order cells that "
            "flow must be boxes");
}

/// What a full block cannot combine.
void check_full_block(const Node& file, const MethodSpec& method,
                      const mechanics::FemSettings& fem, Mistakes& mistakes) {
  if (fem.full.sides == mechanics::BlockSides::free &&
      fem.block.far_boundary == mechanics::FarBoundary::pressure)
    mistakes.add(entry_of(file, method.name, "top").place,
                 method.name +
                     ".top = \"pressure\" cannot be combined with sides = "
                     "\"free\": the block can tilt as a rigid body; use top "
                     "= \"clamped\" or \"sliding\"");
}

} // namespace

void check_block(const Node& file, const Case& read, Mistakes& mistakes) {
  check_layers(file, read, mistakes);
  if (read.mesh.counter)
    check_counter_mesh(file, read, mistakes);
  if (read.surface.form_radius)
    check_form(file, read, mistakes);
  for (const MethodSpec& method : read.methods) {
    const auto* const fem = method.as<mechanics::FemSettings>();
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
        mechanics::traits_of(fem->contact.law).block_solver ==
            mechanics::BlockSolver::wall)
      mistakes.add(entry_of(file, method.name, "bodies").place,
                   method.name +
                       ".bodies = 2 cannot be combined with hard (unilateral) "
                       "contact; use contact = \"augmented\" or \"penalty\"");
    if (is_full)
      check_full_block(file, method, *fem, mistakes);
    if (is_full && fem->full.yield_stress)
      check_flow(file, read, method, *fem, mistakes);
    if (fem->full.uses_case_mesh &&
        read.mesh.kind == mechanics::MeshKind::adaptive)
      check_adaptive(file, read, method, *fem, mistakes);
  }
}

} // namespace asperity::cases
