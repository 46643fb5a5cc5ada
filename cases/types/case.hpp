#pragma once

// What a case is once it has been read: plain data, SI units, nothing of TOML.
// Owns the vocabulary that every other room answers to.

#include "cases/types/block_spec.hpp"
#include "cases/types/quantity.hpp"
#include "cases/types/studies.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace asperity::cases {

enum class SurfaceKind {
  self_affine,
  spectrum,
  measured,
  sphere,
  wave_1d,
  wave_2d
};
enum class Amplitudes { spectrum, gaussian };
enum class MapFormat { automatic, plain, gwyddion };
enum class Levelling { none, plane, bow };
enum class Edges { periodic, window, mirror };

/// [surface]. Lengths [m], wavevectors [rad/m]. What a kind does not use stays
/// empty: length and points of a measured map come from its file.
struct SurfaceSpec {
  SurfaceKind kind = SurfaceKind::self_affine;
  std::optional<double> length; ///< side of the periodic square > 0
  std::optional<int> points;    ///< nodes a side, even, >= 4
  std::uint64_t seed = 0;
  int realizations = 1;
  Amplitudes amplitudes = Amplitudes::spectrum;
  bool rescale = false; ///< scale each realisation to the asked rms exactly

  std::optional<double> rms_height; ///< of the spectrum, over all of it
  std::optional<double> rms_slope;
  double hurst = 0.0;               ///< 0..1
  double wavevector_low = 0.0;      ///< q_L
  double wavevector_roll_off = 0.0; ///< q_0, q_L <= q_0 <= q_1
  double wavevector_high = 0.0;     ///< q_1

  std::string file; ///< path of the map or spectrum, made absolute or
                    ///< relative to the working directory by the reader
  MapFormat format = MapFormat::automatic;
  Levelling level = Levelling::plane;
  Edges edges = Edges::periodic;
  std::optional<double> height_unit; ///< m per unit of a plain file's numbers

  double radius = 0.0;     ///< sphere
  double amplitude = 0.0;  ///< waves
  double wavelength = 0.0; ///< waves; length is a whole multiple of it
};

/// [material]: the block against a rigid face, or two elastic bodies reduced
/// to one: 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
struct MaterialSpec {
  double contact_modulus = 0.0;        ///< E* [Pa] > 0, of the pair
  std::optional<double> poisson_ratio; ///< of the block, -1 < nu < 0.5

  std::optional<BodyModuli> counter = {}; ///< the second body; E* has it
  std::vector<MaterialLayer> layers = {};
  std::optional<MaterialInclusion> inclusion = {};
  std::optional<MaterialVariation> variation = {};

  /// One modulus and one Poisson's ratio everywhere: the block that theory,
  /// half-space and atoms know.
  bool is_uniform() const { return layers.empty() && !inclusion && !variation; }

  /// Young's modulus of the one block that stands for the pair:
  /// E = E* (1 - nu^2) [Pa]. Needs poisson_ratio.
  double block_youngs_modulus() const;

  /// The first of two bodies: what is left of E* without the counter's share;
  /// the one block where there is no counter. Needs poisson_ratio.
  BodyModuli first_body() const;
};

enum class Control { nominal_pressure, mean_gap };

/// [load]: the steps in the order they are run; a cycle "load-unload" is
/// already written out. is_unloading[i] marks the way back.
struct LoadProgram {
  Control control = Control::nominal_pressure;
  std::vector<Quantity> targets; ///< p_0 [Pa] or mean gap [m] a step
  std::vector<bool> is_unloading;
};

enum class ContactLaw { penalty, hard, augmented };
enum class TopFace { clamped, sliding, pressure };
enum class Element { q1, q2 };
enum class FemSolver { automatic, condensed, full };
enum class TheorySpectrum { formula, surface };

/// How an elastic method treats the interface.
struct ContactSettings {
  ContactLaw law = ContactLaw::hard;
  Quantity penalty{100.0, Yardstick::contact_modulus_per_spacing}; ///< [Pa/m]
  double tolerance = 1e-8; ///< complementarity, relative to h_rms and p_0
  int max_iterations = 2000;
};

struct TheorySettings {
  double gamma = 0.0; ///< parameter of (10), 0 < gamma <= 1
  TheorySpectrum spectrum = TheorySpectrum::formula;
};

struct HalfspaceSettings {
  ContactSettings contact;
  std::optional<Quantity> thickness; ///< none: infinitely thick [m]
  TopFace top = TopFace::clamped;    ///< of a block of finite thickness
};

