#include "cases/reader/vocabulary.hpp"

namespace asperity::cases {
namespace {

Key top_key() {
  return {.name = "top",
          .type = ValueType::word,
          .words = {"clamped", "sliding", "pressure"},
          .fallback = "\"clamped\"",
          .example = "\"clamped\"",
          .description = "What holds the block's upper face."};
}

std::vector<Key> contact_keys() {
  return {
      {.name = "contact",
       .type = ValueType::word,
       .words = {"penalty", "hard", "augmented"},
       .fallback = "\"hard\"",
       .example = "\"hard\"",
       .show = Show::yes,
       .description = "Law of the interface: penetration at a price, none, or "
                      "the price raised until there is none."},
      {.name = "penalty",
       .dimension = Dimension::stiffness,
       .range = positive(),
       .yardsticks = {Yardstick::contact_modulus_per_spacing},
       .need = Need::conditional,
       .when = "with contact = \"penalty\" or \"augmented\"; not looked at "
               "with \"hard\"",
       .example = "\"100 E*/h\"",
       .description = "Pressure per penetration."},
      {.name = "tolerance",
       .range = {0.0, 0.01, false, true},
       .fallback = "1e-8",
       .example = "1e-8",
       .description = "Complementarity at which a step ends, relative to h_rms "
                      "and the nominal pressure."},
      {.name = "max_iterations",
       .type = ValueType::integer,
       .range = between(1, 10000000),
       .fallback = "2000",
       .example = "2000",
       .description = "Iterations after which a step is given up, and said to "
                      "be."},
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
          .description = "The load program, run in its order.",
          .keys = {
              {.name = "nominal_pressure",
               .type = ValueType::program,
               .dimension = Dimension::pressure,
               .range = positive(),
               .yardsticks = {Yardstick::contact_modulus},
               .need = Need::conditional,
               .when = "this or mean_gap",
               .example = "{ from = \"1e-3 E*\", to = \"0.1 E*\", steps = 8, "
                          "spacing = \"log\" }",
               .show = Show::yes,
               .description = "Load over nominal area."},
              {.name = "mean_gap",
               .type = ValueType::program,
               .dimension = Dimension::length,
               .range = positive(),
               .yardsticks = {Yardstick::length, Yardstick::spacing,
                              Yardstick::rms_height},
               .need = Need::conditional,
               .when = "this or nominal_pressure",
               .example = "[\"2 h_rms\", \"1 h_rms\", \"0.5 h_rms\"]",
               .description = "Mean distance of block and surface."},
              {.name = "cycle",
               .type = ValueType::word,
               .words = {"load", "load-unload"},
               .fallback = "\"load\"",
               .example = "\"load\"",
               .description = "There only, or there and back."},
          }};
}

Table sweep_table() {
  return {.name = "load.sweep",
          .when = "The value of nominal_pressure or mean_gap.",
          .is_part = true,
          .description = "Steps between two values, both among them.",
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
               .description = "Last value, in the same kind of unit."},
              {.name = "steps",
               .type = ValueType::integer,
               .range = between(2, 10000),
               .need = Need::always,
               .example = "8",
               .description = "Number of values."},
              {.name = "spacing",
               .type = ValueType::word,
               .words = {"log", "linear"},
               .need = Need::always,
               .example = "\"log\"",
               .description = "Equal ratios, or equal differences."},
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
               .description = "Parameter of (10), the share of the elastic "
                              "energy; not the slope of ln p against u."},
              {.name = "spectrum",
               .type = ValueType::word,
               .words = {"formula", "surface"},
               .when = "default: formula for self-affine and spectrum, surface "
                       "for the others, which have no formula",
               .example = "\"formula\"",
               .description = "The case's own spectrum, or the one measured on "
                              "the very surface the other methods use."},
          }};
}

Table halfspace_table() {
  return {.name = "halfspace",
          .description = "The continuum half-space, or a slab of finite "
                         "thickness, spectral.",
          .keys = with_contact({
              {.name = "thickness",
               .dimension = Dimension::length,
               .range = positive(),
               .yardsticks = {Yardstick::length, Yardstick::spacing},
               .when = "default: infinitely thick",
               .example = "\"1 length\"",
               .description = "Of the slab."},
              top_key(),
          })};
}

Table fem_table() {
  return {.name = "fem",
          .description = "The block by finite elements.",
          .keys = with_contact({
              {.name = "element",
               .type = ValueType::word,
               .words = {"Q1", "Q2"},
               .fallback = "\"Q2\"",
               .example = "\"Q2\"",
               .description = "Trilinear or triquadratic hexahedra; points "
                              "counts nodes for both, and Q2 asks for an even "
                              "number."},
              {.name = "surface_cell_depth",
               .range = {0.0, 10.0, false, true},
               .fallback = "1.0",
               .example = "1.0",
               .description = "Depth of the cells at the face, in node "
                              "spacings h."},
              {.name = "growth",
               .range = between(1.0, 4.0),
               .fallback = "1.2",
               .example = "1.2",
               .description = "Thickness ratio from layer to layer."},
              {.name = "depth",
               .dimension = Dimension::length,
               .range = positive(),
               .yardsticks = {Yardstick::length, Yardstick::spacing},
               .fallback = "\"1 length\"",
               .example = "\"1 length\"",
               .description = "Of the block."},
              top_key(),
              {.name = "solver",
               .type = ValueType::word,
               .words = {"auto", "condensed", "full"},
               .fallback = "\"auto\"",
               .example = "\"auto\"",
               .description = "The block condensed to its face, all of it, or "
                              "the first where the scene allows it."},
          })};
}

Table fem_table_with_whole_block() {
  Table table = fem_table();
  for (Key& key : whole_block_keys())
    table.keys.push_back(std::move(key));
  return table;
}

/// Returns the key that all methods have.
Key magnification_key() {
  return {.name = "magnification",
          .range = positive(),
          .when = "default: all of the roughness; self-affine surfaces only",
          .example = "4.0",
          .description = "zeta: this method's surface has no roughness above "
                         "zeta times the roll-off wavevector; what stays keeps "
                         "its phases and amplitudes."};
}

/// Appends the common key to the keys of a method.
Table as_method(Table table) {
  table.is_method = true;
  table.when = "Runs only if this table is there.";
  table.keys.push_back(magnification_key());
  return table;
}

} // namespace

std::vector<Table> method_tables() {
  return {load_table(),
          sweep_table(),
          as_method(theory_table()),
          as_method(halfspace_table()),
          as_method(fem_table_with_whole_block()),
          as_method(md_table())};
}

} // namespace asperity::cases
