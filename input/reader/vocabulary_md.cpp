// The rows of [md].
#include "input/reader/bound_key.hpp"

namespace asperity::cases {
namespace {

using Md = mechanics::MdSettings;

std::vector<Key> lattice_keys() {
  return {
      key<&Md::engine>("engine", {"asperity", "lammps"},
                       "Program that moves the atoms: this one, or LAMMPS as a "
                       "child process."),
      key<&Md::lattice>("lattice", {"isotropic", "born", "central"},
                        "Springs of the simple cubic block; central springs "
                        "allow only Poisson's ratio 1/4."),
      key<&Md::bulk>("bulk", {"green", "explicit"},
                     "The block condensed exactly to its lowest layer (green), "
                     "or all of its atoms, coarser with depth (explicit)."),
      key<&Md::modes>("modes", {"vector", "normal"},
                      "With green: atoms move in all three directions, or only "
                      "normal to the contact surface."),
      key<&Md::atoms>("atoms", between(8, 16384),
                      "Atoms per side of the block's lowest layer, even; their "
                      "spacing is a = length / atoms.",
                      eg("400", "default: the points of the surface")),
      key<&Md::substrate_atoms>("substrate_atoms", between(8, 16384),
                                "Rigid substrate atoms per side, even, at the "
                                "heights of the surface.",
                                eg("648", "default: the even number nearest to "
                                          "the golden mean times atoms")),
      key<&Md::depth>("depth", by_the_grid(),
                      "Depth of the block, for green and LAMMPS, rounded to "
                      "whole layers of atoms."),
      key<&Md::levels>("levels", between(1, 12),
                       "With explicit: number of levels; the spacing doubles "
                       "from each level to the next.",
                       eg("5")),
      key<&Md::layers>("layers", between(1, 4096),
                       "With explicit: layers of cells per level."),
  };
}

std::vector<Key> interaction_keys() {
  return {
      key<&Md::potential>(
          "potential", {"repulsive", "lennard-jones"},
          "Repulsion eps (r_0/r)^12, or with the attraction that puts the "
          "minimum -eps at r_0 (Lennard-Jones 12-6)."),
      key<&Md::interaction_energy>(
          "interaction_energy", Dimension::energy,
          "Energy eps of the potential between an atom of the block and one of "
          "the substrate.",
          needed("74.4 meV")),
      key<&Md::interaction_distance>("interaction_distance", Dimension::length,
                                     "Distance r_0 of that potential.",
                                     needed("3.28 angstrom")),
      key<&Md::cutoff>("cutoff", Dimension::length,
                       "Distance beyond which a pair does not interact; its "
                       "force decays smoothly to zero there.",
                       needed("10 angstrom")),
      key<&Md::contact_distance>(
          "contact_distance", Dimension::length,
          "d_c: the mean gap is u = d - d_c, with d the height of the lowest "
          "layer above the substrate; a pair closer than d_c is in contact.",
          needed("4.3615 angstrom")),
      key<&Md::minimizer>(
          "minimizer", {"auto", "lbfgs", "dynamics"},
          "Minimiser; auto is Newton's method for green and L-BFGS for "
          "explicit. dynamics needs bulk = \"explicit\"."),
      key<&Md::tolerance>("tolerance", Range{0.0, 0.1, false, true},
                          "Root mean square of the residual forces, relative "
                          "to the mean normal force per atom."),
      key<&Md::max_evaluations>("max_evaluations", between(1, 100000000),
                                "Force evaluations after which a step is "
                                "stopped and marked as not converged."),
  };
}

constexpr const char* for_dynamics = "with minimizer = \"dynamics\"";

std::vector<Key> motion_keys() {
  return {
      key<&Md::mass>("mass", Dimension::mass, "Mass of an atom of the block.",
                     needed("197 u", for_dynamics)),
      key<&Md::time_step>("time_step", Dimension::time,
                          "Time step of the integration.",
                          needed("10 fs", for_dynamics)),
      key<&Md::damping>(
          "damping", {Dimension::rate, at_least(0.0)},
          "Rate at which momenta decay: friction of the heat bath.",
          needed("0.5 1/ps", for_dynamics)),
      key<&Md::duration>("duration", {Dimension::time, {0.0, 1.0, false, true}},
                         "Duration of a load step; without temperature a step "
                         "ends as soon as the forces are in equilibrium.",
                         needed("200 ps", for_dynamics)),
      key<&Md::temperature>("temperature",
                            {Dimension::temperature, at_least(0.0)},
                            "Temperature of the heat bath.", eg("0 K")),
      key<&Md::seed>("seed", between(0, 2147483647),
                     "Seed of the thermal noise.",
                     needed("1", "with a temperature above 0")),
      key<&Md::ranks>("ranks", between(1, 1024),
                      "Number of MPI processes on which LAMMPS runs.", eg("2")),
      key<&Md::dump>("dump", ValueType::boolean,
                     "Write the atoms of every step as extended XYZ, for "
                     "OVITO; LAMMPS writes its own dump.",
                     eg("true")),
  };
}

} // namespace

Table md_table() {
  Table table{.name = "md",
              .description = "A block of atoms on a rigid substrate of atoms.",
              .keys = {}};
  for (const std::vector<Key>& keys :
       {lattice_keys(), interaction_keys(), motion_keys()})
    append_keys(table.keys, keys);
  return table;
}

} // namespace asperity::cases
