#include "cases/reader/vocabulary.hpp"

#include <iterator>

namespace asperity::cases {
namespace {

std::vector<Key> lattice_keys() {
  return {
      {.name = "engine",
       .type = ValueType::word,
       .words = {"asperity", "lammps"},
       .fallback = "\"asperity\"",
       .example = "\"asperity\"",
       .description = "What moves the atoms: this program, or LAMMPS as a "
                      "child process."},
      {.name = "lattice",
       .type = ValueType::word,
       .words = {"isotropic", "born", "central"},
       .fallback = "\"isotropic\"",
       .example = "\"isotropic\"",
       .description = "Springs of the simple cubic block; central has "
                      "Poisson's ratio 1/4 and no other."},
      {.name = "bulk",
       .type = ValueType::word,
       .words = {"green", "explicit"},
       .fallback = "\"green\"",
       .example = "\"green\"",
       .description = "The block eliminated exactly for its lowest layer, or "
                      "all of its atoms, coarser with depth."},
      {.name = "modes",
       .type = ValueType::word,
       .words = {"vector", "normal"},
       .fallback = "\"vector\"",
       .example = "\"vector\"",
       .description = "With green: atoms move in all three directions, or "
                      "normal to the face alone."},
      {.name = "atoms",
       .type = ValueType::integer,
       .range = between(8, 16384),
       .when = "default: the points of the surface",
       .example = "400",
       .description = "Atoms a side of the block's lowest layer, even; their "
                      "spacing is a = length / atoms."},
      {.name = "substrate_atoms",
       .type = ValueType::integer,
       .range = between(8, 16384),
       .when = "default: the even number nearest to the golden mean times "
               "atoms",
       .example = "648",
       .description = "Rigid atoms a side, even, at the heights of the "
                      "surface."},
      {.name = "depth",
       .dimension = Dimension::length,
       .range = positive(),
       .yardsticks = {Yardstick::length, Yardstick::spacing},
       .fallback = "\"1 length\"",
       .example = "\"1 length\"",
       .description = "Of the block, for green and LAMMPS, rounded to whole "
                      "layers of atoms."},
      {.name = "levels",
       .type = ValueType::integer,
       .range = between(1, 12),
       .fallback = "1",
       .example = "5",
       .description = "With explicit: the spacing doubles from each level to "
                      "the next."},
      {.name = "layers",
       .type = ValueType::integer,
       .range = between(1, 4096),
       .fallback = "6",
       .example = "6",
       .description = "With explicit: layers of cells a level."},
  };
}

std::vector<Key> interaction_keys() {
  return {
      {.name = "potential",
       .type = ValueType::word,
       .words = {"repulsive", "lennard-jones"},
       .fallback = "\"repulsive\"",
       .example = "\"repulsive\"",
       .description = "eps (r_0/r)^12, or with the attraction that puts the "
                      "minimum -eps at r_0."},
      {.name = "interaction_energy",
       .dimension = Dimension::energy,
       .range = positive(),
       .need = Need::always,
       .example = "\"74.4 meV\"",
       .description = "eps of the law between an atom of the block and one of "
                      "the substrate."},
      {.name = "interaction_distance",
       .dimension = Dimension::length,
       .range = positive(),
       .need = Need::always,
       .example = "\"3.28 angstrom\"",
       .description = "r_0 of that law."},
      {.name = "cutoff",
       .dimension = Dimension::length,
       .range = positive(),
       .need = Need::always,
       .example = "\"10 angstrom\"",
       .description = "Distance beyond which a pair feels nothing; its force "
                      "fades before."},
      {.name = "contact_distance",
       .dimension = Dimension::length,
       .range = positive(),
       .need = Need::always,
       .example = "\"4.3615 angstrom\"",
       .description = "d_c: the mean gap is u = d - d_c, d the height of the "
                      "lowest layer over the substrate; a pair nearer than "
                      "this is in contact."},
  };
}

std::vector<Key> balance_keys() {
  return {
      {.name = "minimizer",
       .type = ValueType::word,
       .words = {"auto", "lbfgs", "fire", "dynamics"},
       .fallback = "\"auto\"",
       .example = "\"auto\"",
       .description = "Road to the balance of forces; auto is Newton's method "
                      "for green and L-BFGS for explicit. fire and dynamics "
                      "need bulk = \"explicit\"."},
      {.name = "tolerance",
       .range = {0.0, 0.1, false, true},
       .fallback = "1e-4",
       .example = "1e-4",
       .description = "Root mean square of the forces left, relative to the "
                      "mean normal force an atom."},
      {.name = "max_evaluations",
       .type = ValueType::integer,
       .range = between(1, 100000000),
       .fallback = "20000",
       .example = "20000",
       .description = "Evaluations of the forces after which a step is given "
                      "up, and said to be."},
  };
}

Key for_dynamics(Key key) {
  key.need = Need::conditional;
  key.when = "with minimizer = \"dynamics\"";
  return key;
}

std::vector<Key> dynamics_keys() {
  return {
      {.name = "mass",
       .dimension = Dimension::mass,
       .range = positive(),
       .need = Need::conditional,
       .when = "with minimizer = \"dynamics\"",
       .example = "\"197 u\"",
       .description = "Of an atom of the block."},
      for_dynamics({.name = "time_step",
                    .dimension = Dimension::time,
                    .range = positive(),
                    .example = "\"10 fs\"",
                    .description = "Of the integration."}),
      for_dynamics({.name = "damping",
                    .dimension = Dimension::rate,
                    .range = at_least(0.0),
                    .example = "\"0.5 1/ps\"",
                    .description = "Rate at which momenta fade: friction of "
                                   "the heat bath."}),
      for_dynamics({.name = "duration",
                    .dimension = Dimension::time,
                    .range = positive(),
                    .example = "\"200 ps\"",
                    .description = "Of a load step; without temperature a step "
                                   "ends as soon as it is in balance."}),
      {.name = "temperature",
       .dimension = Dimension::temperature,
       .range = at_least(0.0),
       .fallback = "0.0",
       .example = "\"0 K\"",
       .description = "Of the heat bath."},
      {.name = "seed",
       .type = ValueType::integer,
       .range = between(0, 2147483647),
       .need = Need::conditional,
       .when = "with a temperature above 0",
       .example = "1",
       .description = "Of the thermal noise."},
  };
}

std::vector<Key> outside_keys() {
  return {
      {.name = "ranks",
       .type = ValueType::integer,
       .range = between(1, 1024),
       .fallback = "1",
       .example = "2",
       .description = "MPI processes that LAMMPS runs on."},
      {.name = "dump",
       .type = ValueType::boolean,
       .fallback = "false",
       .example = "true",
       .description = "Write the atoms of every step as extended XYZ, for "
                      "viewing in OVITO; LAMMPS writes its own dump."},
  };
}

} // namespace

Table md_table() {
  Table table{.name = "md",
              .description = "The block of atoms on a rigid substrate of "
                             "atoms.",
              .keys = {}};
  for (std::vector<Key> keys :
       {lattice_keys(), interaction_keys(), balance_keys(), dynamics_keys(),
        outside_keys()})
    table.keys.insert(table.keys.end(), std::make_move_iterator(keys.begin()),
                      std::make_move_iterator(keys.end()));
  for (Key& key : table.keys)
    key.show = Show::no; // interaction lengths are specific to atomistic cases
  return table;
}

} // namespace asperity::cases
