#include "cases/reader/vocabulary.hpp"

namespace asperity::cases {
namespace {

Key top_key() {
  return {.name = "top",
          .type = ValueType::word,
          .words = {"clamped", "sliding", "pressure"},
          .fallback = "\"clamped\"",
          .example = "\"clamped\"",
          .description =
              "Boundary condition at the far boundary of the block."};
}

std::vector<Key> contact_keys() {
  return {
      {.name = "contact",
       .type = ValueType::word,
       .words = {"penalty", "hard", "augmented"},
       .fallback = "\"hard\"",
       .example = "\"hard\"",
       .show = Show::yes,
       .description =
           "Penalty, hard (unilateral) or augmented-Lagrangian contact."},
      {.name = "penalty",
       .dimension = Dimension::stiffness,
       .range = positive(),
       .references = {mechanics::ReferenceUnit::contact_modulus_per_spacing},
       .need = Need::conditional,
       .when =
           "with contact = \"penalty\" or \"augmented\"; ignored with \"hard\"",
       .example = "\"100 E*/h\"",
       .description = "Penalty stiffness: contact pressure per penetration."},
      {.name = "tolerance",
       .range = between(1e-15, 0.01),
       .fallback = "1e-8",
       .example = "1e-8",
       .description = "Complementarity error at which a step has converged, "
                      "relative to h_rms and the nominal pressure."},
      {.name = "max_iterations",
       .type = ValueType::integer,
       .range = between(1, 10000000),
       .fallback = "2000",
       .example = "2000",
       .description = "Iterations after which a step is stopped and marked as "
                      "not converged."},
  };
}

std::vector<Key> with_contact(std::vector<Key> keys) {
  for (Key& key : contact_keys())
    keys.push_back(std::move(key));
  return keys;
}

Table load_table() {
  return {.name = "load",
          .when = "Always needed.",
          .description =
              "The loading path; its steps are computed in the given order.",
          .keys = {
              {.name = "nominal_pressure",
               .type = ValueType::program,
               .dimension = Dimension::pressure,
               .range = positive(),
               .references =
                   {mechanics::ReferenceUnit::contact_modulus,
                    mechanics::ReferenceUnit::contact_modulus_times_slope},
               .need = Need::conditional,
               .when = "this or mean_gap",
               .example = "{ from = \"1e-3 E*\", to = \"0.1 E*\", steps = 8, "
                          "spacing = \"log\" }",
               .show = Show::yes,
               .description = "Load divided by the nominal area; h' is the rms "
                              "slope of the realisation."},
              {.name = "mean_gap",
               .type = ValueType::program,
               .dimension = Dimension::length,
               .range = positive(),
               .references = {mechanics::ReferenceUnit::length,
                              mechanics::ReferenceUnit::spacing,
                              mechanics::ReferenceUnit::rms_height},
               .need = Need::conditional,
               .when = "this or nominal_pressure",
               .example = "[\"2 h_rms\", \"1 h_rms\", \"0.5 h_rms\"]",
               .description = "Mean gap between block and surface."},
              {.name = "cycle",
               .type = ValueType::word,
               .words = {"load", "load-unload"},
               .fallback = "\"load\"",
               .example = "\"load\"",
               .description = "Loading, or loading and unloading."},
          }};
}

Table sweep_table() {
  return {.name = "load.sweep",
          .when = "The value of nominal_pressure or mean_gap.",
          .is_part = true,
          .description = "Steps between two values, both included.",
          .keys = {
              {.name = "from",
               .type = ValueType::target,
               .need = Need::always,
               .example = "\"1e-3 E*\"",
               .description = "First value."},
              {.name = "to",
               .type = ValueType::target,
               .need = Need::always,
               .example = "\"0.1 E*\"",
               .description = "Last value, in the same kind of unit as from."},
              {.name = "steps",
               .type = ValueType::integer,
               .range = between(2, 10000),
               .need = Need::always,
               .example = "8",
               .description = "Number of values."},
              {.name = "spacing",
               .type = ValueType::word,
               .words = {"log", "linear", "area"},
               .need = Need::always,
               .example = "\"log\"",
               .description =
                   "Equal ratios or differences of the values, or equal ratios "
                   "of the contact areas erf(2^(1/2) p/(E* h')) by Persson's "
                   "theory, for pressures of up to 3 E* h'."},
          }};
}

Table theory_table() {
  return {.name = "theory",
          .description = "Persson's theory.",
          .keys = {
              {.name = "gamma",
               .range = {0.0, 1.0, false, true},
               .need = Need::always,
               .example = "0.42",
               .show = Show::yes,
               .description = "Parameter gamma of Eq. (10) of Yang and Persson "
                              "(2008), the fraction of the elastic energy; not "
                              "the slope of ln p against u."},
              {.name = "spectrum",
               .type = ValueType::word,
               .words = {"formula", "surface"},
               .when = "default: formula for self-affine and spectrum, surface "
                       "for the others, which have no formula",
               .example = "\"formula\"",
               .description = "The case's own spectrum, or the one measured on "
                              "the same surface that the other methods use."},
          }};
}

Table halfspace_table() {
  return {.name = "halfspace",
          .description = "The elastic half-space, or a slab of finite "
                         "thickness, by a spectral (Fourier) method.",
          .keys = with_contact({
              {.name = "thickness",
               .dimension = Dimension::length,
               .range = positive(),
               .references = {mechanics::ReferenceUnit::length,
                              mechanics::ReferenceUnit::spacing},
               .when = "default: infinitely thick",
               .example = "\"1 length\"",
               .description = "Thickness of the slab."},
              top_key(),
              {.name = "boundaries",
               .type = ValueType::word,
               .words = {"periodic", "free"},
               .when = "default: free with surface.edges = \"free\", else "
                       "periodic",
               .example = "\"free\"",
               .description =
                   "Whether the surface continues periodically, or is pressed "
                   "once on an infinite half-space. Free boundaries need loads "
                   "by nominal pressure and a uniform half-space."},
          })};
}

Table fem_table() {
  return {
      .name = "fem",
      .description = "The elastic block by finite elements.",
      .keys = with_contact({
          {.name = "element",
           .type = ValueType::word,
           .words = {"Q1", "Q2"},
           .fallback = "\"Q2\"",
           .example = "\"Q2\"",
           .description =
               "Trilinear (Q1) or triquadratic (Q2) hexahedra; points counts "
               "nodes for both, and Q2 requires an even number."},
          {.name = "surface_cell_depth",
           .range = between(0.001, 10.0),
           .fallback = "1.0",
           .example = "1.0",
           .description = "Depth of the cells at the contact surface, in node "
                          "spacings h."},
          {.name = "growth",
           .range = between(1.0, 4.0),
           .fallback = "1.2",
           .example = "1.2",
           .description =
               "Grading ratio: thickness ratio of successive layers of cells."},
          {.name = "depth",
           .dimension = Dimension::length,
           .range = positive(),
           .references = {mechanics::ReferenceUnit::length,
                          mechanics::ReferenceUnit::spacing},
           .fallback = "\"1 length\"",
           .example = "\"1 length\"",
           .description = "Depth of the block."},
          top_key(),
          {.name = "solver",
           .type = ValueType::word,
           .words = {"auto", "condensed", "full"},
           .fallback = "\"auto\"",
           .example = "\"auto\"",
           .description = "The block condensed to its contact surface, the "
                          "full 3-D block, or the condensed one where the "
                          "problem allows it (auto)."},
      })};
}

Table fem_table_with_full_block() {
  Table table = fem_table();
  for (Key& key : full_block_keys())
    table.keys.push_back(std::move(key));
  return table;
}

Table winkler_table() {
  return {.name = "winkler",
          .description =
              "A Winkler foundation: independent springs without elastic "
              "coupling, in hard contact. Its contact area is the bearing "
              "area; the difference from the other methods shows what elastic "
              "coupling does.",
          .keys = {
              {.name = "stiffness",
               .dimension = Dimension::stiffness,
               .range = positive(),
               .references =
                   {mechanics::ReferenceUnit::contact_modulus_per_spacing},
               .need = Need::always,
               .example = "\"0.1 E*/h\"",
               .description = "Pressure per compression of a spring."},
          }};
}

Key magnification_key() {
  return {.name = "magnification",
          .range = positive(),
          .when = "default: all of the roughness; self-affine surfaces only",
          .example = "4.0",
          .description = "zeta: the surface of this method has no roughness "
                         "above zeta times the roll-off wavevector; the "
                         "remaining waves keep their phases and amplitudes."};
}

Key realizations_key() {
  return {.name = "realizations",
          .type = ValueType::integer,
          .range = between(1, 1000),
          .when = "default: all",
          .example = "4",
          .description = "Number of realisations of the surface that this "
                         "method solves, beginning with the first; more than "
                         "surface.realizations means all of them."};
}

/// Appends the keys that all methods have to those of a method.
Table as_method(Table table) {
  table.is_method = true;
  table.when = "The method runs only if this table is present.";
  table.keys.push_back(magnification_key());
  table.keys.push_back(realizations_key());
  return table;
}

} // namespace

std::vector<Table> method_tables() {
  return {load_table(),
          sweep_table(),
          as_method(theory_table()),
          as_method(halfspace_table()),
          as_method(fem_table_with_full_block()),
          as_method(md_table()),
          as_method(winkler_table())};
}

} // namespace asperity::cases
