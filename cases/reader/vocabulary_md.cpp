#include "cases/reader/vocabulary.hpp"

namespace asperity::cases {
namespace {

std::vector<Key> lattice_model_keys() {
  return {
      {.name = "engine",
       .type = ValueType::word,
       .words = {"asperity", "lammps"},
       .fallback = "\"asperity\"",
       .example = "\"asperity\"",
       .description = "Program that moves the atoms: this one, or LAMMPS as a "
                      "child process."},
      {.name = "lattice",
       .type = ValueType::word,
       .words = {"isotropic", "born", "central"},
       .fallback = "\"isotropic\"",
       .example = "\"isotropic\"",
       .description = "Springs of the simple cubic block; central springs "
                      "allow only Poisson's ratio 1/4."},
      {.name = "bulk",
       .type = ValueType::word,
       .words = {"green", "explicit"},
       .fallback = "\"green\"",
       .example = "\"green\"",
       .description =
           "The block condensed exactly to its lowest layer (green), or all of "
           "its atoms, coarser with depth (explicit)."},
      {.name = "modes",
       .type = ValueType::word,
       .words = {"vector", "normal"},
       .fallback = "\"vector\"",
       .example = "\"vector\"",
       .description = "With green: atoms move in all three directions, or only "
                      "normal to the contact surface."},
  };
}

std::vector<Key> lattice_size_keys() {
  return {
      {.name = "atoms",
       .type = ValueType::integer,
       .range = between(8, 16384),
       .when = "default: the points of the surface",
       .example = "400",
       .description = "Atoms per side of the block's lowest layer, even; their "
                      "spacing is a = length / atoms."},
      {.name = "substrate_atoms",
       .type = ValueType::integer,
       .range = between(8, 16384),
       .when = "default: the even number nearest to the golden mean times "
               "atoms",
       .example = "648",
       .description = "Rigid substrate atoms per side, even, at the heights of "
                      "the surface."},
      {.name = "depth",
       .dimension = Dimension::length,
       .range = positive(),
       .references = {mechanics::ReferenceUnit::length,
                      mechanics::ReferenceUnit::spacing},
       .fallback = "\"1 length\"",
       .example = "\"1 length\"",
       .description = "Depth of the block, for green and LAMMPS, rounded to "
                      "whole layers of atoms."},
      {.name = "levels",
       .type = ValueType::integer,
       .range = between(1, 12),
       .fallback = "1",
       .example = "5",
       .description = "With explicit: number of levels; the spacing doubles "
                      "from each level to the next."},
      {.name = "layers",
       .type = ValueType::integer,
       .range = between(1, 4096),
       .fallback = "6",
       .example = "6",
       .description = "With explicit: layers of cells per level."},
  };
}

std::vector<Key> interaction_keys() {
  return {
      {.name = "potential",
       .type = ValueType::word,
       .words = {"repulsive", "lennard-jones"},
       .fallback = "\"repulsive\"",
       .example = "\"repulsive\"",
       .description = "Repulsion eps (r_0/r)^12, or with the attraction that "
                      "puts the minimum -eps at r_0 (Lennard-Jones 12-6)."},
      {.name = "interaction_energy",
       .dimension = Dimension::energy,
       .range = positive(),
       .need = Need::always,
       .example = "\"74.4 meV\"",
       .description = "Energy eps of the potential between an atom of the "
                      "block and one of the substrate."},
      {.name = "interaction_distance",
       .dimension = Dimension::length,
       .range = positive(),
       .need = Need::always,
       .example = "\"3.28 angstrom\"",
       .description = "Distance r_0 of that potential."},
      {.name = "cutoff",
       .dimension = Dimension::length,
       .range = positive(),
       .need = Need::always,
       .example = "\"10 angstrom\"",
       .description = "Distance beyond which a pair does not interact; its "
                      "force decays smoothly to zero there."},
      {.name = "contact_distance",
       .dimension = Dimension::length,
       .range = positive(),
       .need = Need::always,
       .example = "\"4.3615 angstrom\"",
       .description =
           "d_c: the mean gap is u = d - d_c, with d the height of the lowest "
           "layer above the substrate; a pair closer than d_c is in contact."},
  };
}

std::vector<Key> balance_keys() {
  return {
      {.name = "minimizer",
       .type = ValueType::word,
       .words = {"auto", "lbfgs", "fire", "dynamics"},
       .fallback = "\"auto\"",
       .example = "\"auto\"",
       .description =
           "Minimiser; auto is Newton's method for green and L-BFGS for "
           "explicit. fire and dynamics need bulk = \"explicit\"."},
      {.name = "tolerance",
       .range = {0.0, 0.1, false, true},
       .fallback = "1e-4",
       .example = "1e-4",
       .description = "Root mean square of the residual forces, relative to "
                      "the mean normal force per atom."},
      {.name = "max_evaluations",
       .type = ValueType::integer,
       .range = between(1, 100000000),
       .fallback = "20000",
       .example = "20000",
       .description = "Force evaluations after which a step is stopped and "
                      "marked as not converged."},
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
       .description = "Mass of an atom of the block."},
      for_dynamics({.name = "time_step",
                    .dimension = Dimension::time,
                    .range = positive(),
                    .example = "\"10 fs\"",
                    .description = "Time step of the integration."}),
      for_dynamics(
          {.name = "damping",
           .dimension = Dimension::rate,
           .range = at_least(0.0),
           .example = "\"0.5 1/ps\"",
           .description =
               "Rate at which momenta decay: friction of the heat bath."}),
      for_dynamics({.name = "duration",
                    .dimension = Dimension::time,
                    .range = {0.0, 1.0, false, true},
                    .example = "\"200 ps\"",
                    .description =
                        "Duration of a load step; without temperature a step "
                        "ends as soon as the forces are in equilibrium."}),
      {.name = "temperature",
       .dimension = Dimension::temperature,
       .range = at_least(0.0),
       .fallback = "0.0",
       .example = "\"0 K\"",
       .description = "Temperature of the heat bath."},
      {.name = "seed",
       .type = ValueType::integer,
       .range = between(0, 2147483647),
       .need = Need::conditional,
       .when = "with a temperature above 0",
       .example = "1",
       .description = "Seed of the thermal noise."},
  };
}

std::vector<Key> outside_keys() {
  return {
      {.name = "ranks",
       .type = ValueType::integer,
       .range = between(1, 1024),
       .fallback = "1",
       .example = "2",
       .description = "Number of MPI processes on which LAMMPS runs."},
      {.name = "dump",
       .type = ValueType::boolean,
       .fallback = "false",
       .example = "true",
       .description = "Write the atoms of every step as extended XYZ, for "
                      "OVITO; LAMMPS writes its own dump."},
  };
}

} // namespace

Table md_table() {
  Table table{.name = "md",
              .description = "A block of atoms on a rigid substrate of atoms.",
              .keys = {}};
  for (const std::vector<Key>& keys :
       {lattice_model_keys(), lattice_size_keys(), interaction_keys(),
        balance_keys(), dynamics_keys(), outside_keys()})
    append_keys(table.keys, keys);
  for (Key& key : table.keys)
    key.show = Show::no; // interaction lengths are specific to atomistic cases
  return table;
}

} // namespace asperity::cases
