#pragma once

// The settings of the atomistic method.

#include "mechanics/contact_law.hpp"
#include "mechanics/quantity.hpp"

#include <cstdint>
#include <optional>

namespace asperity::mechanics {

enum class AtomEngine { asperity, lammps };

/// Forces within the simple cubic lattice of the block.
enum class AtomLattice {
  isotropic, ///< springs on edges and face diagonals, plus a dilatation energy
             ///< per cell
  born,      ///< edges with a normal and a tangential spring
  central,   ///< springs on edges and face diagonals only, so that nu = 1/4
};

enum class AtomBulk { green, explicit_layers };
enum class AtomModes { vector, normal };
enum class AtomPotential { repulsive, lennard_jones };
enum class AtomMinimizer { automatic, lbfgs, dynamics };

/// Returns the number of atoms per side of the periodic substrate lattice whose
/// spacing is closest to a/phi, where phi is the golden mean. The number is
/// even: 648 for 400 block atoms, as in Yang and Persson (2008), Sec. 4.
/// @throws std::domain_error  layer_atoms < 1
int incommensurate_atoms(int layer_atoms);

/// [md]: a block of atoms on a simple cubic lattice with the spacing
/// length / atoms, in contact with rigid atoms at the heights of the surface.
struct MdSettings {
  AtomEngine engine = AtomEngine::asperity;
  AtomLattice lattice = AtomLattice::isotropic;
  AtomBulk bulk = AtomBulk::green;
  AtomModes modes = AtomModes::vector;
  std::optional<int> atoms; ///< per side, in the lowest layer of the block
  std::optional<int> substrate_atoms; ///< per side

  AtomPotential potential = AtomPotential::repulsive;
  double interaction_energy = 0.0;   ///< eps [J] > 0
  double interaction_distance = 0.0; ///< r_0 [m] > 0
  double cutoff = 0.0;               ///< [m]
  double contact_distance = 0.0;     ///< d_c [m] > 0: u = d - d_c

  Quantity depth{1.0, ReferenceUnit::length}; ///< of the block, for green
  int levels = 1; ///< of the explicit block; the spacing doubles from each to
                  ///< the next
  int layers = 6; ///< cell layers per level

  AtomMinimizer minimizer = AtomMinimizer::automatic;
  double tolerance = 1e-4; ///< rms force, relative to the mean normal force per
                           ///< atom
  int max_evaluations = 20000; ///< force evaluations per load step

  double mass = 0.0;        ///< atomic mass [kg], for dynamics
  double time_step = 0.0;   ///< [s], for dynamics
  double damping = 0.0;     ///< damping rate of the momenta [1/s], for dynamics
  double temperature = 0.0; ///< [K] >= 0, for dynamics
  double duration = 0.0;    ///< duration of a load step [s], for dynamics
  std::uint64_t seed = 0;   ///< seed of the thermal noise

  int ranks = 1;     ///< number of MPI ranks of the child process, for lammps
  bool dump = false; ///< write the atoms of every step

  /// Returns whether the faces attract each other.
  bool is_adhesive() const { return potential == AtomPotential::lennard_jones; }

  /// The law of flat faces that attract each other, without the cutoff; none
  /// for a repulsive potential. A layer with n_1 atoms per area and one with
  /// n_2 at the distance d have the energy per area
  ///
  ///     W = pi n_1 n_2 eps r_0^2 [(r_0/d)^10/5 - (r_0/d)^4]
  ///
  /// if the lattices are incommensurate, so that all relative positions of two
  /// atoms are equally frequent. This is the 10-4 law with w = 3/5 4^(1/3) pi
  /// n_1 n_2 eps r_0^2 and the range r_0/2^(1/6).
  /// @param length  side of the periodic square [m] > 0
  /// @param points  nodes of the surface per side, the default of `atoms`
  std::optional<ContactInterface> flat_law(double length, int points) const;

  static constexpr const char* kind = "md";

  bool has_fields() const { return true; }

  bool needs_surface() const { return true; }

  bool needs_poisson_ratio() const { return true; }

  bool uses_layers() const { return false; }

  bool is_continuum() const { return true; }
};

} // namespace asperity::mechanics
