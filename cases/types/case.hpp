#pragma once

// A case after it has been read: plain data in SI units, independent of TOML.
// Defines the types that all other modules use.

#include "cases/types/block_spec.hpp"
#include "cases/types/methods.hpp"
#include "cases/types/quantity.hpp"
#include "cases/types/studies.hpp"

#include <cstdint>
#include <optional>
#include <string>
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
/// Formats of map files; `convert` is any other one, through the program
/// Gwyddion.
enum class MapFormat {
  automatic,
  plain,
  gwyddion,
  xyz,
  sdf,
  x3p,
  npy,
  hdf5,
  gwy,
  convert
};
enum class Levelling { none, plane, bow, sphere, cylinder };
enum class LineAlignment { none, median };
enum class Filling { harmonic, none };
enum class Edges { periodic, window, mirror, free };

/// Part of a measured map [m]: distances of its corner from the first column
/// and row, and its sides.
struct MapWindow {
  double x = 0.0;
  double y = 0.0;
  double length_x = 0.0;
  double length_y = 0.0;
};

/// [surface]. Lengths [m], wavevectors [rad/m]. Members that a kind does not
/// use stay empty: the length and points of a measured map come from its file.
struct SurfaceSpec {
  SurfaceKind kind = SurfaceKind::self_affine;
  std::optional<double> length; ///< side of the periodic square > 0
  std::optional<int> points;    ///< nodes per side, even, >= 4
  std::uint64_t seed = 0;
  int realizations = 1;
  Amplitudes amplitudes = Amplitudes::spectrum;
  bool rescale = false; ///< scale each realisation exactly to the prescribed
                        ///< rms value

  std::optional<double> rms_height; ///< of the complete spectrum
  std::optional<double> rms_slope;
  double hurst = 0.0;               ///< 0..1
  double wavevector_low = 0.0;      ///< q_L
  double wavevector_roll_off = 0.0; ///< q_0, q_L <= q_0 <= q_1
  double wavevector_high = 0.0;     ///< q_1

  std::string file; ///< path of the map or spectrum, made absolute or
                    ///< relative to the working directory by the reader
  MapFormat format = MapFormat::automatic;
  Levelling level = Levelling::plane;
  Edges edges = Edges::periodic; ///< free: half-spaces have free boundaries,
                                 ///< and the surface of all other methods is
                                 ///< continued, a map by its mirror images
  std::optional<double> height_unit; ///< m per unit of the numbers in a plain
                                     ///< file

  std::optional<std::string> channel; ///< title, or path of a dataset
  std::optional<double> length_y;     ///< period in y > 0; empty: square pixels
  std::optional<double> length_unit;  ///< m per unit of x and y of a list
  std::optional<MapWindow> crop;      ///< part of the map that is used
  LineAlignment align_lines = LineAlignment::none;
  std::optional<double> spikes;     ///< threshold in robust standard deviations
  Filling fill = Filling::harmonic; ///< of missing points
  double max_missing = 0.05;        ///< largest fraction that is filled

  double radius = 0.0;     ///< sphere
  double amplitude = 0.0;  ///< waves
  double wavelength = 0.0; ///< waves; length is an integer multiple of it
};

/// [material]: a block in contact with a rigid counter-surface, or two elastic
/// bodies reduced to one: 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
struct MaterialSpec {
  double contact_modulus = 0.0;        ///< E* [Pa] > 0, of the pair
  std::optional<double> poisson_ratio; ///< of the block, -1 < nu < 0.5

  std::optional<BodyModuli> counter = {}; ///< the second body, which E*
                                          ///< includes
  std::vector<MaterialLayer> layers = {};
  std::optional<MaterialInclusion> inclusion = {};
  std::optional<MaterialVariation> variation = {};

  /// Returns true if modulus and Poisson's ratio are uniform, as theory,
  /// half-space and atoms assume.
  bool is_uniform() const { return layers.empty() && !inclusion && !variation; }

  /// Returns E = E* (1 - nu^2) [Pa], Young's modulus of the single block that
  /// is equivalent to the pair. Needs poisson_ratio.
  double block_youngs_modulus() const;

  /// Returns the moduli of the first of two bodies, obtained from E* by
  /// removing the contribution of the second body; without a second body, those
  /// of the single block. Needs poisson_ratio.
  BodyModuli first_body() const;
};

enum class Control { nominal_pressure, mean_gap };

/// [load]: the loading path as steps in the order in which they run. A cycle
/// "load-unload" is expanded; is_unloading[i] marks the unloading steps.
struct LoadingPath {
  Control control = Control::nominal_pressure;
  std::vector<Quantity> targets; ///< p_0 [Pa] or mean gap [m] per step
  std::vector<bool> is_unloading;
};

/// [report]: what a result contains besides the curves.
struct ReportSpec {
  /// Number of load steps, spread over the loading path, whose pressure and gap
  /// maps (of realisation 0) are saved.
  int fields = 3;
  /// Compute the subsurface stress for each saved pressure map.
  bool stress_inside = false;
  /// Write the solution of the full block for ParaView at each step whose
  /// fields are saved.
  bool vtu = false;
};

/// One entry of [expect]: the quantity must lie in low..high for each method.
struct Expectation {
  std::string quantity; ///< one of expectation_names(), or one at a load
  double low = 0.0;
  double high = 0.0;
  std::vector<std::string> methods; ///< names of methods of this case
  /// Whether a value whose 95 % interval crosses a limit of the band counts as
  /// passed.
  bool passes_if_undecided = false;
};

struct Case {
  std::string path; ///< as given by the user, for messages
  std::string text; ///< the file byte for byte, then one line
                    ///< "#--set key=value" per override; reading it again
                    ///< gives the same case
  std::string name; ///< from the folder or file, e.g. "polymer"
  std::string title;
  SurfaceSpec surface;
  MaterialSpec material;
  MeshSpec mesh;
  LoadingPath load;
  std::vector<MethodSpec> methods; ///< theory, halfspace, fem, md, then
                                   ///< variants
  std::optional<MagnificationStudy> magnification_study;
  std::optional<AdhesionStudy> adhesion_study;
  ReportSpec report;
  std::vector<Expectation> expectations;
};

/// Returns the theory that evaluates the studies: the first one that uses the
/// formula of the spectrum; null if there is none.
const MethodSpec* study_theory(const std::vector<MethodSpec>& methods);

} // namespace asperity::cases
