#pragma once

// One problem instance of the robustness matrix: all of its parameters, which
// are drawn from a seed and an index only.

#include "cases/types/case.hpp"

#include <cstdint>
#include <limits>
#include <string>

namespace asperity::robustness {

/// The part of the program that solves the instance.
enum class Family {
  halfspace,
  slab,         ///< continuum of finite thickness
  condensed_q1, ///< finite elements condensed to the contact surface
  condensed_q2,
  full_block, ///< full 3-D finite-element model of a small block
  atoms,
  theory, ///< Persson's theory at extreme parameters
  flawed, ///< an invalid argument, which must be refused
};

enum class Shape {
  rough,
  wave,
  paraboloid, ///< touches at one point
  spike,      ///< a single protruding node
  step,       ///< two plateaus
  sawtooth,   ///< ramps and vertical steps
  terraces,   ///< roughness with four heights: many equal heights
  /// Alternating heights, with a period of two points in both directions.
  checkerboard,
  flat,
};

/// The loading path around the load of the instance.
enum class Program {
  increments, ///< from a smaller load to the load, then one hundredth more
  jump,       ///< from a millionth of the load
  cycle,      ///< loading and unloading
};

/// The second run with which the instance is compared, as a metamorphic pair.
enum class MetamorphicRelation {
  none,
  binary_units,  ///< lengths and moduli times powers of two: bitwise equal
  decimal_units, ///< times powers of ten: equal to the solver's tolerance
  threads,       ///< FFT on several threads: equal to the solver's tolerance
  direct_solver, ///< a full 3-D model with factorised matrices: equal to the
                 ///< solver's tolerance
};

/// The execution path of an instance. All but the first also go through the
/// program: a case file is written, `asperity run` is started, and the result
/// is read back and compared.
enum class Path {
  library,
  program,   ///< without a report
  report,    ///< with all tables and figures
  two_ranks, ///< under mpirun, without a report; only full 3-D models
};

/// The second meshed body of a full 3-D model, of finite size.
enum class CounterBody { none, sphere, cylinder, cuboid };

/// The defect of a flawed instance.
enum class Flaw {
  none,
  nan_height,
  infinite_height,
  nan_in_file,
  infinity_in_file,
  nan_in_case,
  zero_load,
  negative_load,
  infinite_load,
  closed_contact_gap, ///< a mean gap of zero with hard contact
  zero_penalty,
  infinite_penalty, ///< as a penalty; hard contact is a separate law
  zero_modulus,
  incompressible, ///< nu = 1/2 in finite elements
  shrinking_layers,
  sliver, ///< a thickness of one to one and a half surface layers
  odd_q2_grid,
  zero_tolerance,
  nan_load,
  nan_modulus,
  nan_penalty,
  nan_tolerance,
  nan_thickness,
  nan_poisson_ratio,
  infinite_modulus,
};

/// The parameters of one problem instance.
struct Instance {
  std::uint64_t seed = 0;
  int index = 0; ///< >= 0

  Family family = Family::halfspace;
  Shape shape = Shape::rough;
  mechanics::ContactLaw law = mechanics::ContactLaw::hard;
  mechanics::Control control = mechanics::Control::nominal_pressure;
  mechanics::FarBoundary far_boundary = mechanics::FarBoundary::clamped;
  bool has_free_boundaries = false; ///< of a half-space under pressure control
  Program program = Program::increments;
  MetamorphicRelation relation = MetamorphicRelation::none;
  Flaw flaw = Flaw::none;
  Path path = Path::library;
  int threads = 3; ///< of the second run and of the program [1] 1..3

  int points = 32;            ///< nodes per side, even
  double length = 1.0;        ///< [m] > 0
  double hurst = 0.8;         ///< [1] 0..1
  double roll_off = 1.0;      ///< roll-off wavenumber, in waves per side [1]
  double shortest_wave = 8.0; ///< in node spacings [1] >= 2
  /// Slope to which the surface is scaled [1] > 0; the scale of the load, for a
  /// flat surface too.
  double rms_slope = 0.1;

  double contact_modulus = 1e9; ///< E* [Pa] > 0
  double poisson_ratio = 0.3;   ///< [1]
  double thickness = 1.0; ///< of the block, in units of the length [1] > 0
  double growth = 1.2;    ///< grading ratio of finite-element layers [1] 1..10
  int degree = 1;         ///< of the elements of a full 3-D model, 1 or 2
  /// E of a coating over that of the block below it [1] > 0; 1 means no
  /// coating. Only finite elements use it.
  double coating_stiffness = 1.0;
  /// In units of the block's thickness [1] 0..1.
  double coating_thickness = 0.1;
  // Only full 3-D models use the following seven.
  mechanics::MeshKind mesh = mechanics::MeshKind::layers;
  bool has_free_sides = false;
  mechanics::LinearSolver linear_solver = mechanics::LinearSolver::automatic;
  /// r: the moduli of the cells differ from each other by random factors within
  /// 1/r..r [1] >= 1.
  double modulus_ratio = 1.0;
  CounterBody counter = CounterBody::none;
  double counter_radius = 0.4;    ///< or half the side, in lengths [1] 0..0.5
  double counter_stiffness = 1.0; ///< plane-strain modulus over that of the
                                  ///< block [1] > 0

  double penalty = 100.0; ///< k, in E*/h [1] > 0; ignored by hard contact
  /// Of laws with adhesion: w over k_c h_rms^2/2, some energy of full
  /// conformity, and s^2 h/(w E*) [1] > 0.
  double adhesion = 0.1;
  double grid_number = 0.25;
  /// Of a prescribed mean gap, over k_c; infinite without a spring.
  double spring = std::numeric_limits<double>::infinity();
  /// Nominal pressure in units of E* h' [1], or mean gap in units of h_rms [1].
  double load = 0.01;
  double gamma = 0.45; ///< of the theory [1]

  double spacing() const { return length / points; } ///< h [m]
};

/// Draws instance `index` of a seed. Every axis has its own counter, so that
/// the bits are the same on every machine and in any order, and do not change
/// when axes are added later.
/// @throws std::domain_error  index < 0
Instance draw_instance(std::uint64_t seed, int index);

/// Draws an instance in which each axis takes the value of `base` with a
/// probability of one half: the settings of a case are perturbed in this way.
/// Flawed instances remain flawed, and the grid remains small.
Instance draw_instance_about(const Instance& base, std::uint64_t seed,
                             int index);

/// Moves every member that is outside the range of its family into that range:
/// a full 3-D model is small and coarse in depth, and a wave fits its grid.
Instance within_reach(Instance instance);

/// Describes the instance in one line, with all parameters that define it.
std::string text_of(const Instance& instance);

/// Return the names of the enumerators for labels: "condensed-q1".
std::string name_of(Family family);
std::string name_of(Shape shape);
std::string name_of(mechanics::ContactLaw law);
std::string name_of(mechanics::Control control);
std::string name_of(mechanics::FarBoundary far_boundary);
std::string name_of(Program program);
std::string name_of(mechanics::LinearSolver linear_solver);
std::string name_of(mechanics::MeshKind mesh);
std::string name_of(CounterBody counter);
std::string name_of(MetamorphicRelation relation);
std::string name_of(Flaw flaw);
std::string name_of(Path path);

} // namespace asperity::robustness
