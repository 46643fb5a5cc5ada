// The rows of [load] and of the methods.
#include "input/reader/bound_key.hpp"
#include "input/reader/read_parts.hpp"

namespace asperity::cases {
namespace {

using mechanics::LoadingPath;
using Block = mechanics::BlockSettings;
using Contact = mechanics::ContactSettings;
using Fem = mechanics::FemSettings;
using FullBlock = mechanics::FullBlockSettings;
using Halfspace = mechanics::HalfspaceSettings;
using Theory = mechanics::TheorySettings;
using Winkler = mechanics::WinklerSettings;

Values stiffness_per_area() {
  return {Dimension::stiffness,
          positive(),
          {mechanics::ReferenceUnit::contact_modulus_per_spacing}};
}

template <auto member>
Key top_key() {
  return key<member>("top", {"clamped", "sliding", "pressure"},
                     "Boundary condition at the far boundary of the block.");
}

std::vector<Key> contact_keys() {
  return {
      key<&Contact::law>(
          "contact", mechanics::contact_law_names(),
          "Penalty, hard (unilateral) or augmented-Lagrangian contact, or a "
          "hard wall with adhesion that falls with the gap g: w exp(-g/range), "
          "w (1 - g/range) (dugdale) or w (1 - g/range)^3 (cubic); or laws "
          "without a wall, whose gap counts from that of flat faces in "
          "equilibrium: lennard-jones (9-3, of half-spaces of atoms; range is "
          "the distance of the faces there), lennard-jones-10-4 (of two layers "
          "of atoms, as those of [md]) and morse. Adhesion is available to "
          "[halfspace] and to condensed "
          "[fem] with element = \"Q1\", and its loads may be tensile.")
          .shown(),
      key<&Contact::penalty>(
          "penalty", stiffness_per_area(),
          "Penalty stiffness: contact pressure per penetration.",
          needed("100 E*/h", "with contact = \"penalty\" or \"augmented\"; "
                             "ignored with \"hard\"")),
      key<&Contact::work_of_adhesion>("work_of_adhesion",
                                      {Dimension::energy_per_area, positive()},
                                      "Work of adhesion w of flat faces.",
                                      needed("50 mJ/m^2", "with adhesion"))
          .hidden(),
      key<&Contact::range>(
          "range",
          {Dimension::length,
           positive(),
           {mechanics::ReferenceUnit::length,
            mechanics::ReferenceUnit::spacing}},
          "Range of the adhesion. The spacing h of the grid must resolve it: "
          "with the largest tension s of the law, s^2 h/(w E*) must be <= 1, "
          "and should be <= 0.25.",
          eg("2 h", "default: the shortest with s^2 h/(w E*) = 0.25"))
          .hidden(),
      key<&Contact::tolerance>(
          "tolerance", between(1e-15, 0.01),
          "Complementarity error at which a step has converged, relative to "
          "h_rms and the nominal pressure; with adhesion the rms correction of "
          "the gap, relative to h_rms."),
      key<&Contact::max_iterations>("max_iterations", between(1, 10000000),
                                    "Iterations after which a step is stopped "
                                    "and marked as not converged."),
  };
}

std::vector<Key> with_contact(std::vector<Key> keys) {
  append_keys(keys, contact_keys());
  return keys;
}

Table load_table() {
  return {
      .name = "load",
      .when = "Always needed.",
      .description =
          "The loading path; its steps are computed in the given order.",
      .keys = {
          read_by<LoadingPath>(
              read_pressures,
              key<&LoadingPath::targets>(
                  "nominal_pressure",
                  {Dimension::pressure,
                   any_number(),
                   {mechanics::ReferenceUnit::contact_modulus,
                    mechanics::ReferenceUnit::contact_modulus_times_slope}},
                  "Load divided by the nominal area, > 0, or any number if "
                  "all methods have adhesion and none is [md]; h' is the rms "
                  "slope of the "
                  "realisation.",
                  needed("{ from = \"1e-3 E*\", to = \"0.1 E*\", steps = 8, "
                         "spacing = \"log\" }",
                         "this or mean_gap")))
              .shown(),
          read_by<LoadingPath>(
              read_gaps,
              key<&LoadingPath::targets>(
                  "mean_gap",
                  {Dimension::length,
                   any_number(),
                   {mechanics::ReferenceUnit::length,
                    mechanics::ReferenceUnit::spacing,
                    mechanics::ReferenceUnit::rms_height}},
                  "Mean gap between block and surface, > 0; with a spring, the "
                  "place of its far end, which is any number: a soft spring "
                  "presses from beyond the surface.",
                  needed("[\"2 h_rms\", \"1 h_rms\", \"0.5 h_rms\"]",
                         "this or nominal_pressure"))),
          key<&LoadingPath::spring>(
              "spring", stiffness_per_area(),
              "Stiffness k per nominal area of a spring through which the mean "
              "gap d is prescribed: the nominal pressure is k (u - d) at the "
              "mean gap u. Needs mean_gap, and adhesion in all methods, none "
              "of them [md].",
              eg("0.01 E*/h", "default: the mean gap is that of the contact"))
              .hidden(),
          key("cycle", {"load", "load-unload"},
              "Loading, or loading and unloading.", or_else("\"load\"")),
      }};
}

Table sweep_table() {
  return {.name = "load.sweep",
          .when = "The value of nominal_pressure or mean_gap.",
          .is_part = true,
          .description = "Steps between two values, both included.",
          .keys = {
              key("from", ValueType::target, "First value.", needed("1e-3 E*")),
              key("to", ValueType::target,
                  "Last value, in the same kind of unit as from.",
                  needed("0.1 E*")),
              key("steps", {ValueType::integer, between(2, 10000)},
                  "Number of values.", needed("8")),
              key("spacing", {"log", "linear", "area"},
                  "Equal ratios or differences of the values, or equal ratios "
                  "of the contact areas erf(2^(1/2) p/(E* h')) by Persson's "
                  "theory, for pressures of up to 3 E* h'.",
                  needed("log")),
          }};
}

Values hardness_values() {
  return {Dimension::pressure,
          positive(),
          {mechanics::ReferenceUnit::contact_modulus,
           mechanics::ReferenceUnit::contact_modulus_times_slope}};
}

Table theory_table() {
  return {
      .name = "theory",
      .description = "Persson's theory.",
      .keys = {
          key<&Theory::gamma>("gamma", Range{0.0, 1.0, false, true},
                              "Parameter gamma of Eq. (10) of Yang and Persson "
                              "(2008), the fraction of the elastic energy, or "
                              "of another loss_factor; not the slope of ln p "
                              "against u.",
                              needed("0.42"))
              .shown(),
          key<&Theory::loss_factor>(
              "loss_factor", {"yang-persson", "wang-mueser", "xu"},
              "The loss of elastic energy in partial contact: by Eq. (10) of "
              "Yang and Persson (2008), or by the laws of Wang and Mueser "
              "(2017) or Xu et al. (2024), which also enlarge the contact "
              "area. The tables [magnification] and [adhesion] need the first.",
              or_else("\"yang-persson\"")),
          key<&Theory::hardness>(
              "hardness", hardness_values(),
              "Second absorbing boundary of the stress, for elastic and "
              "plastic area. Mean gap, energy and stiffness remain those of "
              "elastic contact.",
              eg("2 GPa", "default: the surface is elastic"))
              .hidden(),
          key<&Theory::spectrum>(
              "spectrum", {"formula", "surface"},
              "The case's own spectrum, or the one measured on the same "
              "surface that the other methods use.",
              eg("formula", "default: formula for self-affine and spectrum, "
                            "surface for the others, which have no formula")),
      }};
}

Table halfspace_table() {
  return {
      .name = "halfspace",
      .description = "The elastic half-space, or a slab of finite thickness, "
                     "by a spectral (Fourier) method.",
      .keys = with_contact({
          key<&Halfspace::thickness>(
              "thickness", by_the_grid(), "Thickness of the slab.",
              eg("1 length", "default: infinitely thick")),
          top_key<&Halfspace::far_boundary>(),
          key<&Contact::hardness>(
              "hardness", hardness_values(),
              "Largest contact pressure, with contact = \"hard\": the surface "
              "sinks where it is reached and keeps the imprint along the "
              "path. Nominal pressures must not be larger.",
              eg("2 GPa", "default: the surface is elastic"))
              .hidden(),
          key<&Halfspace::has_free_boundaries>(
              "boundaries", {"periodic", "free"},
              "Whether the surface continues periodically, or is pressed once "
              "on an infinite half-space. Free boundaries need loads by "
              "nominal pressure and a uniform half-space.",
              eg("free",
                 "default: free with surface.edges = \"free\", else periodic")),
      })};
}

/// Plastic flow of the full 3-D block.
std::vector<Key> flow_keys() {
  return {
      key<&FullBlock::yield_stress>(
          "yield_stress",
          {Dimension::pressure,
           positive(),
           {mechanics::ReferenceUnit::contact_modulus}},
          "With solver = \"full\": the stress in uniaxial tension at which the "
          "block begins to flow (von Mises); needs one body of second-order "
          "hexahedra or first-order boxes, and loads by nominal pressure.",
          eg("0.005 E*", "default: the block is elastic")),
      key<&FullBlock::hardening_modulus>(
          "hardening_modulus",
          {Dimension::pressure,
           positive(),
           {mechanics::ReferenceUnit::contact_modulus}},
          "Increase of the yield stress per plastic strain in uniaxial "
          "tension.",
          eg("0.01 E*", "with yield_stress; default: perfectly plastic")),
  };
}

std::vector<Key> full_block_keys() {
  return {
      key<&FullBlock::uses_case_mesh>(
          "mesh", {"layers", "case"},
          "Mesh of the full 3-D block: its own graded layers, or the case's "
          "[mesh].",
          eg("layers", "with solver = \"full\"; default: the case's [mesh] if "
                       "it has one")),
      key<&FullBlock::sides>("sides", {"periodic", "free"},
                             "Lateral boundary conditions of the block; free "
                             "sides need solver = \"full\".",
                             eg("free")),
      key<&FullBlock::linear_solver>(
          "linear_solver", {"auto", "direct", "multigrid"},
          "With solver = \"full\": direct factorisation, or conjugate "
          "gradients with multigrid as preconditioner; auto selects the "
          "fastest that the mesh allows.",
          eg("multigrid")),
      key<&FullBlock::bodies>(
          "bodies", between(1, 2),
          "With solver = \"full\": 2 meshes [material.counter] against the "
          "block, with the heights between the two bodies.",
          eg("2")),
      key<&FullBlock::has_stiffness>(
          "stiffness", ValueType::boolean,
          "With solver = \"full\": finds the normal and the tangential "
          "stiffness of the contact after each load step, by one linear solve "
          "per direction; needs top = \"clamped\" and one body.",
          eg("true")),
  };
}

Table fem_table() {
  return {
      .name = "fem",
      .description = "The elastic block by finite elements.",
      .keys = with_contact({
          key<&Block::element>(
              "element", {"Q1", "Q2"},
              "Trilinear (Q1) or triquadratic (Q2) hexahedra; points counts "
              "nodes for both, and Q2 requires an even number."),
          key<&Block::surface_cell_depth>(
              "surface_cell_depth", between(0.001, 10.0),
              "Depth of the cells at the contact surface, in node spacings h."),
          key<&Block::growth>(
              "growth", between(1.0, 4.0),
              "Grading ratio: thickness ratio of successive layers of cells."),
          key<&Block::depth>("depth", by_the_grid(), "Depth of the block."),
          top_key<&Block::far_boundary>(),
          key<&Fem::solver>(
              "solver", {"auto", "condensed", "full"},
              "The block condensed to its contact surface, the full 3-D block, "
              "or the condensed one where the problem allows it (auto)."),
      })};
}

Table fem_table_with_full_block() {
  Table table = fem_table();
  append_keys(table.keys, hidden(full_block_keys()));
  append_keys(table.keys, hidden(flow_keys()));
  return table;
}

Table winkler_table() {
  return {
      .name = "winkler",
      .description =
          "A Winkler foundation: independent springs without elastic coupling, "
          "in hard contact. Its contact area is the bearing area; the "
          "difference from the other methods shows what elastic coupling does.",
      .keys = {
          key<&Winkler::stiffness>("stiffness", stiffness_per_area(),
                                   "Pressure per compression of a spring.",
                                   needed("0.1 E*/h")),
      }};
}

/// Appends the keys that all methods have to those of a method.
Table as_method(Table table) {
  table.is_method = true;
  table.when = "The method runs only if this table is present.";
  table.keys.push_back(key<&MethodSpec::magnification>(
      "magnification", positive(),
      "zeta: the surface of this method has no roughness above zeta times the "
      "roll-off wavevector; the remaining waves keep their phases and "
      "amplitudes.",
      eg("4.0", "default: all of the roughness; self-affine surfaces only")));
  table.keys.push_back(key<&MethodSpec::realizations>(
      "realizations", between(1, 1000),
      "Number of realisations of the surface that this method solves, "
      "beginning with the first; more than surface.realizations means all of "
      "them.",
      eg("4", "default: all")));
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
