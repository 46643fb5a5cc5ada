#pragma once

// The settings of each method, in SI units, and the questions that the rest of
// the program asks of any method. Defines the list of the methods.

#include "cases/types/block_spec.hpp"
#include "cases/types/quantity.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace asperity::cases {

enum class ContactLaw { penalty, hard, augmented };
enum class TopFace { clamped, sliding, pressure };
enum class Element { q1, q2 };
enum class FemSolver { automatic, condensed, full };
enum class TheorySpectrum { formula, surface };

/// The contact law and its solver settings for an elastic method.
struct ContactSettings {
  ContactLaw law = ContactLaw::hard;
  Quantity penalty{100.0,
                   ReferenceUnit::contact_modulus_per_spacing}; ///< [Pa/m]
  double tolerance = 1e-8; ///< of complementarity, relative to h_rms and p_0
  int max_iterations = 2000;
};

struct TheorySettings {
  double gamma = 0.0; ///< 0 < gamma <= 1, parameter of Eq. (10) of Yang and
                      ///< Persson (2008)
  TheorySpectrum spectrum = TheorySpectrum::formula;

  static constexpr const char* kind = "theory";

  bool has_fields() const { return false; }

  bool needs_surface() const { return spectrum == TheorySpectrum::surface; }

  bool needs_poisson_ratio() const { return false; }

  bool uses_layers() const { return false; }

  bool is_continuum() const { return false; }
};

struct HalfspaceSettings {
  ContactSettings contact;
  std::optional<Quantity> thickness; ///< none: half-space [m]
  TopFace top = TopFace::clamped;    ///< far boundary of a block of finite
                                     ///< thickness
  /// The surface is pressed once on an infinite half-space, without its
  /// periodic continuation.
  bool has_free_boundaries = false;

  static constexpr const char* kind = "halfspace";

  bool has_fields() const { return true; }

  bool needs_surface() const { return true; }

  bool needs_poisson_ratio() const { return thickness.has_value(); }

  bool uses_layers() const { return true; }

  bool is_continuum() const { return true; }
};

struct FemSettings {
  ContactSettings contact;
  Element element = Element::q2;
  double surface_cell_depth = 1.0; ///< in node spacings
  double growth = 1.2;             ///< grading ratio of successive layers
  Quantity depth{1.0, ReferenceUnit::length};
  TopFace top = TopFace::clamped;
  FemSolver solver = FemSolver::automatic;
  BlockSides sides = BlockSides::periodic;
  /// For solver = full.
  LinearSolverChoice linear_solver = LinearSolverChoice::automatic;
  ContactPoints contact_at = ContactPoints::nodes; ///< for solver = full
  bool uses_case_mesh = false; ///< full: [mesh] instead of graded layers
  int bodies = 1; ///< full: 2 meshes the second body too; with 1 it enters
                  ///< through E*

  static constexpr const char* kind = "fem";

  bool has_fields() const { return true; }

  bool needs_surface() const { return true; }

  bool needs_poisson_ratio() const { return true; }

  bool uses_layers() const { return true; }

  bool is_continuum() const { return true; }
};

/// [winkler]: independent springs under the nodes, in hard contact.
struct WinklerSettings {
  Quantity stiffness; ///< k [Pa/m] > 0

  static constexpr const char* kind = "winkler";

  bool has_fields() const { return true; }

  bool needs_surface() const { return true; }

  bool needs_poisson_ratio() const { return false; }

  bool uses_layers() const { return false; }

  bool is_continuum() const { return false; }
};

enum class AtomEngine { asperity, lammps };
enum class AtomLattice { isotropic, born, central };
enum class AtomBulk { green, explicit_layers };
enum class AtomModes { vector, normal };
enum class AtomPotential { repulsive, lennard_jones };
enum class AtomMinimizer { automatic, lbfgs, fire, dynamics };

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

  static constexpr const char* kind = "md";

  bool has_fields() const { return true; }

  bool needs_surface() const { return true; }

  bool needs_poisson_ratio() const { return true; }

  bool uses_layers() const { return false; }

  bool is_continuum() const { return true; }
};

/// The list of the methods. A new one is added here; the compiler then names
/// each function that has no answer for it (docs/extending.md).
using MethodSettings = std::variant<TheorySettings, HalfspaceSettings,
                                    FemSettings, MdSettings, WinklerSettings>;

/// One method to run. A table [fem] is the method "fem"; a table inside it,
/// [fem.hard], is the method "fem.hard", which has the keys of [fem] with its
/// own keys taking precedence.
struct MethodSpec {
  std::string name;
  MethodSettings settings;
  /// zeta: for a self-affine surface, this method omits roughness above zeta
  /// q_0. Phases and amplitudes of the remaining roughness do not change.
  std::optional<double> magnification = {};
  /// The number of realisations that this method solves, beginning with the
  /// first; the surface may have fewer. Default: all.
  std::optional<int> realizations = {};

  /// Returns whether the method solves for a pressure and gap field.
  bool has_fields() const {
    return std::visit([](const auto& own) { return own.has_fields(); },
                      settings);
  }

  /// Returns whether the method needs the heights of each realisation.
  bool needs_surface() const {
    return std::visit([](const auto& own) { return own.needs_surface(); },
                      settings);
  }

  /// Returns whether the method needs material.poisson_ratio.
  bool needs_poisson_ratio() const {
    return std::visit([](const auto& own) { return own.needs_poisson_ratio(); },
                      settings);
  }

  /// Returns whether the pressure acts on an elastic continuum, or on atoms
  /// that approximate one: whether there is a stress inside.
  bool is_continuum() const {
    return std::visit([](const auto& own) { return own.is_continuum(); },
                      settings);
  }

  /// Returns whether the method uses [[material.layers]].
  bool uses_layers() const {
    return std::visit([](const auto& own) { return own.uses_layers(); },
                      settings);
  }
};

} // namespace asperity::cases
