#pragma once

// One scene of the stability matrix: everything that defines it, drawn from a
// seed and an index and from nothing else.

#include "cases/types/case.hpp"

#include <cstdint>
#include <string>

namespace asperity::robustness {

/// Which part of the program answers the scene.
enum class Family {
  halfspace,
  slab,         ///< continuum of finite thickness
  condensed_q1, ///< finite elements condensed to the face
  condensed_q2,
  full_block, ///< every unknown of a small block
  atoms,
  theory, ///< Persson's theory at extremes
  flawed, ///< an argument that nobody can answer: to be refused
};

enum class Shape {
  rough,
  wave,
  paraboloid,   ///< touches at one point
  spike,        ///< one node stands out
  step,         ///< two plateaus
  sawtooth,     ///< ramps and cliffs
  terraces,     ///< roughness of four heights: duplicates everywhere
  checkerboard, ///< the wave of two points in both directions
  flat,
};

/// The loads of a scene about the one that was drawn.
enum class Program {
  increments, ///< from less, at the load, a hundredth more
  jump,       ///< from a millionth of the load
  cycle,      ///< up and back down
};

/// What the scene is run a second time with, to be compared.
enum class Twin {
  none,
  binary_units,  ///< lengths and moduli times powers of two: the same bits
  decimal_units, ///< times powers of ten: the solver's tolerance
  threads,       ///< transforms on several threads: the solver's tolerance
};

/// Which way a scene takes. All but the first also go through the program: a
/// case file, `asperity run`, the result read back and compared.
enum class Path {
  library,
  program,   ///< without a report
  report,    ///< with every table and figure
  two_ranks, ///< under mpirun, without a report; full blocks
};

/// What a flawed scene has wrong.
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
  closed_wall_gap, ///< a mean gap of zero against a hard wall
  zero_penalty,
  infinite_penalty, ///< as a penalty; the hard wall is a law of its own
  zero_modulus,
  incompressible, ///< nu = 1/2 in finite elements
  shrinking_layers,
  sliver, ///< between one and one and a half surface layers
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

struct Scene {
  std::uint64_t seed = 0;
  int index = 0; ///< >= 0

  Family family = Family::halfspace;
  Shape shape = Shape::rough;
  cases::ContactLaw law = cases::ContactLaw::hard;
  cases::Control control = cases::Control::nominal_pressure;
  cases::TopFace top = cases::TopFace::clamped;
  Program program = Program::increments;
  Twin twin = Twin::none;
  Flaw flaw = Flaw::none;
  Path path = Path::library;
  int threads = 3; ///< of the twin and of the program [1] 1..3

  int points = 32;            ///< nodes a side, even
  double length = 1.0;        ///< [m] > 0
  double hurst = 0.8;         ///< [1] 0..1
  double roll_off = 1.0;      ///< longest wave that falls, in waves a side [1]
  double shortest_wave = 8.0; ///< in node spacings [1] >= 2
  /// What the surface is scaled to [1] > 0; the yardstick of the load, for a
  /// flat surface too.
  double rms_slope = 0.1;

  double contact_modulus = 1e9; ///< E* [Pa] > 0
  double poisson_ratio = 0.3;   ///< [1]
  double thickness = 1.0;       ///< of the block, in lengths [1] > 0
  double growth = 1.2;          ///< of finite-element layers [1] 1..10
  int degree = 1;               ///< of a full block's elements, 1 or 2
  /// E of a coating over that of the block below it [1] > 0; 1 is no coating.
  /// Of finite elements alone.
  double coating_stiffness = 1.0;
  double coating_thickness = 0.1; ///< in thicknesses of the block [1] 0..1

  double penalty = 100.0; ///< k, in E*/h [1] > 0; not read by the hard wall
  /// Nominal pressure in E* h' [1], or mean gap in h_rms [1].
  double load = 0.01;
  double gamma = 0.45; ///< of the theory [1]

  double spacing() const { return length / points; } ///< h [m]
};

/// Scene `index` of a seed: every axis from its own counter, so the same bits
/// on every machine, in any order, and unmoved by axes added later.
/// @throws std::domain_error  index < 0
Scene draw_scene(std::uint64_t seed, int index);

/// The scene with each axis replaced by the base's value with probability one
/// half: how a case's own settings are perturbed. The flawed stay flawed, and
/// the grid stays small.
Scene draw_scene_about(const Scene& base, std::uint64_t seed, int index);

/// Any member beyond what its family can take is brought into it: a full block
/// is small and coarse in depth, a wave fits its grid.
Scene within_reach(Scene scene);

/// The scene in one line, every number that defines it.
std::string in_words(const Scene& scene);

/// Of the enumerations, for labels: "condensed-q1".
std::string name_of(Family family);
std::string name_of(Shape shape);
std::string name_of(cases::ContactLaw law);
std::string name_of(cases::Control control);
std::string name_of(cases::TopFace top);
std::string name_of(Program program);
std::string name_of(Twin twin);
std::string name_of(Flaw flaw);
std::string name_of(Path path);

} // namespace asperity::robustness