struct FemSettings {
  ContactSettings contact;
  Element element = Element::q2;
  double surface_cell_depth = 1.0; ///< in node spacings
  double growth = 1.2;             ///< thickness ratio of successive layers
  Quantity depth{1.0, Yardstick::length};
  TopFace top = TopFace::clamped;
  FemSolver solver = FemSolver::automatic;
  BlockSides sides = BlockSides::periodic;
  LinearSolverChoice linear_solver = LinearSolverChoice::automatic; ///< full
  ContactPoints contact_at = ContactPoints::nodes;                  ///< full
  bool uses_case_mesh = false; ///< full: [mesh], else graded layers
  int bodies = 1; ///< full: 2 meshes the counter body too, else E* has it
};

enum class AtomEngine { asperity, lammps };
enum class AtomLattice { isotropic, born, central };
enum class AtomBulk { green, explicit_layers };
enum class AtomModes { vector, normal };
enum class AtomPotential { repulsive, lennard_jones };
enum class AtomMinimizer { automatic, lbfgs, fire, dynamics };

/// [md]: a block of atoms, simple cubic of spacing length / atoms, on rigid
/// atoms at the heights of the surface.
struct MdSettings {
  AtomEngine engine = AtomEngine::asperity;
  AtomLattice lattice = AtomLattice::isotropic;
  AtomBulk bulk = AtomBulk::green;
  AtomModes modes = AtomModes::vector;
  std::optional<int> atoms;           ///< a side, of the block's lowest layer
  std::optional<int> substrate_atoms; ///< a side

  AtomPotential potential = AtomPotential::repulsive;
  double interaction_energy = 0.0;   ///< eps [J] > 0
  double interaction_distance = 0.0; ///< r_0 [m] > 0
  double cutoff = 0.0;               ///< [m]
  double contact_distance = 0.0;     ///< d_c [m] > 0: u = d - d_c

  Quantity depth{1.0, Yardstick::length}; ///< of the block, for green
  int levels = 1; ///< of the explicit block: spacing doubles from each to next
  int layers = 6; ///< of cells a level

  AtomMinimizer minimizer = AtomMinimizer::automatic;
  double tolerance = 1e-4;     ///< root mean square force, relative to the mean
                               ///< normal force an atom
  int max_evaluations = 20000; ///< of the forces, a load step

  double mass = 0.0;        ///< of an atom [kg], for dynamics
  double time_step = 0.0;   ///< [s], for dynamics
  double damping = 0.0;     ///< rate at which momenta fade [1/s], for dynamics
  double temperature = 0.0; ///< [K] >= 0, for dynamics
  double duration = 0.0;    ///< of a load step [s], for dynamics
  std::uint64_t seed = 0;   ///< of the thermal noise

  int ranks = 1;     ///< of the child process, for lammps
  bool dump = false; ///< write the atoms of every step
};

/// One method to run. A table [fem] is the method "fem"; a table inside it,
/// [fem.hard], is the method "fem.hard": [fem]'s keys with its own over them.
struct MethodSpec {
  std::string name;
  std::variant<TheorySettings, HalfspaceSettings, FemSettings, MdSettings>
      settings;
  /// zeta: of a self-affine surface, roughness above zeta q_0 is left out for
  /// this method; phases and amplitudes of what stays do not change.
  std::optional<double> magnification = {};
};

/// [report]
struct ReportSpec {
  /// Number of load steps, spread over the program, whose pressure and gap
  /// maps (of realisation 0) are kept.
  int fields = 3;
  /// The stress below the face is worked out under each kept pressure map.
  bool stress_inside = false;
  /// The whole block writes its last step of each field for ParaView.
  bool vtu = false;
};

/// One line of [expect]: the quantity must lie in low..high for each method.
struct Expectation {
  std::string quantity; ///< one of expectation_names(), or one at a load
  double low = 0.0;
  double high = 0.0;
  std::vector<std::string> methods; ///< names of methods of this case
  /// A value whose 95 % interval reaches over an end of the band counts as
  /// passed; else as not passed.
  bool passes_if_undecided = false;
};

struct Case {
  std::string path; ///< as given, for messages
  std::string text; ///< the file, byte for byte, then a line "#--set key=value"
                    ///< for each override: read again, it is the same case
  std::string name; ///< of its folder or file, e.g. "polymer"
  std::string title;
  SurfaceSpec surface;
  MaterialSpec material;
  MeshSpec mesh;
  LoadProgram load;
  std::vector<MethodSpec> methods; ///< theory, halfspace, fem, md, then
                                   ///< variants
  std::optional<MagnificationStudy> magnification_study;
  std::optional<AdhesionStudy> adhesion_study;
  ReportSpec report;
  std::vector<Expectation> expectations;
};

/// The theory that answers the studies: the first that takes the formula as
/// its spectrum, null if none does.
const MethodSpec* study_theory(const std::vector<MethodSpec>& methods);

} // namespace asperity::cases
